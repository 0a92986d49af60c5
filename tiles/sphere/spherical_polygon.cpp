#include "tiles/sphere/spherical_polygon.hpp"

#include "base/surfaces/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace poissonlab {
namespace {

double angle_between(const UnitVector& a, const UnitVector& b)
{
    const UnitVector n = cross(a, b);
    return std::atan2(std::sqrt(dot(n, n)), dot(a, b));
}

/// An arc of length 1 or less that leaves another by 1e-7 is longer by 2e-14.
bool is_on_arc(const UnitVector& place, const UnitVector& from, const UnitVector& to)
{
    return angle_between(from, place) + angle_between(place, to) < angle_between(from, to) + 1e-14;
}

bool do_arcs_meet(const UnitVector& a, const UnitVector& b, const UnitVector& c, const UnitVector& d)
{
    constexpr double rounding = 1e-14; // smaller determinants are those of places on an arc, or of arcs of one circle
    const UnitVector ab = cross(a, b), cd = cross(c, d);
    const double at_c = dot(ab, c), at_d = dot(ab, d), at_a = dot(cd, a), at_b = dot(cd, b);
    const double sign = at_c > 0 ? 1 : -1;
    if (sign * at_c > rounding && sign * at_d < -rounding && sign * at_a < -rounding && sign * at_b > rounding)
        return true;
    return is_on_arc(a, c, d) || is_on_arc(b, c, d) || is_on_arc(c, a, b) || is_on_arc(d, a, b);
}

/// A place inside: halfway from the middle of the longest edge to what is met first to the left.
UnitVector inner_place(const SphericalPolygon& polygon)
{
    const std::size_t count = polygon.size();
    std::size_t longest = 0;
    const auto cosine = [&](std::size_t i) { return dot(polygon[i], polygon[(i + 1) % count]); };
    for (std::size_t i = 1; i < count; ++i)
        if (cosine(i) < cosine(longest)) longest = i;
    const UnitVector &a = polygon[longest], &b = polygon[(longest + 1) % count];
    const UnitVector middle = unit({a[0] + b[0], a[1] + b[1], a[2] + b[2]}), inwards = unit(cross(a, b));
    const UnitVector circle = cross(middle, inwards);
    double reach = std::numbers::pi;
    for (std::size_t i = 0; i < count; ++i) {
        const UnitVector &p = polygon[i], &q = polygon[(i + 1) % count];
        const double at_p = dot(circle, p), at_q = dot(circle, q);
        if (i == longest || (at_p > 0) == (at_q > 0)) continue;
        UnitVector met{};
        for (std::size_t k = 0; k < 3; ++k) met[k] = std::abs(at_q) * p[k] + std::abs(at_p) * q[k];
        const double angle = std::atan2(dot(met, inwards), dot(met, middle));
        reach = std::min(reach, angle < 0 ? angle + 2 * std::numbers::pi : angle);
    }
    UnitVector inner{};
    for (std::size_t k = 0; k < 3; ++k) inner[k] = std::cos(reach / 2) * middle[k] + std::sin(reach / 2) * inwards[k];
    return inner;
}

}

double area_of(const SphericalPolygon& polygon)
{
    const std::size_t count = polygon.size();
    double turns = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const UnitVector& at = polygon[(i + 1) % count];
        const UnitVector before = unit(cross(polygon[i], at)), after = unit(cross(at, polygon[(i + 2) % count]));
        turns += std::atan2(dot(at, cross(before, after)), dot(before, after));
    }
    return 2 * std::numbers::pi - turns;
}

bool meets_itself(const SphericalPolygon& polygon)
{
    const std::size_t count = polygon.size();
    const auto at = [&](std::size_t i) -> const UnitVector& { return polygon[i % count]; };
    for (std::size_t i = 0; i < count; ++i) {
        if (is_on_arc(at(i + 2), at(i), at(i + 1)) || is_on_arc(at(i), at(i + 1), at(i + 2))) return true;
        for (std::size_t k = i + 2; k < count && k + 1 < count + i; ++k)
            if (do_arcs_meet(at(i), at(i + 1), at(k), at(k + 1))) return true;
    }
    return false;
}

SphericalRegion::SphericalRegion(SphericalPolygon polygon)
    : polygon_(std::move(polygon)), inner_(inner_place(polygon_)), least_cosine_(1)
{
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
        normals_.push_back(cross(polygon_[i], polygon_[(i + 1) % polygon_.size()]));
        is_inner_left_.push_back(dot(normals_[i], inner_) > 0);
        least_cosine_ = std::min(least_cosine_, dot(polygon_[i], inner_));
    }
}

bool SphericalRegion::contains(const UnitVector& place) const
{
    // The farthest places of a region in a cap that is smaller than half of the sphere are corners.
    if (least_cosine_ > 0 && dot(place, inner_) < least_cosine_ - 1e-9) return false;
    const UnitVector plane = cross(inner_, place);
    bool is_inside = true;
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
        if ((dot(normals_[i], place) > 0) == is_inner_left_[i]) continue;
        const bool is_from_left = dot(plane, polygon_[i]) > 0,
                   is_to_left = dot(plane, polygon_[(i + 1) % polygon_.size()]) > 0;
        // Arcs cross where the edge runs from the right to the left of the arc that leaves to the edge's right.
        if (is_from_left != is_to_left && is_to_left == is_inner_left_[i]) is_inside = !is_inside;
    }
    return is_inside;
}

}
