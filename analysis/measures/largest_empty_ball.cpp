#include "analysis/measures/largest_empty_ball.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus_delaunay.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {

namespace {

template <int D>
using Coordinates = std::array<double, D>;

template <class Number>
Number cross(const std::array<Number, 2>& a, const std::array<Number, 2>& b)
{
    return a[0] * b[1] - a[1] * b[0];
}

template <class Number>
std::array<Number, 3> cross(const std::array<Number, 3>& a, const std::array<Number, 3>& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class Number, std::size_t D>
Number dot(const std::array<Number, D>& a, const std::array<Number, D>& b)
{
    Number sum = a[0] * b[0];
    for (std::size_t k = 1; k < D; ++k) sum += a[k] * b[k];
    return sum;
}

/// The circumcentre relative to the corner 0, times `determinant`, from the edges that start there.
template <class Number>
std::array<Number, 2> scaled_centre(const std::array<std::array<Number, 2>, 2>& e, Number& determinant)
{
    determinant = 2 * cross(e[0], e[1]);
    const Number a = dot(e[0], e[0]);
    const Number b = dot(e[1], e[1]);
    return {e[1][1] * a - e[0][1] * b, e[0][0] * b - e[1][0] * a};
}

template <class Number>
std::array<Number, 3> scaled_centre(const std::array<std::array<Number, 3>, 3>& e, Number& determinant)
{
    const auto u = cross(e[1], e[2]), v = cross(e[2], e[0]), w = cross(e[0], e[1]);
    determinant = 2 * dot(e[0], u);
    const Number a = dot(e[0], e[0]), b = dot(e[1], e[1]), c = dot(e[2], e[2]);
    std::array<Number, 3> centre;
    for (std::size_t k = 0; k < 3; ++k) centre[k] = a * u[k] + b * v[k] + c * w[k];
    return centre;
}

template <class Number, int D>
std::array<std::array<Number, D>, D> edges_of(const DelaunaySimplex<D>& simplex)
{
    std::array<std::array<Number, D>, D> edges;
    for (std::size_t i = 0; i < D; ++i) {
        for (std::size_t k = 0; k < D; ++k) {
            edges[i][k] = (Number(simplex[i + 1].position[k]) - Number(simplex[0].position[k])) +
                          Number(simplex[i + 1].image[k] - simplex[0].image[k]);
        }
    }
    return edges;
}

/// The circumcentre relative to corner 0. In double where the simplex is far from flat, for then rounding,
/// 1e-16 of the longest edge's power and of the unit torus, stays far below the determinant; otherwise in
/// exact rationals.
template <int D>
Coordinates<D> circumcentre(const DelaunaySimplex<D>& simplex)
{
    constexpr double flat = 1e-4;
    const auto edges = edges_of<double, D>(simplex);
    double longest = 0;
    for (const auto& edge : edges) longest = std::max(longest, dot(edge, edge));
    double determinant = 0;
    Coordinates<D> centre = scaled_centre(edges, determinant);
    if (std::abs(determinant) > flat * std::pow(longest, 0.5 * D)) {
        for (double& c : centre) c /= determinant;
        return centre;
    }
    mpq_class exact_determinant;
    const auto exact = scaled_centre(edges_of<mpq_class, D>(simplex), exact_determinant);
    for (std::size_t k = 0; k < D; ++k) centre[k] = mpq_class(exact[k] / exact_determinant).get_d();
    return centre;
}

/// The simplex with its corners in an order that does not depend on how the triangulation came about, which in space
/// depends on addresses in memory: rounding depends on the order.
template <int D>
DelaunaySimplex<D> sorted(DelaunaySimplex<D> simplex)
{
    std::ranges::sort(simplex, {},
                      [](const DelaunayCorner<D>& corner) { return std::pair(corner.position, corner.image); });
    return simplex;
}

/// Keeps the largest of the balls that it is shown; of several the one with the least centre.
template <int D>
class LargestBall
{
public:
    void show(const DelaunaySimplex<D>& any_order)
    {
        const DelaunaySimplex<D> simplex = sorted<D>(any_order);
        const Coordinates<D> centre = circumcentre<D>(simplex);
        const double squared = dot(centre, centre);
        if (squared < squared_) return;
        std::array<double, 3> place{};
        for (std::size_t k = 0; k < D; ++k) {
            const double c = centre[k] + simplex[0].position[k];
            const double wrapped = c - std::floor(c);
            place[k] = wrapped < 1 ? wrapped : 0;
        }
        if (squared == squared_ && place >= centre_) return;
        squared_ = squared;
        centre_ = place;
    }

    LargestEmptyBall result(std::size_t points) const
    {
        const double radius = std::sqrt(squared_);
        return {radius, radius / max_min_distance(points, D), centre_};
    }

private:
    double squared_ = 0;
    std::array<double, 3> centre_{};
};

}

LargestEmptyBall largest_empty_ball(const PointSet& points)
{
    if (points.dimension != 2 && points.dimension != 3) {
        throw InputError("largest empty ball: the dimension must be 2 or 3");
    }
    if (points.size() == 0) throw InputError("largest empty ball: the point set must not be empty");
    if (points.dimension == 2) {
        LargestBall<2> largest;
        visit_triangles(points, [&](const DelaunaySimplex<2>& triangle) { largest.show(triangle); });
        return largest.result(points.size());
    }
    LargestBall<3> largest;
    visit_tetrahedra(points, [&](const DelaunaySimplex<3>& tetrahedron) { largest.show(tetrahedron); });
    return largest.result(points.size());
}

}
