#include "tiles/isohedral/isohedral_tile.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr double shortest_edge = 1e-3;

double distance(const PlanePoint& a, const PlanePoint& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

/// Twice the area of a triangle, counterclockwise positive; 0 where rounding can decide the sign: Shewchuk, Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates, 1997, bound A of orientation in the plane.
double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c)
{
    constexpr double bound = 3.3306690738754716e-16;
    const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
    return std::abs(left - right) > bound * (std::abs(left) + std::abs(right)) ? left - right : 0;
}

/// False only for segments that do not meet.
bool meet(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d)
{
    for (const std::size_t axis : {0, 1}) // pieces of one straight line may lie side by side
        if (std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
            std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]))
            return false;
    return turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;
}

/// The curve of an edge in its own direction.
PlaneCurve curve_along(PlaneCurve curve, const EdgeCurve& use)
{
    for (PlanePoint& p : curve) p = {use.is_reversed ? 1 - p[0] : p[0], use.is_turned_over ? -p[1] : p[1]};
    if (use.is_reversed) std::ranges::reverse(curve);
    return curve;
}

PlaneCurve straight_curve() { return {{0, 0}, {1, 0}}; }

}

PlaneCurve shaped_curve(const PlaneCurve& curve, EdgeShape shape)
{
    if (shape == EdgeShape::free) return curve;
    if (shape == EdgeShape::straight) return straight_curve();
    PlaneCurve result;
    for (const PlanePoint& p : curve) result.push_back({p[0] / 2, shape == EdgeShape::turned ? p[1] / 2 : p[1]});
    for (std::size_t i = result.size() - 1; i-- > 0;) {
        const PlanePoint p = result[i];
        result.push_back({1 - p[0], shape == EdgeShape::turned ? -p[1] : p[1]});
    }
    return result;
}

PlaneCurve random_curve(std::uint64_t seed, std::uint32_t number, double amplitude)
{
    constexpr int steps = 16;
    const auto words = philox({number, 0, 0, 0}, stream_key(seed, Purpose::edge_curves, 0));
    const auto signed_unit = [&](std::size_t word) { return std::ldexp(words[word], -31) - 1; };
    PlaneCurve curve;
    for (int i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / steps;
        // Polynomials with zeros at both ends, of largest value 1: one bulge, two, and three.
        const double bulge = 4 * x * (1 - x), odd = 1 - 2 * x;
        const double y = signed_unit(0) * bulge + 2.6 * signed_unit(1) * bulge * odd +
                         signed_unit(2) * bulge * (5 * odd * odd - 1) / 2;
        curve.push_back({x, amplitude * y});
    }
    return curve;
}

bool crosses_itself(const std::vector<PlanePoint>& outline)
{
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            if (i == 0 && j + 1 == n) continue;
            if (meet(outline[i], outline[i + 1], outline[j], outline[(j + 1) % n])) return true;
        }
    return false;
}

IsohedralTile::IsohedralTile(const IsohedralType& type, const IsohedralParameters& parameters)
    : type_(&type), corners_(type.shape.base)
{
    const IsohedralTemplate& shape = type.shape;
    if (!parameters.deformations.empty() && parameters.deformations.size() != shape.parameters())
        throw InputError(fmt::format("IH{} has {} parameters, not {}", type.number, shape.parameters(),
                                     parameters.deformations.size()));
    for (std::size_t i = 0; i < parameters.deformations.size(); ++i) {
        if (!std::isfinite(parameters.deformations[i])) throw InputError("a parameter is not a number");
        for (std::size_t corner = 0; corner < corners_.size(); ++corner)
            for (std::size_t axis = 0; axis < 2; ++axis)
                corners_[corner][axis] += parameters.deformations[i] * shape.deformations[i][corner][axis];
    }
    for (std::size_t edge = 0; edge < corners_.size(); ++edge) {
        const PlanePoint &a = corners_[edge], &b = corners_[(edge + 1) % corners_.size()];
        if (distance(a, b) < shortest_edge)
            throw InputError(fmt::format("edge {} of the tile has no length with these parameters", edge));
        const EdgeCurve& use = shape.edge_curves[edge];
        const PlaneCurve own = use.curve < parameters.curves.size() ? parameters.curves[use.curve] : straight_curve();
        const PlaneCurve curve = curve_along(shaped_curve(own, shape.curve_shapes[use.curve]), use);
        for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
            const auto [x, y] = curve[i];
            outline_.push_back(
                {a[0] + x * (b[0] - a[0]) - y * (b[1] - a[1]), a[1] + x * (b[1] - a[1]) + y * (b[0] - a[0])});
        }
    }
    if (crosses_itself(outline_) || area_of(outline_) <= 0)
        throw InputError(fmt::format("the outline of the tile crosses itself with these parameters and curves"));
    hops_ = hops_of(shape, corners_);
    for (const HopWord& word : shape.aspects) aspects_.push_back(motion_of(word, hops_));
    for (std::size_t i = 0; i < 2; ++i) {
        const PlaneMotion from = motion_of(shape.translations[i][0], hops_);
        const PlaneMotion to = motion_of(shape.translations[i][1], hops_);
        translations_[i] = {to.x - from.x, to.y - from.y};
    }
}

PlaneMotion IsohedralTile::motion(const TilePlace& place) const
{
    PlaneMotion motion = aspects_.at(place.aspect);
    motion.x += place.column * translations_[0][0] + place.row * translations_[1][0];
    motion.y += place.column * translations_[0][1] + place.row * translations_[1][1];
    return motion;
}

TilePlace IsohedralTile::place_of(const PlaneMotion& motion) const
{
    const auto& [t1, t2] = translations_;
    const double determinant = t1[0] * t2[1] - t1[1] * t2[0];
    for (std::uint32_t aspect = 0; aspect < aspects_.size(); ++aspect)
        for (const PlaneMotion& symmetry : type_->shape.symmetries) {
            if (!same_linear_part(aspects_[aspect] * symmetry, motion)) continue;
            const double x = motion.x - aspects_[aspect].x, y = motion.y - aspects_[aspect].y;
            return {aspect, static_cast<std::int32_t>(std::lround((x * t2[1] - y * t2[0]) / determinant)),
                    static_cast<std::int32_t>(std::lround((t1[0] * y - t1[1] * x) / determinant))};
        }
    throw std::logic_error("a motion that is not of the tiling");
}

TilePlace IsohedralTile::neighbour(const TilePlace& place, std::size_t edge) const
{
    return place_of(motion(place) * hops_.at(edge));
}

TilePlace IsohedralTile::image(const TilePlace& place, std::size_t edge) const
{
    return place_of(hops_.at(edge) * motion(place));
}

std::vector<TilePlace> IsohedralTile::tiles_near(const PlanePoint& low, const PlanePoint& high) const
{
    double reach = 0;
    for (const PlanePoint& p : outline_) reach = std::max(reach, std::hypot(p[0], p[1]));
    const auto& [t1, t2] = translations_;
    const double determinant = t1[0] * t2[1] - t1[1] * t2[0];
    std::vector<TilePlace> places;
    for (std::uint32_t aspect = 0; aspect < aspects_.size(); ++aspect) {
        // The parallelogram's coordinates of the rectangle's corners, widened by the tile's reach.
        double bounds[4] = {1e300, -1e300, 1e300, -1e300};
        for (const double x : {low[0] - reach, high[0] + reach})
            for (const double y : {low[1] - reach, high[1] + reach}) {
                const double dx = x - aspects_[aspect].x, dy = y - aspects_[aspect].y;
                const double a = (dx * t2[1] - dy * t2[0]) / determinant, b = (t1[0] * dy - t1[1] * dx) / determinant;
                bounds[0] = std::min(bounds[0], a);
                bounds[1] = std::max(bounds[1], a);
                bounds[2] = std::min(bounds[2], b);
                bounds[3] = std::max(bounds[3], b);
            }
        for (auto row = static_cast<std::int32_t>(std::floor(bounds[2])); row <= std::ceil(bounds[3]); ++row)
            for (auto column = static_cast<std::int32_t>(std::floor(bounds[0])); column <= std::ceil(bounds[1]);
                 ++column) {
                const TilePlace place{aspect, column, row};
                const PlaneMotion at = motion(place);
                if (at.x >= low[0] - reach && at.x <= high[0] + reach && at.y >= low[1] - reach &&
                    at.y <= high[1] + reach)
                    places.push_back(place);
            }
    }
    return places;
}

IsohedralTile random_tile(const IsohedralType& type, std::uint64_t seed, double deformation, double amplitude)
{
    constexpr std::uint32_t deformations = 1; // a stream beside that of curves
    constexpr int trials = 40;
    constexpr double gentler = 0.9;
    const auto number = static_cast<std::uint32_t>(type.number);
    for (int trial = 0; trial < trials; ++trial, deformation *= gentler, amplitude *= gentler) {
        IsohedralParameters parameters;
        for (std::uint32_t i = 0; i < type.shape.parameters(); ++i) {
            const auto words = philox({number, i, 0, 0}, stream_key(seed, Purpose::edge_curves, deformations));
            parameters.deformations.push_back(deformation * (std::ldexp(words[0], -31) - 1));
        }
        for (std::uint32_t i = 0; i < type.shape.curve_shapes.size(); ++i)
            parameters.curves.push_back(random_curve(seed, 16 * number + i, amplitude));
        try {
            return IsohedralTile(type, parameters);
        } catch (const InputError&) {
            continue; // a gentler one will do
        }
    }
    return IsohedralTile(type, {});
}

}
