#include "tiles/poisson/proof/class_certificate.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/proof/shared_pieces.hpp"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace poissonlab {
namespace {

/// The pieces of the points of one class.
struct ClassPieces
{
    ClassPieces(const PoissonTileSet& set, std::uint32_t of)
        : subset(class_subset(set, of)), pieces(subset, regions_of(set.parameters)),
          extents(piece_extents(subset, pieces))
    {}

    PoissonTileSet subset;
    SharedPieces pieces;
    std::vector<Extents> extents;
};

std::uint64_t squared_distance(const UnitPosition& a, const UnitPosition& b)
{
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t difference = std::int64_t{a[k]} - b[k];
        sum += static_cast<std::uint64_t>(difference * difference);
    }
    return sum;
}

struct Nearest
{
    std::uint64_t squared = std::numeric_limits<std::uint64_t>::max();
    std::array<UnitPosition, 2> points = {};
    std::uint32_t tile = 0;
};

/// The nearest two points of one list and another, both by rising x; where they are the same list, of different points.
Nearest nearest_of(std::span<const UnitPosition> one, std::span<const UnitPosition> other)
{
    const bool are_same = one.data() == other.data();
    Nearest nearest;
    std::size_t begin = 0; // of those that may be near enough along x
    for (std::size_t i = 0; i < one.size(); ++i) {
        const auto along = [&](std::size_t j) { return std::int64_t{other[j][0]} - one[i][0]; };
        const auto is_far = [&](std::size_t j) {
            return static_cast<std::uint64_t>(along(j) * along(j)) >= nearest.squared;
        };
        while (begin < other.size() && along(begin) < 0 && is_far(begin)) ++begin;
        for (std::size_t j = are_same ? i + 1 : begin; j < other.size(); ++j) {
            if (along(j) > 0 && is_far(j)) break;
            const std::uint64_t squared = squared_distance(one[i], other[j]);
            if (squared < nearest.squared) nearest = {squared, {one[i], other[j]}, 0};
        }
    }
    return nearest;
}

/// The nearest points of each pair of classes in the closure of a tile.
std::vector<Nearest> nearest_in_closure(const std::vector<ClassPieces>& classes, std::uint32_t tile)
{
    std::vector<std::vector<UnitPosition>> closures(classes.size());
    std::vector<Nearest> nearest(class_pair_count(classes.size()));
    for (std::size_t j = 0; j < classes.size(); ++j) {
        classes[j].pieces.closure(tile, closures[j]);
        std::ranges::sort(closures[j]);
        for (std::size_t i = 0; i <= j; ++i) nearest[class_pair(i, j)] = nearest_of(closures[i], closures[j]);
    }
    for (Nearest& pair : nearest) pair.tile = tile;
    return nearest;
}

/// The nearer of each two pairs; of the same distance, the first one's.
std::vector<Nearest> nearer_of(std::vector<Nearest> first, const std::vector<Nearest>& second)
{
    for (std::size_t pair = 0; pair < first.size(); ++pair)
        if (second[pair].squared < first[pair].squared) first[pair] = second[pair];
    return first;
}

/// The nearest points of each pair of classes in all closures; of the same distance, those of the first tile.
std::vector<Nearest> nearest_of_all(const std::vector<ClassPieces>& classes, std::uint32_t tiles)
{
    using Range = tbb::blocked_range<std::uint32_t>;
    return tbb::parallel_reduce(
        Range(0, tiles), std::vector<Nearest>(class_pair_count(classes.size())),
        [&](const Range& range, std::vector<Nearest> nearest) {
            for (std::uint32_t tile = range.begin(); tile < range.end(); ++tile)
                nearest = nearer_of(std::move(nearest), nearest_in_closure(classes, tile));
            return nearest;
        },
        nearer_of);
}

std::vector<ClassPieces> pieces_of_classes(const PoissonTileSet& set)
{
    std::vector<ClassPieces> classes;
    classes.reserve(set.parameters.classes.count()); // pieces refer to their sets
    for (std::uint32_t i = 0; i < set.parameters.classes.count(); ++i) {
        try {
            classes.emplace_back(set, i);
        } catch (const InputError& error) {
            throw InputError(fmt::format("class {}: {}", i, error.what()));
        }
    }
    return classes;
}

}

std::vector<ClassPairProof> certify_classes(const PoissonTileSet& set)
{
    const std::vector<ClassPieces> classes = pieces_of_classes(set);
    if (classes.empty()) return {};
    const std::vector<Nearest> nearest = nearest_of_all(classes, set.parameters.tiles);
    std::vector<ClassPairProof> proofs;
    for (std::size_t j = 0; j < classes.size(); ++j)
        for (std::size_t i = 0; i <= j; ++i) {
            const Nearest& found = nearest[class_pair(i, j)];
            ClassPairProof proof{.squared_closure_distance = found.squared,
                                 .squared_separation = squared_separation(classes[i].extents, classes[j].extents,
                                                                          set.parameters.dimension),
                                 .tile = found.tile,
                                 .points = found.points};
            proof.squared_min_distance = std::min(proof.squared_closure_distance, proof.squared_separation);
            proofs.push_back(proof);
        }
    return proofs;
}

void check_class_promises(const TileClasses& classes, const std::vector<std::uint64_t>& stated,
                          const std::vector<ClassPairProof>& proofs)
{
    for (std::size_t j = 0; j < classes.count(); ++j)
        for (std::size_t i = 0; i <= j; ++i) {
            const std::size_t pair = class_pair(i, j);
            const ClassPairProof& proof = proofs[pair];
            const std::uint64_t promised = std::max(squared_units(classes.distances.at(i, j)), stated[pair]);
            if (promised <= proof.squared_min_distance) continue;
            // Where regions are nearer than any two points that are seen together, there are no points to name.
            const std::string points =
                proof.squared_min_distance < proof.squared_closure_distance
                    ? ""
                    : fmt::format(": see the points at ({}, {}) and ({}, {}) of tile {}", proof.points[0][0],
                                  proof.points[0][1], proof.points[1][0], proof.points[1][1], proof.tile);
            throw InputError(fmt::format("classes {} and {}: promises a squared distance of {}: must be at most {}, "
                                         "which is proven{}",
                                         i, j, promised, proof.squared_min_distance, points));
        }
}

}
