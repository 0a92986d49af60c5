// A picture of how a Poisson tile set comes into being: the member "constructions" of results.json.
#pragma once

#include "results/pictures/construction_scene.hpp"

#include <cstddef>
#include <string>

namespace poissonlab {

class JsonMembers;

struct ConstructionResult
{
    std::string name; ///< its folder
    std::string label;
    std::string kind; ///< "corner", "edge", "template" or "sphere"
    std::string show;
    std::size_t colors = 0;
    std::size_t tiles = 0;
    std::size_t points_per_tile = 0;
    double relative_radius = 0;
    std::string filling;
    int lloyd_iterations = 0;
    bool repulsion = false;
    std::string seed; ///< a number
    std::string file; ///< the scene, relative to the run's folder
    SceneSummary scene;

    bool operator==(const ConstructionResult&) const = default;
};

void members(JsonMembers& m, const ConstructionResult& construction);
void members(JsonMembers& m, ConstructionResult& construction);

}
