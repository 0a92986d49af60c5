#include "tiles/sphere/spherical_group.hpp"

#include "base/surfaces/triangle_mesh.hpp"

#include <cmath>

namespace poissonlab {
namespace {

Isometry product_of(const Isometry& a, const Isometry& b)
{
    Isometry result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t m = 0; m < 3; ++m) result[i][k] += a[i][m] * b[m][k];
    return result;
}

/// The trace of the isometry that leads from one to the other: 3 for equal ones, and less for all others.
double likeness(const Isometry& a, const Isometry& b) { return dot(a[0], b[0]) + dot(a[1], b[1]) + dot(a[2], b[2]); }

constexpr Isometry identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

}

UnitVector moved(const Isometry& isometry, const UnitVector& place)
{
    return {dot(isometry[0], place), dot(isometry[1], place), dot(isometry[2], place)};
}

Isometry rotation_about(const UnitVector& axis, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    Isometry result{{{c, -s * axis[2], s * axis[1]}, {s * axis[2], c, -s * axis[0]}, {-s * axis[1], s * axis[0], c}}};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) result[i][k] += (1 - c) * axis[i] * axis[k];
    return result;
}

Isometry reflection_across(const UnitVector& normal)
{
    Isometry result = identity;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) result[i][k] -= 2 * normal[i] * normal[k];
    return result;
}

SphericalGroup::SphericalGroup(const std::vector<Isometry>& generators) : elements_{identity}
{
    constexpr double equal = 3 - 1e-6; // turns of a degree have 3 - 3e-4
    for (std::size_t i = 0; i < elements_.size(); ++i)
        for (const Isometry& generator : generators) {
            const Isometry next = product_of(elements_[i], generator);
            if (likeness(next, elements_[nearest(next)]) < equal) elements_.push_back(next);
        }
    inverses_.resize(size());
    for (std::uint32_t i = 0; i < size(); ++i)
        for (std::uint32_t k = 0; k < size(); ++k) {
            products_.push_back(nearest(product_of(elements_[i], elements_[k])));
            if (products_.back() == 0) inverses_[i] = k;
        }
}

std::uint32_t SphericalGroup::nearest(const Isometry& isometry) const
{
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < size(); ++i)
        if (likeness(elements_[i], isometry) > likeness(elements_[best], isometry)) best = i;
    return best;
}

std::vector<bool> SphericalGroup::generated(const std::vector<std::uint32_t>& generators) const
{
    std::vector<bool> is_in(size());
    std::vector<std::uint32_t> found{0};
    is_in[0] = true;
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const std::uint32_t generator : generators)
            if (const std::uint32_t next = product(found[i], generator); !is_in[next]) {
                is_in[next] = true;
                found.push_back(next);
            }
    return is_in;
}

}
