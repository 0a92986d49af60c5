// Cells that may have room for points whose distances vary, and the darts that fall into them: what kernels and the
// plain algorithm share.
#pragma once

#include "host/sampling/varied/varied_darts.hpp"
#include "kernels/common/darts/varied_darts.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace poissonlab {

/// Sets OpenCell::least of each cell, 0 where it has no room.
using CellLook = std::function<void(std::vector<contract::varied_darts::OpenCell>& cells)>;

/// Squares of several sizes: each as wide as 2^-fineness times the least distance in it at most.
class VariedCells
{
public:
    /// Cells that cover everything, until refine() is called.
    VariedCells();

    /// Splits cells, by another bit of fineness each time, and leaves out those without room. The first time, by none.
    void refine(const CellLook& look);

    std::uint32_t fineness() const { return fineness_; }
    std::span<const contract::varied_darts::OpenCell> cells() const { return cells_; }

private:
    bool is_coarse(const contract::varied_darts::OpenCell& cell) const;
    void split_coarse(const CellLook& look, bool looks_at_all);

    std::vector<contract::varied_darts::OpenCell> cells_;
    std::uint32_t fineness_ = 0;
    bool is_begun_ = false;
};

/// A place, with the distance there before it is scaled.
struct VariedPlace
{
    TorusPoint<2> place{};
    std::uint32_t distance = 0;
};

/// A dart of a slot. Nothing where it falls outside, or is left out so that darts have a density of 1 / distance^2.
std::optional<VariedPlace> varied_dart(const VariedDartRequest& request, const VariedCells& cells, std::uint32_t slot,
                                       std::uint64_t number);

/// The cells into which darts fall first: all that are not outside, each as wide as its least distance at most.
VariedCells first_varied_cells(const VariedDartRequest& request);

/// The least distance in a cell; 0 where it is outside altogether.
std::uint32_t least_distance_in(const VariedDartRequest& request, const contract::varied_darts::OpenCell& cell);

/// See quotient_of() in kernels/varied_darts.cl.
std::uint64_t cell_quotient(std::uint32_t bits, std::uint32_t fineness, std::uint32_t distance);

/// The rule that kernels are told, but for its scale and the buckets.
contract::varied_darts::DistanceRule distance_rule(const VariedDartRequest& request);

/// The scale that follows, in units of 2^-SCALE_BITS.
std::uint32_t reduced_scale(std::uint32_t scale, double factor);

/// Darts of a slot before cells are refined or distances shrink.
std::uint32_t tries_of(const VariedDartRequest& request);

}
