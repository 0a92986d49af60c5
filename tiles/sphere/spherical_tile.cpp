#include "tiles/sphere/spherical_tile.hpp"

#include "base/errors/errors.hpp"
#include "base/surfaces/triangle_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double pi = std::numbers::pi;

/// A triangle with angles pi / order at its corners, which are counterclockwise.
std::array<UnitVector, 3> schwarz_triangle(const std::array<int, 3>& orders)
{
    std::array<double, 3> cosines{}, sines{};
    for (std::size_t i = 0; i < 3; ++i) {
        cosines[i] = std::cos(pi / orders[i]);
        sines[i] = std::sin(pi / orders[i]);
    }
    const auto side = [&](std::size_t i, std::size_t j, std::size_t k) { // opposite corner i
        return std::acos(std::clamp((cosines[i] + cosines[j] * cosines[k]) / (sines[j] * sines[k]), -1.0, 1.0));
    };
    const double to_first = side(1, 2, 0), to_second = side(0, 1, 2); // from the third corner, which is the pole
    return {UnitVector{std::sin(to_first), 0, std::cos(to_first)},
            UnitVector{std::sin(to_second) * cosines[2], std::sin(to_second) * sines[2], std::cos(to_second)},
            UnitVector{0, 0, 1}};
}

/// The three orders that a name has, and where its star is: -1 for none.
struct Signature
{
    std::array<int, 3> orders{};
    int star = -1;
};

Signature signature_of(const SphericalTileSettings& s)
{
    Signature signature;
    std::vector<int> digits;
    for (const char c : s.group) {
        if (c == '*')
            signature.star = static_cast<int>(digits.size());
        else
            digits.push_back(c == 'n' ? s.n : c - '0');
    }
    if (digits.size() == 2) // the triangle of the mirrors of twice as many elements: half a tile
        signature.orders = {digits[0], 2 * digits[1], 2};
    else
        signature.orders = {digits[0], digits[1], digits[2]};
    return signature;
}

}

const std::vector<std::string>& spherical_group_names()
{
    static const std::vector<std::string> names{"532",  "432",  "332",  "22n", "*532",
                                                "*432", "*332", "*22n", "3*2", "2*n"};
    return names;
}

UnitVector place_beside(const UnitVector& from, const UnitVector& to, const PlanePoint& place)
{
    const UnitVector up = unit(cross(from, to)), ahead = cross(up, from);
    const double length = std::atan2(dot(to, ahead), dot(to, from));
    const double along = place[0] * length, away = place[1] * length;
    UnitVector result{};
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = std::cos(away) * (std::cos(along) * from[k] + std::sin(along) * ahead[k]) + std::sin(away) * up[k];
    return result;
}

void SphericalTile::add_side(const PlaneCurve& curve, const UnitVector& from, const UnitVector& to, bool is_backwards,
                             const SphericalSide& side)
{
    std::vector<UnitVector> places{from};
    for (std::size_t i = 1; i + 1 < curve.size(); ++i) places.push_back(place_beside(from, to, curve[i]));
    places.push_back(to);
    if (is_backwards) std::ranges::reverse(places);
    corners_.push_back(outline_.size());
    outline_.insert(outline_.end(), places.begin(), places.end() - 1);
    sides_.push_back(side);
}

void SphericalTile::add_mirror_sides(const std::vector<UnitVector>& corners)
{
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Isometry mirror = reflection_across(unit(cross(corners[i], corners[i + 1])));
        add_side({}, corners[i], corners[i + 1], false, {sides_.size(), group_.nearest(mirror), true});
    }
}

/// The outline goes around the tree: from the corner to a centre and back to a copy of the corner, which the rotation
/// about that centre makes. The product of the three rotations is 1.
void SphericalTile::make_rotated(const SphericalTileSettings& settings, const std::array<int, 3>& orders)
{
    // Clockwise, as the rotations are.
    std::array<UnitVector, 3> centers = schwarz_triangle({orders[2], orders[1], orders[0]});
    std::swap(centers[0], centers[2]);
    std::vector<Isometry> rotations;
    for (std::size_t i = 0; i < 3; ++i) rotations.push_back(rotation_about(centers[i], -2 * pi / orders[i]));
    group_ = SphericalGroup(rotations);
    UnitVector corner{};
    std::size_t given = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        given += settings.corner[i] > 0;
        for (std::size_t k = 0; k < 3; ++k) corner[k] += settings.corner[i] * centers[i][k];
    }
    if (given == 0) throw InputError("a corner needs a weight above 0");
    corner = unit(corner);
    std::uint32_t element = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t next = group_.product(element, group_.nearest(rotations[i]));
        const bool is_corner = given == 1 && settings.corner[i] > 0;
        const PlaneCurve curve = i < settings.curves.size() ? settings.curves[i] : PlaneCurve{};
        if (is_corner && curve.size() > 2)
            throw InputError(fmt::format("curve {} must be []: the corner is the centre of order {}", i, orders[i]));
        if (!is_corner) {
            const auto add = [&](std::uint32_t of, std::uint32_t other, bool is_backwards) {
                const Isometry& m = group_.isometry(of);
                const std::uint32_t beyond = group_.product(of, group_.inverse(other));
                add_side(curve, moved(m, corner), moved(m, centers[i]), is_backwards,
                         {is_backwards ? sides_.size() - 1 : sides_.size() + 1, beyond, false});
            };
            add(element, next, false);
            add(next, element, true);
        }
        element = next;
    }
}

void SphericalTile::make_mirrored(const std::array<int, 3>& orders)
{
    const std::array<UnitVector, 3> c = schwarz_triangle(orders);
    std::vector<Isometry> mirrors;
    for (std::size_t i = 0; i < 3; ++i) mirrors.push_back(reflection_across(unit(cross(c[i], c[(i + 1) % 3]))));
    group_ = SphericalGroup(mirrors);
    add_mirror_sides({c[0], c[1], c[2], c[0]});
}

/// The outline goes from the centre along the curve to a corner of mirrors, along a mirror by its middle to the next
/// such corner, and back.
void SphericalTile::make_gyrated(const SphericalTileSettings& settings, const std::array<int, 3>& orders)
{
    const auto [center, corner, middle] = schwarz_triangle(orders);
    const Isometry turn = rotation_about(center, 2 * pi / orders[0]);
    group_ = SphericalGroup({turn, reflection_across(unit(cross(corner, middle)))});
    const std::uint32_t element = group_.nearest(turn);
    const PlaneCurve curve = settings.curves.empty() ? PlaneCurve{} : settings.curves[0];
    const UnitVector next = moved(turn, corner);
    add_side(curve, center, corner, false, {3, group_.inverse(element), false});
    add_mirror_sides({corner, middle, next});
    add_side(curve, center, next, true, {0, element, false});
}

SphericalTile::SphericalTile(const SphericalTileSettings& settings) : split_(settings.split)
{
    const auto [orders, star] = signature_of(settings);
    const std::size_t curves = star < 0 ? 3 : star == 0 ? 0 : 1;
    if (settings.curves.size() > curves)
        throw InputError(fmt::format("tiles of {} have {}", settings.group,
                                     star < 0    ? "at most three curves"
                                     : star == 0 ? "no curves: their sides lie on mirrors"
                                                 : "at most one curve"));
    if (star < 0)
        make_rotated(settings, orders);
    else if (star == 0)
        make_mirrored(orders);
    else
        make_gyrated(settings, orders);
    if (meets_itself(outline_)) throw InputError("the edges of the tile meet");
    // The angles at corners of three tiles add up to full turns: to one, where the area is this.
    if (std::abs(area_of(outline_) - 4 * pi / group_.size()) > 1e-9)
        throw InputError("the edges of the tile wind around the sphere");
    parts_ = {outline_};
    if (split_) split(*split_);
}

void SphericalTile::split(const TileSplit& path)
{
    const std::size_t count = corners_.size();
    if (path.from >= count || path.to >= count || path.from == path.to)
        throw InputError(fmt::format("a path joins two different corners of the {}, 0 to {}", count, count - 1));
    const std::size_t first = corners_[path.from], last = corners_[path.to];
    if (dot(outline_[first], outline_[last]) < -1 + 1e-9)
        throw InputError(
            fmt::format("corners {} and {} lie opposite each other: no arc joins them", path.from, path.to));
    std::vector<UnitVector> inner;
    for (std::size_t i = 1; i + 1 < path.path.size(); ++i)
        inner.push_back(place_beside(outline_[first], outline_[last], path.path[i]));
    const auto part = [&](std::size_t begin, std::size_t end) {
        SphericalPolygon polygon;
        for (std::size_t i = begin; i != end; i = (i + 1) % outline_.size()) polygon.push_back(outline_[i]);
        polygon.push_back(outline_[end]);
        return polygon;
    };
    parts_ = {part(first, last), part(last, first)};
    parts_[0].insert(parts_[0].end(), inner.rbegin(), inner.rend());
    parts_[1].insert(parts_[1].end(), inner.begin(), inner.end());
    const double whole = area_of(outline_);
    for (const SphericalPolygon& polygon : parts_)
        if (polygon.size() < 3 || meets_itself(polygon) || !(area_of(polygon) < whole))
            throw InputError("the path that splits the tile meets its outline or itself");
}

std::size_t SphericalTile::part_of(std::size_t side) const
{
    if (!split_) return 0;
    const std::size_t count = sides_.size();
    const bool is_first = (side + count - split_->from) % count < (split_->to + count - split_->from) % count;
    return is_first ? 0 : 1;
}

std::size_t SphericalTile::alike() const
{
    std::size_t alike = 0;
    for (std::size_t i = 0; i < sides_.size(); ++i)
        alike += !sides_[i].is_mirror && part_of(i) == part_of(sides_[i].partner);
    return alike;
}

std::array<std::size_t, 3> SphericalTile::counts() const
{
    // Corners of tiles, of which those that meet at a side are one.
    const std::size_t tiles = group_.size(), count = sides_.size();
    std::vector<std::size_t> parent(tiles * count);
    for (std::size_t i = 0; i < parent.size(); ++i) parent[i] = i;
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::uint32_t tile = 0; tile < tiles; ++tile)
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t other = group_.product(tile, sides_[i].neighbour) * count;
            const std::size_t partner = sides_[i].partner, turn = sides_[i].is_mirror ? 0 : 1;
            parent[root(tile * count + i)] = root(other + (partner + turn) % count);
            parent[root(tile * count + (i + 1) % count)] = root(other + (partner + 1 - turn) % count);
        }
    std::size_t corners = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) corners += parent[i] == i;
    return {corners, tiles * count / 2, tiles};
}

/// Colours are left cosets of a subgroup that has no neighbour of the tile of element 0. Two elements generate the
/// largest one: subgroups of rotations need no more, nor do those of 3*2 and 2*n, and with *pqr it is all rotations.
std::vector<std::uint32_t> SphericalTile::coloring() const
{
    const std::uint32_t count = group_.size();
    std::vector<bool> best;
    std::ptrdiff_t most = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t k = 0; k <= i; ++k) {
            std::vector<bool> subgroup = group_.generated({i, k});
            const std::ptrdiff_t size = std::ranges::count(subgroup, true);
            const bool has_neighbour =
                std::ranges::any_of(sides_, [&](const SphericalSide& s) { return bool{subgroup[s.neighbour]}; });
            if (has_neighbour || size <= most) continue;
            best = std::move(subgroup);
            most = size;
        }
    std::vector<std::uint32_t> colors(count, count);
    std::uint32_t color = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (colors[i] < count) continue;
        for (std::uint32_t k = 0; k < count; ++k)
            if (best[k]) colors[group_.product(i, k)] = color;
        ++color;
    }
    return colors;
}

}
