#include "tiles/poisson/region_shapes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

/// Corners that are closer are the same one; units.
constexpr double same_corner = 1e-4;

double dot(const ShapeVector& a, const ShapeVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

ShapeVector cross(const ShapeVector& a, const ShapeVector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

ShapeVector difference(const ShapeVector& a, const ShapeVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

bool are_same(const ShapeVector& a, const ShapeVector& b)
{
    return std::abs(a[0] - b[0]) < same_corner && std::abs(a[1] - b[1]) < same_corner &&
           std::abs(a[2] - b[2]) < same_corner;
}

void add_once(std::vector<ShapeVector>& corners, const ShapeVector& corner)
{
    if (std::ranges::none_of(corners, [&](const ShapeVector& c) { return are_same(c, corner); }))
        corners.push_back(corner);
}

/// Sutherland and Hodgman's step. Adds the corners on the plane to `cut`.
ShapeFace clipped_face(const ShapeFace& face, const ShapeHalfSpace& half, std::vector<ShapeVector>& cut)
{
    ShapeFace result{{}, face.normal};
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
        const ShapeVector& a = face.corners[i];
        const ShapeVector& b = face.corners[(i + 1) % face.corners.size()];
        const double beyond_a = dot(half.normal, a) - half.limit;
        const double beyond_b = dot(half.normal, b) - half.limit;
        if (beyond_a <= 0) add_once(result.corners, a);
        if (beyond_a == 0) add_once(cut, a);
        if ((beyond_a < 0 && beyond_b > 0) || (beyond_a > 0 && beyond_b < 0)) {
            const double share = beyond_a / (beyond_a - beyond_b);
            const ShapeVector way = difference(b, a);
            const ShapeVector crossing{a[0] + share * way[0], a[1] + share * way[1], a[2] + share * way[2]};
            add_once(result.corners, crossing);
            add_once(cut, crossing);
        }
    }
    return result;
}

/// The face that a plane cuts, its corners in order around their middle.
ShapeFace cap(std::vector<ShapeVector> corners, const ShapeVector& normal)
{
    ShapeVector middle{};
    for (const ShapeVector& corner : corners)
        for (std::size_t k = 0; k < 3; ++k) middle[k] += corner[k] / static_cast<double>(corners.size());
    const ShapeVector right = difference(corners.front(), middle);
    const ShapeVector up = cross(normal, right);
    std::ranges::sort(corners, {}, [&](const ShapeVector& corner) {
        const ShapeVector way = difference(corner, middle);
        return std::atan2(dot(way, up) / std::sqrt(dot(up, up)), dot(way, right) / std::sqrt(dot(right, right)));
    });
    return {corners, normal};
}

/// Cuts the region of a cell out of a box.
class Cutter
{
public:
    Cutter(RegionShape shape, std::uint8_t own_axes, const std::array<std::int32_t, 3>& base)
        : shape_(std::move(shape)), own_axes_(own_axes), base_(base)
    {}

    /// Cuts off where the sum of distances along `count` of the axes in `mask` passes a limit, on all sides.
    /// Along axes that the cell has not: distances from it, at most the limit. Along its own: from its ends, at
    /// least the limit.
    void cut(unsigned mask, int count, double limit)
    {
        for (unsigned axes = 1; axes < 8; ++axes) {
            if ((axes & ~mask) != 0 || std::popcount(axes) != count) continue;
            for (unsigned sides = 0; sides < 8; ++sides) {
                if ((sides & ~axes) == 0) shape_ = clipped(shape_, half_space(axes, sides, limit));
            }
        }
    }

    const RegionShape& shape() const { return shape_; }

private:
    ShapeHalfSpace half_space(unsigned axes, unsigned sides, double limit) const
    {
        const bool is_own = (axes & own_axes_) != 0;
        ShapeHalfSpace half{{}, is_own ? -limit : limit};
        for (std::size_t k = 0; k < 3; ++k) {
            if (!(axes >> k & 1)) continue;
            const bool upper = sides >> k & 1;
            const double origin = (base_[k] + (is_own && upper ? 1.0 : 0.0)) * tile_units;
            half.normal[k] = upper ? 1 : -1;
            half.limit += half.normal[k] * origin;
        }
        return half;
    }

    RegionShape shape_;
    std::uint8_t own_axes_;
    std::array<std::int32_t, 3> base_;
};

}

RegionShape box_shape(int dimension, const ShapeVector& low, const ShapeVector& high)
{
    const auto corner = [&](unsigned upper) {
        ShapeVector place{};
        for (std::size_t k = 0; k < 3; ++k) place[k] = upper >> k & 1 ? high[k] : low[k];
        return place;
    };
    RegionShape shape;
    if (dimension == 2) {
        shape.faces.push_back({{corner(0), corner(1), corner(3), corner(2)}, {0, 0, 1}});
        return shape;
    }
    for (unsigned axis = 0; axis < 3; ++axis) {
        const unsigned u = 1u << (axis + 1) % 3, v = 1u << (axis + 2) % 3, side = 1u << axis;
        ShapeVector normal{};
        normal[axis] = 1;
        shape.faces.push_back({{corner(side), corner(side | u), corner(side | u | v), corner(side | v)}, normal});
        normal[axis] = -1;
        shape.faces.push_back({{corner(0), corner(v), corner(u | v), corner(u)}, normal});
    }
    return shape;
}

RegionShape clipped(const RegionShape& shape, const ShapeHalfSpace& half)
{
    const auto is_beyond = [&](const ShapeVector& corner) { return dot(half.normal, corner) > half.limit; };
    if (std::ranges::none_of(shape.faces,
                             [&](const ShapeFace& face) { return std::ranges::any_of(face.corners, is_beyond); }))
        return shape;
    RegionShape result;
    std::vector<ShapeVector> cut;
    for (const ShapeFace& face : shape.faces) {
        ShapeFace left = clipped_face(face, half, cut);
        if (left.corners.size() >= 3) result.faces.push_back(std::move(left));
    }
    if (shape.faces.size() == 1) return result;
    if (cut.size() >= 3) result.faces.push_back(cap(std::move(cut), half.normal));
    return result.faces.size() >= 4 ? result : RegionShape{};
}

RegionShape clipped_to_box(RegionShape shape, int dimension, const ShapeVector& low, const ShapeVector& high)
{
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
        ShapeVector normal{};
        normal[k] = 1;
        shape = clipped(shape, {normal, high[k]});
        normal[k] = -1;
        shape = clipped(shape, {normal, -low[k]});
    }
    return shape;
}

RegionShape region_shape(const TileRegions& regions, std::uint8_t axes, const std::array<std::int32_t, 3>& base)
{
    const int dimension = regions.dimension;
    const unsigned others = all_axes(dimension) & ~axes;
    ShapeVector low{}, high{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
        low[k] = (base[k] - (others >> k & 1 ? 1.0 : 0.0)) * tile_units;
        high[k] = (base[k] + 1.0) * tile_units;
    }
    // The bounds of the regions of corners, edges (2D: corners) and faces (2D: edges), by the number of axes summed
    // over.
    const std::array<double, 3> corner{double(regions.corner_one), double(regions.corner_two),
                                       double(regions.corner_three)};
    const std::array<double, 3> pair{double(regions.pair_one), double(regions.pair_sum), 0};
    const std::array<double, 3> strip{double(regions.width), 0, 0};
    const int across = std::popcount(others), along = std::popcount(axes);
    Cutter cutter(box_shape(dimension, low, high), axes, base);
    const auto& outwards = across == 3 ? corner : across == 2 ? pair : strip;
    for (int count = 1; count <= across; ++count)
        cutter.cut(others, count, outwards[static_cast<std::size_t>(count - 1)]);
    // The regions of cells of lower dimension, with `count` more axes across, begin at this region's ends.
    for (int count = 1; count <= along; ++count) {
        const auto& next = across + count == 3 ? corner : across + count == 2 ? pair : strip;
        cutter.cut(axes, count, next[static_cast<std::size_t>(count - 1)]);
    }
    return cutter.shape();
}

}
