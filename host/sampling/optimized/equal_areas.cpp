// Newton's method for the weights, and the moves between.
#include "host/sampling/optimized/equal_areas.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/optimized/area_exchange.hpp"
#include "host/sampling/optimized/row_order.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

using Values = std::vector<double>;

constexpr int max_newton_steps = 30;
constexpr int max_halvings = 12;
constexpr double solver_tolerance = 1e-4; ///< of the right side; Newton's method corrects the rest

class Equalizer
{
public:
    Equalizer(const PointSet& points, const PowerCellsOf& cells_of)
        : cells_of_(cells_of), mean_(1 / static_cast<double>(points.size())), order_(points),
          points_(order_.sorted(points)), weights_(points.size())
    {}

    EqualAreas run(std::size_t iterations)
    {
        for (std::size_t iteration = 0;; ++iteration) {
            stop_if_interrupted();
            equalize();
            record();
            if (iteration == iterations)
                return {order_.restored(points_), order_.restored(weights_), std::move(iterations_)};
            move();
        }
    }

private:
    /// This is the distance of areas from equal ones.
    Values lacking(const PowerCells& cells) const
    {
        Values lacking;
        for (const double area : cells.areas) lacking.push_back(mean_ - area);
        return lacking;
    }

    double deviation(const PowerCells& cells) const
    {
        double sum = 0;
        for (const double value : lacking(cells)) sum += value * value;
        return std::sqrt(sum / static_cast<double>(cells.areas.size())) / mean_;
    }

    static double smallest(const PowerCells& cells) { return std::ranges::min(cells.areas); }

    /// Newton's method from the weights that there are or, where these leave a cell without area, from none.
    void equalize()
    {
        cells_ = cells_of_(points_, weights_);
        if (smallest(cells_) <= 0) {
            std::ranges::fill(weights_, 0);
            cells_ = cells_of_(points_, weights_);
        }
        const double least = std::min(smallest(cells_), mean_) / 2;
        for (int step = 0; step < max_newton_steps && deviation(cells_) > equal_area_tolerance; ++step)
            if (!newton_step(least)) return;
    }

    /// The whole step, or half of it, and so on: the first that leaves no cell smaller than `least` and makes areas as
    /// much more equal as it should. False where there is none.
    bool newton_step(double least)
    {
        Values wanted = lacking(cells_);
        const double mean = std::accumulate(wanted.begin(), wanted.end(), 0.0) / static_cast<double>(wanted.size());
        for (double& value : wanted) value -= mean; // rounding
        const Values change = ExchangeSolver(area_exchange(cells_)).weights_for(wanted, solver_tolerance);
        const double before = deviation(cells_);
        double part = 1;
        for (int halving = 0; halving < max_halvings; ++halving, part /= 2) {
            Values weights = weights_;
            for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += part * change[i];
            PowerCells cells = cells_of_(points_, weights);
            if (!(smallest(cells) >= least && deviation(cells) <= (1 - part / 2) * before)) continue;
            weights_ = std::move(weights);
            cells_ = std::move(cells);
            return true;
        }
        return false;
    }

    void record()
    {
        const double integral = std::accumulate(cells_.energies.begin(), cells_.energies.end(), 0.0);
        const std::size_t n = points_.size();
        iterations_.push_back({relative_radius(min_toroidal_distance(points_), n, 2), lloyd_energy(integral, n, 2)});
    }

    void move()
    {
        for (std::size_t i = 0; i < points_.coordinates.size(); ++i) {
            const double moved = points_.coordinates[i] + cells_.displacements[i];
            const double wrapped = moved - std::floor(moved);
            points_.coordinates[i] = wrapped < 1 ? wrapped : 0; // just below 0, the sum rounds to 1
        }
    }

    const PowerCellsOf& cells_of_;
    double mean_;
    RowOrder order_; ///< in which points are here
    PointSet points_;
    Values weights_;
    PowerCells cells_; ///< of the points with their weights
    std::vector<IterationRecord> iterations_;
};

}

EqualAreas equalize_areas(const PointSet& points, std::size_t iterations, const PowerCellsOf& cells_of)
{
    return Equalizer(points, cells_of).run(iterations);
}

}
