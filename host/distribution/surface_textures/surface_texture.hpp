// This lays textures on surfaces of quads, by generalised Wang tiles and corner tiles, and objects of section 7.6.
#pragma once

#include "host/distribution/surface_textures/quad_atlas.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/settings/distributions/quad_config.hpp"
#include "host/settings/keys/choices.hpp"
#include "host/texture/quads/quad_texture.hpp"
#include "results/pictures/distribution_result.hpp"

#include <string>
#include <vector>

namespace poissonlab {

inline constexpr std::uint32_t default_quad_picture_pixels = 1400;

struct SurfaceTextureSettings
{
    QuadSettings quads;
    std::filesystem::path exemplar, normals, heights;
    double relief = 4; ///< pixels
    QuadLabels labels = QuadLabels::wang;
    std::uint32_t colors = 2;
    int size = 64;
    int candidates = 8;
};

struct SurfaceObjectSettings
{
    QuadSettings quads;
    int dimension = 2;           ///< 3: the surface is cut out of a solid that objects fill
    std::filesystem::path tiles; ///< of a solid; empty: sphere tiles of 2 colours, 128 points
    std::size_t points = 2000;
    std::string object = "dots";
    int texels = 32; ///< along a side of a quad
    SpreadChoice size{.a = 1}, orientation{}, aspect{.a = 1};
};

/// A dressed surface has a picture on its quads, and numbers that were measured of both.
struct DressedSurface
{
    std::shared_ptr<const QuadSurface> surface;
    QuadAtlas atlas;
    std::vector<DistributionNumber> numbers;
    std::vector<std::string> facts;
};

DressedSurface textured_surface(const SurfaceTextureSettings& settings, std::uint64_t seed,
                                const DistributionPlace& place);
DressedSurface surface_of_objects(const SurfaceObjectSettings& settings, std::uint64_t seed,
                                  const DistributionPlace& place);

/// Writes the picture of a surface, or its file of glTF, by the end of the name.
void write_dressed(const std::filesystem::path& file, const DressedSurface& dressed, int pixels);

}
