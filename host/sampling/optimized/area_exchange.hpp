// The linear equations of equal areas: weights that change the areas of cells as wanted, where each cell takes from, or
// gives to, its neighbours.
//
// Conjugate gradients, whose number of steps hardly depends on how many cells there are: their preconditioner solves
// the same equations of ever larger groups of cells. Notay, An aggregation-based algebraic multigrid method, Electronic
// Transactions on Numerical Analysis 37, 2010: groups are pairs of pairs of those that exchange most, and each level's
// equations are solved by up to two steps of conjugate gradients that the next level preconditions (the K-cycle).
#pragma once

#include "host/sampling/optimized/power_cells.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// The area that cells exchange for a unit of weight: those of cell i are from starts[i] to starts[i + 1].
struct AreaExchange
{
    std::vector<std::uint32_t> starts, neighbours;
    std::vector<double> exchanges;

    std::size_t size() const { return starts.size() - 1; }
};

AreaExchange area_exchange(const PowerCells& cells);

class ExchangeSolver
{
public:
    explicit ExchangeSolver(AreaExchange exchange);

    /// Weights that change areas as wanted, but for a part of `tolerance` in the root mean square. The sum of `wanted`
    /// is zero.
    std::vector<double> weights_for(const std::vector<double>& wanted, double tolerance);

    /// The steps of conjugate gradients that the last call took.
    std::size_t steps() const { return steps_; }

private:
    using Values = std::vector<double>;

    /// The equations of cells, or of groups of them.
    struct Level
    {
        AreaExchange exchange;
        Values inverse_sums;               ///< of what a cell exchanges
        std::vector<std::uint32_t> groups; ///< those of the cells, which the next level has; empty: there is none
    };

    Values precondition(std::size_t level, const Values& wanted) const;
    Values solve_nearly(std::size_t level, const Values& wanted) const;

    std::vector<Level> levels_;
    std::size_t steps_ = 0;
};

}
