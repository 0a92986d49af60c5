#include "tiles/prototiles/substitution.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

/// What tiles that coincide have in common.
using TileShapeKey = std::pair<std::size_t, std::vector<RingPlace>>;

TileShapeKey shape_key(const PolygonTiling& tiling, const PlacedTile& tile)
{
    std::vector<RingPlace> corners = corners_of(tiling, tile);
    std::ranges::sort(corners);
    return {tile.prototile, std::move(corners)};
}

/// Walks from tiles to their parts, and keeps those of the last level.
class SubstitutionWalk
{
public:
    SubstitutionWalk(const PolygonTiling& tiling, int depth, std::size_t most)
        : tiling_(tiling), depth_(static_cast<std::size_t>(depth)), most_(most)
    {}

    /// `enters` says whether to look at a tile of a level, `part` divides one.
    void walk(const PlacedTile& tile, TileAddress& address, const auto& enters, const auto& part)
    {
        const std::size_t level = address.size() - 1;
        if (!enters(tile, level)) return;
        if (level == depth_) return keep(tile, address);
        for (std::size_t i = 0; i < tiling_.parts[tile.prototile].size(); ++i) {
            address.push_back(static_cast<std::uint32_t>(i));
            walk(part(tile, i), address, enters, part);
            address.pop_back();
        }
    }

    std::vector<AddressedTile> take() { return std::move(found_); }

private:
    void keep(const PlacedTile& tile, const TileAddress& address)
    {
        if (found_.size() % 1024 == 0) stop_if_interrupted();
        if (!known_.insert(shape_key(tiling_, tile)).second) return;
        if (found_.size() == most_) throw InputError(fmt::format("there are more than {} tiles", most_));
        found_.push_back({tile, address});
    }

    const PolygonTiling& tiling_;
    std::size_t depth_, most_;
    std::set<TileShapeKey> known_;
    std::vector<AddressedTile> found_;
};

}

std::optional<RingPlace> turn_of_magnification(const RootRing& ring, const RingPlace& magnification)
{
    const RingPlace conjugate = ring.conjugate(magnification);
    for (int k = 0; k < ring.order(); ++k)
        if (ring.times(ring.unit(k), conjugate) == magnification) return ring.unit(k);
    return std::nullopt;
}

Substitution::Substitution(const PolygonTiling& tiling, std::size_t start)
    : tiling_(tiling), start_(tiling.starts.at(start)),
      mirrored_turn_(turn_of_magnification(tiling.ring, tiling.magnification).value()), reach_(reach_beyond_parts())
{}

/// The radius around a tile's place that its corners and all its parts' parts stay in: a part's place is at most so far
/// away, and the part's own reach is smaller by a factor.
double Substitution::reach_beyond_parts() const
{
    const double factor = tiling_.ring.sizes(tiling_.magnification)[0];
    double corners = 0, away = 0;
    for (const Prototile& prototile : tiling_.prototiles)
        for (const RingPlace& corner : prototile.corners) corners = std::max(corners, tiling_.ring.sizes(corner)[0]);
    double scale = 0;
    for (const auto& parts : tiling_.parts)
        for (const PlacedTile& part : parts) {
            away = std::max(away, tiling_.ring.sizes(part.motion.at)[0]);
            scale = std::max(scale, scale_of(tiling_.ring, part.motion));
        }
    return std::max(corners, away / (factor - scale));
}

PlacedTile Substitution::part_of(const PlacedTile& whole, std::size_t index) const
{
    const RootRing& ring = tiling_.ring;
    const PlacedTile& part = tiling_.parts[whole.prototile][index];
    RingPlace at = part.motion.at, turn = part.motion.turn;
    if (whole.motion.is_mirrored) {
        at = ring.times(mirrored_turn_, ring.conjugate(at));
        turn = ring.times(mirrored_turn_, ring.conjugate(turn));
    }
    return {part.prototile,
            {ring.times(tiling_.magnification, whole.motion.at) + ring.times(whole.motion.turn, at),
             ring.times(whole.motion.turn, turn), whole.motion.is_mirrored != part.motion.is_mirrored}};
}

std::optional<std::vector<std::uint64_t>> Substitution::counts(int depth, std::uint64_t most) const
{
    std::vector<std::uint64_t> counts(tiling_.prototiles.size());
    for (const PlacedTile& tile : start_.tiles) ++counts[tile.prototile];
    for (int level = 0; level < depth; ++level) {
        std::vector<std::uint64_t> next(counts.size());
        std::uint64_t all = 0;
        for (std::size_t i = 0; i < counts.size(); ++i)
            for (const PlacedTile& part : tiling_.parts[i]) next[part.prototile] += counts[i], all += counts[i];
        if (all > most) return std::nullopt;
        counts = std::move(next);
    }
    return counts;
}

int Substitution::deepest() const
{
    constexpr double largest = 0x1p60; // integers are at most twice as large as their numbers, see RootRing::sizes()
    constexpr int most_levels = 200;
    const RootRing& ring = tiling_.ring;
    const auto larger = [&](std::array<double, 2>& sizes, const RingPlace& place) {
        for (std::size_t i = 0; i < 2; ++i) sizes[i] = std::max(sizes[i], ring.sizes(place)[i]);
    };
    std::array<double, 2> place{}, turn{}, part{}, part_turn{}, corner{};
    for (const PlacedTile& tile : start_.tiles) larger(place, tile.motion.at), larger(turn, tile.motion.turn);
    for (const auto& parts : tiling_.parts)
        for (const PlacedTile& tile : parts) larger(part, tile.motion.at), larger(part_turn, tile.motion.turn);
    for (const Prototile& prototile : tiling_.prototiles)
        for (const RingPlace& c : prototile.corners) larger(corner, c);
    const std::array<double, 2> factor = ring.sizes(tiling_.magnification);
    for (int depth = 0; depth < most_levels; ++depth)
        for (std::size_t i = 0; i < 2; ++i) {
            place[i] = factor[i] * place[i] + turn[i] * part[i];
            turn[i] *= part_turn[i];
            if (place[i] + turn[i] * corner[i] > largest) return depth;
        }
    return most_levels;
}

PlacedTile Substitution::tile_at(const TileAddress& address) const
{
    const auto refused = [](std::size_t place, std::uint32_t number, std::size_t count) {
        return InputError(fmt::format("number {} is {}: must be from 0 to {}", place + 1, number, count - 1));
    };
    if (address.at(0) >= start_.tiles.size()) throw refused(0, address[0], start_.tiles.size());
    PlacedTile tile = start_.tiles[address[0]];
    for (std::size_t i = 1; i < address.size(); ++i) {
        const std::size_t count = tiling_.parts[tile.prototile].size();
        if (address[i] >= count) throw refused(i, address[i], count);
        tile = part_of(tile, address[i]);
    }
    return tile;
}

std::vector<AddressedTile> Substitution::tiles(int depth, std::size_t most) const
{
    SubstitutionWalk walk(tiling_, depth, most);
    const auto part = [&](const PlacedTile& tile, std::size_t index) { return part_of(tile, index); };
    for (std::size_t i = 0; i < start_.tiles.size(); ++i) {
        TileAddress address{static_cast<std::uint32_t>(i)};
        walk.walk(
            start_.tiles[i], address, [](const PlacedTile&, std::size_t) { return true; }, part);
    }
    return walk.take();
}

std::vector<AddressedTile> Substitution::tiles_near(int depth, const RingPlace& middle, double radius,
                                                    std::size_t most) const
{
    const RootRing& ring = tiling_.ring;
    const auto levels = static_cast<std::size_t>(depth);
    std::vector<RingPlace> powers{RingPlace{{1, 0, 0, 0}}}; // of the magnification
    for (std::size_t i = 0; i < levels; ++i) powers.push_back(ring.times(powers.back(), tiling_.magnification));
    TileAddress first(levels + 1);
    const double unit = scale_of(ring, tile_at(first).motion); // all tiles of a level have one scale
    // The distance is a difference of exact places, so that it is right however far away from the origin both are.
    const auto is_near = [&](const PlacedTile& tile, std::size_t level) {
        const RingPlace& power = powers[levels - level];
        const double away = ring.sizes(ring.times(power, tile.motion.at) - middle)[0];
        return away <= radius * unit + reach_ * scale_of(ring, tile.motion) * ring.sizes(power)[0];
    };
    SubstitutionWalk walk(tiling_, depth, most);
    const auto part = [&](const PlacedTile& tile, std::size_t index) { return part_of(tile, index); };
    for (std::size_t i = 0; i < start_.tiles.size(); ++i) {
        TileAddress address{static_cast<std::uint32_t>(i)};
        walk.walk(start_.tiles[i], address, is_near, part);
    }
    return walk.take();
}

}
