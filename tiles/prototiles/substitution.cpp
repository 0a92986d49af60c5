#include "tiles/prototiles/substitution.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace poissonlab {
namespace {

/// The properties that tiles that coincide have in common.
using TileShapeKey = std::pair<std::size_t, std::vector<RingPlace>>;

TileShapeKey shape_key(const PolygonTiling& tiling, const PlacedTile& tile)
{
    std::vector<RingPlace> corners = corners_of(tiling, tile);
    std::ranges::sort(corners);
    return {tile.prototile, std::move(corners)};
}

/// True if a place lies in a tile or on its border. Differences of places are exact, so that near places are not
/// rounded.
bool lies_in(const PolygonTiling& tiling, const PlacedTile& tile, const RingPlace& place)
{
    constexpr double rounding = 1e-9;
    const std::vector<RingPlace> corners = corners_of(tiling, tile);
    bool is_inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto a = point_of(tiling, corners[i] - place);
        const auto b = point_of(tiling, corners[(i + 1) % corners.size()] - place);
        const double cross = a[0] * b[1] - a[1] * b[0], dot = a[0] * b[0] + a[1] * b[1];
        if (std::abs(cross) <= rounding * std::hypot(b[0] - a[0], b[1] - a[1]) && dot <= rounding) return true;
        if ((a[1] > 0) != (b[1] > 0) && (cross > 0) == (b[1] > a[1])) is_inside = !is_inside;
    }
    return is_inside;
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

bool is_multiplication(const RootRing& ring, const RingMap& map)
{
    return map.of_root == ring.times(ring.unit(1), map.of_one);
}

std::optional<RingPlace> turn_of_magnification(const RootRing& ring, const RingMap& magnification)
{
    if (!is_multiplication(ring, magnification)) return ring.unit(0);
    const RingPlace conjugate = ring.conjugate(magnification.of_one);
    for (int k = 0; k < ring.order(); ++k)
        if (ring.times(ring.unit(k), conjugate) == magnification.of_one) return ring.unit(k);
    return std::nullopt;
}

Substitution::Substitution(const PolygonTiling& tiling, std::size_t start)
    : tiling_(tiling), start_(tiling.starts.at(start)),
      mirrored_turn_(turn_of_magnification(tiling.ring, tiling.magnification).value())
{
    // One value suffices. It matters only for maps that are no multiplication, where either all parts that have parts
    // are mirrored or none is; a multiplication has one map for mirrored and other tiles.
    for (const auto& parts : tiling.parts)
        for (const PlacedTile& part : parts) flips_ |= part.motion.is_mirrored && !tiling.parts[part.prototile].empty();
    add_levels();
}

std::array<double, 3> Substitution::sizes(const RingPlace& place) const
{
    const auto point = point_of(tiling_, place);
    const auto planes = tiling_.ring.sizes(place);
    return {std::hypot(point[0], point[1]), planes[0], planes[1]};
}

void Substitution::add_levels()
{
    constexpr std::size_t most_levels = 200;
    Level none;
    for (const Prototile& prototile : tiling_.prototiles)
        for (const RingPlace& corner : prototile.corners)
            for (std::size_t i = 0; i < 3; ++i) none.reach[i] = std::max(none.reach[i], sizes(corner)[i]);
    levels_.push_back(none);
    while (levels_.size() <= most_levels) {
        try {
            const Level next = next_level();
            if (!fits(next)) return;
            levels_.push_back(next);
        } catch (const InputError&) {
            return; // an integer needs more than 64 bits
        }
    }
}

/// Returns the level after the last one: a division comes first, and the divisions of the last level follow. These
/// enlarge the places of the parts and decide how far the parts reach.
Substitution::Level Substitution::next_level() const
{
    const RootRing& ring = tiling_.ring;
    const Level& last = levels_.back();
    Level next;
    for (const bool is_mirrored : {false, true}) {
        // For mirrored tiles the map is between two mirrors, and a turn follows, as in part_of().
        const auto mirrored = [&](const RingPlace& place) { return is_mirrored ? ring.conjugate(place) : place; };
        const auto image = [&](const RingPlace& place) {
            const RingPlace there = mirrored(mapped(ring, tiling_.magnification, mirrored(place)));
            return mapped(ring, last.maps[is_mirrored != flips_],
                          is_mirrored ? ring.times(mirrored_turn_, there) : there);
        };
        next.maps[is_mirrored] = {image(ring.unit(0)), image(ring.unit(1))};
    }
    for (const auto& parts : tiling_.parts)
        for (const PlacedTile& part : parts) {
            const auto at = sizes(mapped(ring, last.maps[part.motion.is_mirrored], part.motion.at));
            const auto turn = ring.sizes(part.motion.turn);
            for (std::size_t i = 0; i < 3; ++i)
                next.reach[i] = std::max(next.reach[i], at[i] + turn[i / 2] * last.reach[i]);
        }
    return next;
}

/// True if all places of a level fit into 64-bit integers.
bool Substitution::fits(const Level& level) const
{
    constexpr double largest = 0x1p60; // integers are at most twice as large as their numbers, see RootRing::sizes()
    return std::ranges::all_of(start_.tiles, [&](const PlacedTile& tile) {
        const auto at = sizes(mapped(tiling_.ring, level.maps[tile.motion.is_mirrored], tile.motion.at));
        const auto turn = tiling_.ring.sizes(tile.motion.turn);
        return at[1] + turn[0] * level.reach[1] <= largest && at[2] + turn[1] * level.reach[2] <= largest;
    });
}

double Substitution::inflation() const
{
    const RootRing& ring = tiling_.ring;
    if (is_multiplication(ring, tiling_.magnification))
        return ring.sizes(tiling_.magnification.of_one)[0] / scale_of(ring, tiling_.parts[0][0].motion);
    // Two levels are compared, because mirrored levels may alternate. The error falls by the square of the inflation
    // with each level.
    if (levels_.size() < 3) return 0;
    const auto size = [&](const Level& level) { return sizes(level.maps[0].of_one)[0]; };
    return std::sqrt(size(levels_.back()) / size(levels_[levels_.size() - 3]));
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
            {mapped(ring, levels_.at(1).maps[whole.motion.is_mirrored], whole.motion.at) +
                 ring.times(whole.motion.turn, at),
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

PlacedTile Substitution::tile_at(const TileAddress& address) const
{
    const auto refused = [](std::size_t place, std::uint32_t number, std::size_t count) {
        return InputError(fmt::format("number {} is {}: must be from 0 to {}", place + 1, number, count - 1));
    };
    if (address.at(0) >= start_.tiles.size()) throw refused(0, address[0], start_.tiles.size());
    PlacedTile tile = start_.tiles[address[0]];
    for (std::size_t i = 1; i < address.size(); ++i) {
        const std::size_t count = tiling_.parts[tile.prototile].size();
        if (count == 0)
            throw InputError(fmt::format("number {} is {}: must lead to a tile with parts; \"{}\" has none", i,
                                         address[i - 1], tiling_.prototiles[tile.prototile].name));
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
    TileAddress first(levels + 1);
    const double unit = scale_of(ring, tile_at(first).motion); // all tiles of a level have one scale
    // The distance is a difference of exact places, so that it is right however far away from the origin both are.
    const auto is_near = [&](const PlacedTile& tile, std::size_t level) {
        const Level& left = levels_[levels - level];
        const RingPlace there = mapped(ring, left.maps[tile.motion.is_mirrored], tile.motion.at);
        return sizes(there - middle)[0] <= radius * unit + left.reach[0] * scale_of(ring, tile.motion);
    };
    SubstitutionWalk walk(tiling_, depth, most);
    const auto part = [&](const PlacedTile& tile, std::size_t index) { return part_of(tile, index); };
    for (std::size_t i = 0; i < start_.tiles.size(); ++i) {
        TileAddress address{static_cast<std::uint32_t>(i)};
        walk.walk(start_.tiles[i], address, is_near, part);
    }
    return walk.take();
}

std::optional<AddressedTile> Substitution::tile_around(int depth, const RingPlace& place) const
{
    constexpr std::size_t plenty = 100'000;
    for (AddressedTile& tile : tiles_near(depth, place, 0, plenty))
        if (lies_in(tiling_, tile.tile, place)) return std::move(tile);
    return std::nullopt;
}

}
