// Points of several classes, each and all together even: what settings ask for, and what is measured.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010. See host/sampling/classes/class_darts.hpp.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/sampling/classes/class_darts.hpp"
#include "host/settings/distributions/class_config.hpp"
#include "results/pictures/distribution_result.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace poissonlab {

struct PoissonTileSet;

/// Sets of other numbers have other random numbers. Throws InputError for what the torus or memory has no room for.
ClassDartRequest class_dart_request(const ClassSettings& settings, std::uint64_t seed, std::uint32_t number = 0);

struct ClassSet
{
    ClassDartRequest request;
    ClassedPoints points;
    std::shared_ptr<const PoissonTileSet> tiles{}; ///< of a tiling
};

/// Throws the darts, or takes the points of a tiling. Throws InputError where a class is full before it has the points
/// that are asked for, and what tiled_classes() throws.
ClassSet throw_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                       std::uint32_t number = 0);

/// The least distance that was found for each pair of classes; infinite where there is none.
ClassDistances least_distances(const ClassedPoints& points);

/// Numbers of all classes, of each, and of each pair.
std::vector<DistributionNumber> class_numbers(const ClassSet& set);

/// Least distances of pairs beside those that are kept, as a table.
DistributionTable distance_table(const ClassSet& set);

}
