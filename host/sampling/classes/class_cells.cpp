#include "host/sampling/classes/class_cells.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/torus.hpp"
#include "host/sampling/cells/cell_hierarchy.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

namespace poissonlab {
namespace {

/// The least whole number whose square is no less.
std::uint64_t square_root_above(std::uint64_t squared)
{
    auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(squared)));
    // No square of a number above 2^32 - 1 fits; the root of the largest value is 2^32.
    root = std::min<std::uint64_t>(root, UINT32_MAX);
    while (root > 0 && root * root >= squared) --root;
    while (root <= UINT32_MAX && root * root < squared) ++root;
    return root;
}

/// The level of cells that are about as wide as a distance, and no wider.
std::uint32_t level_of(double distance)
{
    return static_cast<std::uint32_t>(std::clamp(std::ceil(std::log2(1 / distance)), 1.0, 30.0));
}

}

OpenCells cells_in_region(const FixedRegion& region, std::uint32_t level)
{
    OpenCells open{1, {0, 0}};
    while (open.level < level) {
        std::vector<std::uint32_t> kept(open.count(2));
        const std::uint32_t below = open.level + 1, extent = (1u << (32 - below)) - 1;
        for (std::size_t i = 0; i < kept.size(); ++i)
            for (std::uint32_t child = 0; child < 4; ++child) {
                FixedBox box;
                for (std::size_t k = 0; k < 2; ++k) {
                    box.low[k] = (2 * open.cells[2 * i + k] + (child >> k & 1)) << (32 - below);
                    box.high[k] = box.low[k] + extent;
                }
                if (region.side_of(box) != RegionSide::outside) kept[i] |= 1u << child;
            }
        open = refined(open, kept, 2, below);
    }
    return open;
}

namespace {

/// A square whose sides are no longer than a distance holds at most four points that keep this distance.
constexpr std::size_t most_points_of_cell = 4;

std::size_t most_points_of(const ClassDartRequest& request, std::size_t i)
{
    if (!request.points.empty()) return request.points[i];
    const double distance = request.distances.at(i, i);
    const std::size_t most = packing_bound(distance, request.dimension);
    if (!request.region) return most;
    return std::min(most, most_points_of_cell * cells_in_region(*request.region, level_of(distance)).count(2));
}

/// Returns how many times larger the torus is than the region, up to a limit: a grid of the whole torus has this number
/// of cells for each point.
double tori_for_region(const ClassDartRequest& request)
{
    constexpr double most = 16;
    if (!request.region) return 1;
    const double side = request.region->unit() * 0x1p32;
    return std::min(most, side * side / request.region->area());
}

/// The largest distance that a class keeps from another, or its own points from each other.
double largest_of(const ClassDistances& distances, std::size_t own)
{
    double largest = 0;
    for (std::size_t i = 0; i < distances.classes(); ++i) largest = std::max(largest, distances.at(own, i));
    return largest;
}

OpenCells whole_torus(int dimension) { return {0, std::vector<std::uint32_t>(static_cast<std::size_t>(dimension))}; }

}

FillOrder::FillOrder(std::vector<double> shares, std::vector<std::size_t> ends)
    : shares_(std::move(shares)), ends_(std::move(ends)), counts_(shares_.size()), is_closed_(shares_.size())
{}

std::optional<std::uint32_t> FillOrder::next() const
{
    std::optional<std::uint32_t> least;
    for (std::uint32_t i = 0; i < shares_.size(); ++i) {
        if (is_closed_[i] || (!ends_.empty() && counts_[i] == ends_[i])) continue;
        // Products, not quotients: whole numbers below 2^53 are compared exactly.
        if (!least ||
            static_cast<double>(counts_[i]) * shares_[*least] < static_cast<double>(counts_[*least]) * shares_[i])
            least = i;
    }
    return least;
}

void FillOrder::add(std::uint32_t to) { ++counts_[to]; }

void FillOrder::close(std::uint32_t full) { is_closed_[full] = true; }

OpenCells start_cells(const ClassPart& part, int dimension, const ClassDistances& distances, std::size_t own)
{
    if (!part.densities.empty()) return part.densities[own];
    if (!part.region) return whole_torus(dimension);
    return cells_in_region(*part.region, std::max(1u, first_level(distances, own) - 1));
}

std::uint32_t spread_of(const OpenCells& cells, std::size_t points)
{
    if (cells.masses.empty()) return 0;
    return 33 - static_cast<std::uint32_t>(std::bit_width(std::clamp<std::size_t>(points, 1, UINT32_MAX)));
}

std::uint32_t target_of(std::uint32_t own, std::size_t number, const StreamKey& stream)
{
    constexpr std::uint32_t golden = 0x9E3779B9; // of 2^32
    return static_cast<std::uint32_t>(number) * golden + philox({0, UINT32_MAX, own, 1}, stream)[0];
}

std::uint32_t first_level(const ClassDistances& distances, std::size_t own)
{
    return static_cast<std::uint32_t>(std::clamp(std::ceil(std::log2(2 / largest_of(distances, own))), 1.0, 31.0));
}

OpenCells all_cells(std::uint32_t level, int dimension)
{
    const std::size_t side = std::size_t{1} << level;
    OpenCells all{level, {}};
    all.cells.reserve(lattice_cells(side, dimension) * static_cast<std::size_t>(dimension));
    for (std::size_t i = 0; i < lattice_cells(side, dimension); ++i)
        for (int k = 0; k < dimension; ++k)
            all.cells.push_back(static_cast<std::uint32_t>(i >> static_cast<std::uint32_t>(k) * level & (side - 1)));
    return all;
}

OpenCells refined(const OpenCells& parents, const std::vector<std::uint32_t>& kept, int dimension, std::uint32_t level)
{
    const auto axes = static_cast<std::size_t>(dimension);
    const bool is_split = parents.level < level;
    OpenCells open{level, {}};
    const bool has_density = !parents.masses.empty();
    for (std::size_t i = 0; i < parents.count(dimension); ++i)
        for (std::uint32_t bits = kept[i]; bits != 0; bits &= bits - 1) {
            const int child = std::countr_zero(bits);
            if (has_density) open.masses.push_back(std::ldexp(parents.masses[i], is_split ? -dimension : 0));
            for (std::size_t k = 0; k < axes; ++k) {
                const std::uint32_t cell = parents.cells[i * axes + k];
                open.cells.push_back(is_split ? 2 * cell + (static_cast<std::uint32_t>(child) >> k & 1) : cell);
            }
        }
    if (has_density) find_starts(open);
    return open;
}

void find_starts(OpenCells& cells)
{
    double sum = 0;
    std::vector<double> before;
    for (const double mass : cells.masses) {
        before.push_back(sum);
        sum += mass;
    }
    cells.starts.clear();
    for (const double start : before)
        cells.starts.push_back(static_cast<std::uint32_t>(std::min(start / sum * 0x1p32, 0x1p32 - 1)));
}

std::optional<std::uint32_t> level_after(const OpenCells& open, const ClassDistances& distances, std::size_t own,
                                         std::uint32_t failed, std::size_t count, std::size_t points)
{
    constexpr std::size_t most_looks = 64;
    const std::uint32_t below = std::min(open.level + 1, last_level);
    if (open.masses.empty() || failed > 1) return below;
    const bool is_too_soon = open.covered_at > 0 && (count - open.covered_at) * most_looks < points;
    if (failed == 1 || is_too_soon) return {};
    return open.level <= first_level(distances, own) ? below : open.level;
}

std::vector<contract::class_darts::ClassPair> class_pairs(const ClassDistances& distances,
                                                          const std::vector<double>& shares)
{
    std::vector<contract::class_darts::ClassPair> pairs;
    for (std::size_t i = 0; i < distances.classes(); ++i) {
        const auto first = static_cast<std::ptrdiff_t>(pairs.size());
        for (std::uint32_t j = 0; j < distances.classes(); ++j) {
            const std::uint64_t squared = squared_threshold(distances.at(i, j));
            pairs.push_back({.squared = squared, .reach = square_root_above(squared), .other = j, .unused = 0});
        }
        std::ranges::stable_sort(pairs.begin() + first, pairs.end(), std::greater{}, [&](const auto& pair) {
            return shares[pair.other] * std::pow(distances.at(i, pair.other), 2);
        });
    }
    return pairs;
}

ClassGrids class_grids(const ClassDartRequest& request)
{
    ClassGrids all;
    for (std::size_t i = 0; i < request.distances.classes(); ++i) {
        const double by_distance = std::floor(std::log2(1 / request.distances.at(i, i)));
        const double all_round = static_cast<double>(most_points_of(request, i)) * tori_for_region(request);
        const double by_count = std::ceil(std::log2(all_round) / request.dimension);
        const auto bits = static_cast<std::uint32_t>(std::clamp(std::min(by_distance, by_count), 0.0, 15.0));
        all.grids.push_back({.bits = bits, .first = static_cast<std::uint32_t>(all.cells)});
        all.cells += lattice_cells(std::size_t{1} << bits, request.dimension);
    }
    return all;
}

namespace {

/// Returns the cells of a level in the box that all points lie in.
contract::class_darts::CoveredCells cells_of_box(const ClassDartRequest& request, std::uint32_t level)
{
    contract::class_darts::CoveredCells grid{.level = level, .first = 0, .low = {}, .count = {}};
    for (std::size_t k = 0; k < static_cast<std::size_t>(request.dimension); ++k) {
        const std::uint32_t high = request.region ? request.region->extent().high[k] : UINT32_MAX;
        grid.low[k] = request.region ? request.region->extent().low[k] >> (32 - level) : 0;
        grid.count[k] = (high >> (32 - level)) - grid.low[k] + 1;
    }
    return grid;
}

double words_of(const contract::class_darts::CoveredCells& grid, int dimension)
{
    double words = (grid.count[0] + 31) / 32;
    for (int k = 1; k < dimension; ++k) words *= grid.count[k];
    return words;
}

}

CoveredGrids covered_grids(const ClassDartRequest& request)
{
    constexpr double words_a_point = 8, words_more = 64;
    // Kernels guess roots in single precision, so that cells must be wider than its errors.
    constexpr std::uint32_t most_level = 20;
    CoveredGrids all;
    for (std::size_t i = 0; i < request.distances.classes(); ++i) {
        const double most_words = words_more + words_a_point * static_cast<double>(most_points_of(request, i));
        // A point covers next to no cells that are wider than those of the first level. Disks of more than half a turn
        // meet themselves around the torus, which the bits do not know.
        const bool is_too_large = largest_of(request.distances, i) > 0.5;
        const std::uint32_t least_level = first_level(request.distances, i);
        contract::class_darts::CoveredCells grid{};
        for (std::uint32_t level = std::min(most_level, least_level + 1); level >= least_level && !is_too_large;
             --level) {
            grid = cells_of_box(request, level);
            if (words_of(grid, request.dimension) <= most_words) break;
            grid = {};
        }
        grid.first = static_cast<std::uint32_t>(all.words);
        if (grid.level > 0) all.words += static_cast<std::size_t>(words_of(grid, request.dimension));
        all.grids.push_back(grid);
    }
    return all;
}

std::size_t most_class_points(const ClassDartRequest& request)
{
    std::size_t sum = 0;
    for (std::size_t i = 0; i < request.distances.classes(); ++i) sum += most_points_of(request, i);
    return sum;
}

std::size_t part_count(const ClassDartRequest& request) { return std::max<std::size_t>(1, request.parts); }

ClassPart part_of(const ClassDartRequest& request, std::size_t part)
{
    return request.parts > 0 ? request.part_at(part) : ClassPart{request.region, request.shares, request.points, {}};
}

}
