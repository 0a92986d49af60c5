// Models of plants as triangles with colours: sunflowers, and meshes of the user.
//
// Cohen, Shade, Hiller, Deussen, Wang tiles for image and texture generation, 2003, section 4: "eleven variations of a
// model of a sunflower". The article does not say what the model is.
#pragma once

#include "base/surfaces/triangle_mesh.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Red, green and blue as screens take them, from 0 to 1.
using ScreenColor = std::array<float, 3>;

/// A model that stands on the plane z = 0 at the origin and fits the cylinder of radius 1 around the z axis.
struct PlantModel
{
    std::vector<MeshPoint> places;
    std::vector<MeshPoint> normals;  ///< of vertices, of length 1
    std::vector<ScreenColor> colors; ///< of vertices, not lit yet
    std::vector<MeshTriangle> triangles;
    double height = 0; ///< of the highest vertex
};

/// Variations of a sunflower whose heads look along x. The first `count` of them do not depend on `count`.
std::vector<PlantModel> sunflower_models(std::uint32_t count);

/// A mesh as a model, green and moved and scaled to fit; z points upwards. Throws InputError for meshes without extent.
PlantModel plant_of_mesh(const TriangleMesh& mesh);

}
