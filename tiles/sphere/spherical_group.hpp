// Finite groups of isometries of the sphere: elements are numbers, and products of them are exact.
//
// Conway, Burgiel, Goodman-Strauss, The Symmetries of Things, 2008, chapter 4, names the fourteen types by their
// orbifolds: 532 has rotations about centres of orders 5, 3 and 2, *532 mirrors whose corners have these orders, and
// 3*2 centres of order 3 beside mirrors with corners of order 2.
#pragma once

#include "tiles/sphere/healpix.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// An orthogonal matrix, row by row.
using Isometry = std::array<UnitVector, 3>;

UnitVector moved(const Isometry& isometry, const UnitVector& place);

/// The rotation about an axis, counterclockwise as seen from its end.
Isometry rotation_about(const UnitVector& axis, double angle);

/// The reflection in the plane through the middle that has this normal.
Isometry reflection_across(const UnitVector& normal);

class SphericalGroup
{
public:
    /// Finds all products of `generators`, which must make a group of at most a few hundred elements whose turns differ
    /// by a degree or more.
    explicit SphericalGroup(const std::vector<Isometry>& generators);

    std::uint32_t size() const { return static_cast<std::uint32_t>(elements_.size()); }
    const Isometry& isometry(std::uint32_t element) const { return elements_[element]; }

    /// The element that does `second` first. Element 0 leaves all where it is.
    std::uint32_t product(std::uint32_t first, std::uint32_t second) const
    {
        return products_[first * size() + second];
    }
    std::uint32_t inverse(std::uint32_t element) const { return inverses_[element]; }

    /// The element that is nearest to an isometry.
    std::uint32_t nearest(const Isometry& isometry) const;

    /// The elements of the subgroup that some elements generate: true for each.
    std::vector<bool> generated(const std::vector<std::uint32_t>& generators) const;

private:
    std::vector<Isometry> elements_;
    std::vector<std::uint32_t> products_, inverses_;
};

}
