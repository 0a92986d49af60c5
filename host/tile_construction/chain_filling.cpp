#include "host/tile_construction/chain_filling.hpp"

#include "base/random/random.hpp"
#include "host/tile_construction/fill_stages.hpp"
#include "host/tile_construction/joint/joint_relaxation.hpp"
#include "host/tile_construction/moments/equal_moments.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::uint32_t choices = 4000;
constexpr double reach = 0.7; ///< of offsets, in spacings

/// Frequencies looked at, in units of the square root of the points a tile: around the ring of a good distribution.
constexpr double lowest = 0.6, highest = 1.3;

/// One of each two opposite frequencies.
std::vector<TileFrequency> ring_frequencies(double root)
{
    std::vector<TileFrequency> frequencies;
    const auto most = static_cast<std::int32_t>(std::floor(highest * root));
    for (std::int32_t x = 0; x <= most; ++x)
        for (std::int32_t y = x == 0 ? 1 : -most; y <= most; ++y)
            if (const double length = std::hypot(x, y); length >= lowest * root && length <= highest * root)
                frequencies.push_back({x, y, 0});
    return frequencies;
}

/// Even units in the disk, by rejection; every try has its own random numbers.
UnitPosition offset_in_disk(const StreamKey& stream, std::uint32_t choice, std::uint32_t color, double radius)
{
    for (std::uint32_t attempt = 0;; ++attempt) {
        const auto words = philox({choice, color, attempt, 0}, stream);
        const double x = (words[0] * 0x1p-31 - 1) * radius, y = (words[1] * 0x1p-31 - 1) * radius;
        if (x * x + y * y <= radius * radius)
            return {2 * static_cast<std::int32_t>(x / 2), 2 * static_cast<std::int32_t>(y / 2), 0};
    }
}

double unevenness(const std::vector<UnitPosition>& offsets, const std::vector<TileFrequency>& ring)
{
    double sum = 0;
    for (const auto& frequency : ring) {
        std::complex<double> transform = 0;
        for (const UnitPosition& offset : offsets) transform += unit_circle()[phase_of(frequency, offset)];
        sum += std::norm(transform) * std::norm(transform);
    }
    return sum;
}

}

std::vector<UnitPosition> spread_corners(const PoissonTileParameters& parameters)
{
    std::vector<UnitPosition> best(parameters.colors, UnitPosition{});
    if (parameters.colors == 1) return best; // wherever it is, all corners are there
    const double root = std::sqrt(parameters.points_per_tile);
    const auto ring = ring_frequencies(root);
    const StreamKey stream = stream_key(parameters.seed, Purpose::chain_corners, 0);
    double least = unevenness(best, ring);
    for (std::uint32_t choice = 0; choice < choices; ++choice) {
        std::vector<UnitPosition> offsets;
        for (std::uint32_t color = 0; color < parameters.colors; ++color)
            offsets.push_back(offset_in_disk(stream, choice, color, reach * tile_units / root));
        const double found = unevenness(offsets, ring);
        if (found >= least) continue;
        least = found;
        best = offsets;
    }
    return best;
}

std::vector<UnitPosition> own_border_points(const ChainPieces& pieces, const PoissonTileParameters& p,
                                            std::uint32_t tile)
{
    const auto chains = chains_around(tile, p.colors);
    std::vector<UnitPosition> points{pieces.corners[chains.front().lower]};
    for (const PlacedChain& own : {chains.front(), chains.back()}) {
        const Chain& chain = pieces.chains[own.direction][own.number(p.colors)];
        points.insert(points.end(), chain.begin(), chain.end());
    }
    return points;
}

ChainFiller::Tiles ChainFiller::fill_anew(Tiles open, std::uint32_t stage_number, std::uint32_t round,
                                          const MomentTargets* moments)
{
    const std::size_t total = open.size();
    Tiles hopeless;
    std::erase_if(open, [&](std::uint32_t tile) {
        const bool has_room =
            interior_size(pieces_, tile, p_.points_per_tile) >= 0 && is_simple(border_polygon(pieces_, tile));
        if (!has_room) hopeless.push_back(tile);
        return !has_room;
    });
    for (std::uint32_t attempt = 0; attempt < patient_tile_attempts && !open.empty(); ++attempt) {
        std::vector<FillProblem> problems;
        for (const std::uint32_t tile : open) problems.push_back(problem_of(tile, moments));
        open = fill(open, problems, stage_number, round * attempts_a_round + attempt, moments);
        if (options_.progress) options_.progress("tiles", total - open.size(), total);
    }
    open.insert(open.end(), hopeless.begin(), hopeless.end());
    std::ranges::sort(open);
    return open;
}

ChainFiller::Tiles ChainFiller::repel(const Tiles& open, const MomentTargets* moments)
{
    Tiles failed, possible;
    std::vector<FillProblem> problems;
    for (const std::uint32_t tile : open) {
        const auto border = border_polygon(pieces_, tile);
        const auto is_inside = [&](const UnitPosition& point) { return is_strictly_inside(border, point); };
        if (!is_simple(border) || !std::ranges::all_of(pieces_.interiors[tile], is_inside)) {
            failed.push_back(tile);
            continue;
        }
        possible.push_back(tile);
        problems.push_back(problem_of(tile, moments));
        for (const UnitPosition& point : pieces_.interiors[tile])
            problems.back().given.push_back({wrapped(point[0]), wrapped(point[1]), 0});
    }
    const Tiles left = fill(possible, problems, repair_stage, 0, moments);
    failed.insert(failed.end(), left.begin(), left.end());
    std::ranges::sort(failed);
    return failed;
}

FillProblem ChainFiller::problem_of(std::uint32_t tile, const MomentTargets* moments) const
{
    FillProblem problem;
    for (const UnitPosition& point : border_polygon(pieces_, tile))
        problem.held.push_back({wrapped(point[0]), wrapped(point[1]), 0});
    problem.active = static_cast<std::uint32_t>(interior_size(pieces_, tile, p_.points_per_tile));
    problem.stream = tile;
    if (moments) problem.moments = moments->left_in_units(own_border_points(pieces_, p_, tile));
    return problem;
}

ChainFiller::Tiles ChainFiller::fill(const Tiles& tiles, const std::vector<FillProblem>& problems,
                                     std::uint32_t stage_number, std::uint32_t attempt, const MomentTargets* moments)
{
    FillStage stage{.regions = regions_of(p_), .number = stage_number};
    stage.active = {0, -tile_units / 2, torus_units};
    stage.in_polygon = true;
    stage.equal_moments = moments ? moments->order() : 0;
    const std::vector<FilledTorus> filled = interiors_.fill(stage, problems, attempt);
    report_.tori += filled.size();
    Tiles failed;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const bool is_good = filled[i].active.size() == problems[i].active &&
                             (problems[i].active == 0 || filled[i].squared_min_distance >= wanted_);
        if (!is_good) {
            ++report_.failures;
            failed.push_back(tiles[i]);
            continue;
        }
        auto& interior = pieces_.interiors[tiles[i]];
        interior.clear();
        for (const TilePosition& point : filled[i].active) {
            constexpr std::int32_t middle = tile_units / 2;
            interior.push_back(
                {storable(shortest(point[0] - middle) + middle), storable(shortest(point[1] - middle) + middle), 0});
        }
    }
    return failed;
}

}
