// The moments that all tiles of a set are to have, and what of them is left for the points inside of a tile.
#pragma once

#include "host/tile_construction/moments/exact_moments.hpp"
#include "tiles/poisson/tile_moments.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// The part of the minimum distance, in units, that tiles may lose when their moments are made exact.
double moment_margin(const PoissonTileParameters& parameters);

class MomentTargets
{
public:
    /// The mean of all tiles as they are, up to this order; where points have classes, that of each class.
    MomentTargets(const PoissonTileSet& set, std::uint32_t order);

    std::uint32_t order() const { return order_; }

    /// The moments, as in FillProblem::moments, that are left for the inside of a tile that owns these other points;
    /// these are relative to its lower corner. Moments of a class come after those of the one before.
    std::vector<std::int64_t> left_in_units(std::span<const UnitPosition> others) const;

    /// Makes the moments of a tile exact, as far as exact_moment_order() says; false: that cannot be done. Points move
    /// by so little that the minimum distance bears it; they may leave where they should be.
    bool make_exact(std::vector<UnitPosition>& inside, std::span<const UnitPosition> others) const;

private:
    std::size_t class_count() const { return wanted_.size() / monomials_.size(); }
    StoredFromMiddle stored(const UnitPosition& position) const;
    std::vector<std::int64_t> left(std::span<const UnitPosition> others) const;
    bool make_exact(std::vector<UnitPosition>& inside, std::uint32_t of, const std::vector<std::int64_t>& left) const;

    PoissonTileParameters p_;
    std::uint32_t order_;
    std::vector<Monomial> monomials_;
    std::vector<std::int64_t> wanted_; ///< by class and monomial, in stored numbers
};

}
