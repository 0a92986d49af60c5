#include "tiles/isohedral/tile_lookup.hpp"

#include "base/errors/errors.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace poissonlab {
namespace {

using LatticeCorner = std::array<std::int32_t, 2>;

constexpr std::int32_t lattice_unit = 1 << lattice_bits;
constexpr std::int32_t same_corner = 16; // units: the same corner by two ways differs by one, others by far more

std::array<double, 2> along_translations(const std::array<PlanePoint, 2>& t, const PlanePoint& p)
{
    const double determinant = t[0][0] * t[1][1] - t[0][1] * t[1][0];
    return {(p[0] * t[1][1] - p[1] * t[1][0]) / determinant * lattice_unit,
            (t[0][0] * p[1] - t[0][1] * p[0]) / determinant * lattice_unit};
}

/// Corners rounded so that those which are the same up to translations become the same.
class CornerRounding
{
public:
    LatticeCorner rounded(const std::array<double, 2>& exact)
    {
        LatticeCorner corner{};
        for (std::size_t axis = 0; axis < 2; ++axis) corner[axis] = static_cast<std::int32_t>(std::lround(exact[axis]));
        for (const LatticeCorner& other : known_) {
            const LatticeCorner apart{distance(corner[0], other[0]), distance(corner[1], other[1])};
            if (std::max(std::abs(apart[0]), std::abs(apart[1])) <= same_corner)
                return {corner[0] + apart[0], corner[1] + apart[1]};
        }
        known_.push_back(corner);
        return corner;
    }

private:
    /// The way from a to b on a circle of one unit, the shorter one.
    static std::int32_t distance(std::int32_t a, std::int32_t b)
    {
        const std::int32_t apart = (b - a) & (lattice_unit - 1);
        return apart < lattice_unit / 2 ? apart : apart - lattice_unit;
    }

    std::vector<LatticeCorner> known_;
};

bool is_in_outline(std::span<const LatticeCorner> corners, std::int32_t x, std::int32_t y)
{
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const LatticeCorner& a = corners[(i == 0 ? corners.size() : i) - 1];
        const LatticeCorner& b = corners[i];
        if ((a[1] > y) == (b[1] > y)) continue;
        const std::int64_t left = std::int64_t{x - a[0]} * (b[1] - a[1]);
        const std::int64_t right = std::int64_t{y - a[1]} * (b[0] - a[0]);
        inside ^= b[1] > a[1] ? left < right : left > right;
    }
    return inside;
}

FoundTile found_tile(const TileLookup& lookup, const LatticePoint& point)
{
    std::array<std::int32_t, 2> unit{}, inside{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        unit[axis] = static_cast<std::int32_t>(point[axis] >> lattice_bits);
        inside[axis] = static_cast<std::int32_t>(point[axis] & (lattice_unit - 1));
    }
    for (const LookupCandidate& c : lookup.candidates) {
        const std::int32_t x = inside[0] - c.place.column * lattice_unit;
        const std::int32_t y = inside[1] - c.place.row * lattice_unit;
        if (x < c.low[0] || x > c.high[0] || y < c.low[1] || y > c.high[1]) continue;
        if (!is_in_outline(std::span(lookup.corners).subspan(c.first, c.count), x, y)) continue;
        return {{c.place.aspect, unit[0] + c.place.column, unit[1] + c.place.row}, {x - c.anchor[0], y - c.anchor[1]}};
    }
    throw std::logic_error("a place in no tile");
}

}

TileLookup::TileLookup(const IsohedralTile& tile) : translations(tile.translations())
{
    CornerRounding rounding;
    for (std::uint32_t aspect = 0; aspect < tile.aspects().size(); ++aspect) {
        LookupCandidate candidate{{aspect, 0, 0}, corners.size(), tile.outline().size()};
        const PlaneMotion& motion = tile.aspects()[aspect];
        for (const PlanePoint& p : tile.outline())
            corners.push_back(rounding.rounded(along_translations(translations, motion(p))));
        const auto own = std::span(corners).subspan(candidate.first);
        candidate.low = candidate.high = own[0];
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (own[i] == own[(i + 1) % own.size()])
                throw InputError("a tile has parts that are too small for the grid of its outline");
            for (std::size_t axis = 0; axis < 2; ++axis) {
                candidate.low[axis] = std::min(candidate.low[axis], own[i][axis]);
                candidate.high[axis] = std::max(candidate.high[axis], own[i][axis]);
            }
        }
        const auto anchor = along_translations(translations, {motion.x, motion.y});
        for (std::size_t axis = 0; axis < 2; ++axis)
            candidate.anchor[axis] = static_cast<std::int32_t>(std::lround(anchor[axis]));
        // The units from which the tile reaches (0, 0): low + unit is below its end, high + unit not below its begin.
        const auto first = [&](std::size_t axis) { return -(candidate.high[axis] >> lattice_bits); };
        const auto last = [&](std::size_t axis) { return -(candidate.low[axis] >> lattice_bits); };
        for (std::int32_t row = first(1); row <= last(1); ++row)
            for (std::int32_t column = first(0); column <= last(0); ++column) {
                candidate.place = {aspect, column, row};
                candidates.push_back(candidate);
            }
    }
}

LatticePoint TileLookup::lattice_point(const PlanePoint& point) const
{
    const auto exact = along_translations(translations, point);
    return {std::llround(exact[0]), std::llround(exact[1])};
}

PlanePoint TileLookup::offset_of(const FoundTile& found) const
{
    PlanePoint offset{};
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t i = 0; i < 2; ++i)
            offset[axis] += std::ldexp(found.offset[i], -lattice_bits) * translations[i][axis];
    return offset;
}

std::vector<FoundTile> reference::find_tiles(const TileLookup& lookup, std::span<const LatticePoint> points)
{
    std::vector<FoundTile> found;
    found.reserve(points.size());
    for (const LatticePoint& point : points) found.push_back(found_tile(lookup, point));
    return found;
}

}
