// Newton's method for the weights, and the moves between.
#include "host/sampling/optimized/equal_areas.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/programs/interrupt.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "kernels/common/power_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace poissonlab {
namespace {

using contract::power_cells::MAX_NEIGHBORS;
using Values = std::vector<double>;

constexpr int max_newton_steps = 30;
constexpr int max_halvings = 12;
constexpr double solver_tolerance = 1e-4; ///< of the right side; Newton's method corrects the rest
constexpr int max_solver_steps = 400;

double inner_product(const Values& a, const Values& b)
{
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

/// The change of all areas by weights: each cell takes from, or gives to, its neighbours.
void exchange_areas(const PowerCells& cells, const Values& weights, Values& changes)
{
    for (std::size_t i = 0; i < weights.size(); ++i) {
        double change = 0;
        for (std::size_t k = i * MAX_NEIGHBORS; k < (i + 1) * MAX_NEIGHBORS; ++k) {
            if (cells.neighbours[k] == UINT32_MAX) break;
            change += cells.exchanges[k] * (weights[i] - weights[cells.neighbours[k]]);
        }
        changes[i] = change;
    }
}

/// Weights that change areas as wanted, nearly: conjugate gradients with a diagonal preconditioner. The sum of `wanted`
/// is zero.
Values weights_for(const PowerCells& cells, const Values& wanted)
{
    const std::size_t n = wanted.size();
    Values inverse(n);
    for (std::size_t i = 0; i < n; ++i) {
        double sum = 0;
        for (std::size_t k = i * MAX_NEIGHBORS; k < (i + 1) * MAX_NEIGHBORS; ++k) {
            if (cells.neighbours[k] == UINT32_MAX) break;
            sum += cells.exchanges[k];
        }
        inverse[i] = sum > 0 ? 1 / sum : 0;
    }
    Values weights(n), rest = wanted, scaled(n), direction(n), image(n);
    const auto precondition = [&] {
        for (std::size_t i = 0; i < n; ++i) scaled[i] = inverse[i] * rest[i];
    };
    precondition();
    direction = scaled;
    double product = inner_product(rest, scaled);
    const double enough = solver_tolerance * solver_tolerance * inner_product(wanted, wanted);
    for (int step = 0; step < max_solver_steps && inner_product(rest, rest) > enough; ++step) {
        exchange_areas(cells, direction, image);
        const double curvature = inner_product(direction, image);
        if (!(curvature > 0)) break;
        const double length = product / curvature;
        for (std::size_t i = 0; i < n; ++i) {
            weights[i] += length * direction[i];
            rest[i] -= length * image[i];
        }
        precondition();
        const double next = inner_product(rest, scaled);
        for (std::size_t i = 0; i < n; ++i) direction[i] = scaled[i] + next / product * direction[i];
        product = next;
    }
    return weights;
}

class Equalizer
{
public:
    Equalizer(const PointSet& points, const PowerCellsOf& cells_of)
        : cells_of_(cells_of), mean_(1 / static_cast<double>(points.size()))
    {
        result_.points = points;
        result_.weights.resize(points.size());
    }

    EqualAreas run(std::size_t iterations)
    {
        for (std::size_t iteration = 0;; ++iteration) {
            stop_if_interrupted();
            equalize();
            record();
            if (iteration == iterations) return std::move(result_);
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
        const Values values = lacking(cells);
        return std::sqrt(inner_product(values, values) / static_cast<double>(values.size())) / mean_;
    }

    static double smallest(const PowerCells& cells) { return std::ranges::min(cells.areas); }

    /// Newton's method from the weights that there are or, where these leave a cell without area, from none.
    void equalize()
    {
        result_.cells = cells_of_(result_.points, result_.weights);
        if (smallest(result_.cells) <= 0) {
            std::ranges::fill(result_.weights, 0);
            result_.cells = cells_of_(result_.points, result_.weights);
        }
        const double least = std::min(smallest(result_.cells), mean_) / 2;
        for (int step = 0; step < max_newton_steps && deviation(result_.cells) > equal_area_tolerance; ++step)
            if (!newton_step(least)) return;
    }

    /// The whole step, or half of it, and so on: the first that leaves no cell smaller than `least` and makes areas as
    /// much more equal as it should. False where there is none.
    bool newton_step(double least)
    {
        Values wanted = lacking(result_.cells);
        const double mean = std::accumulate(wanted.begin(), wanted.end(), 0.0) / static_cast<double>(wanted.size());
        for (double& value : wanted) value -= mean; // rounding
        const Values change = weights_for(result_.cells, wanted);
        const double before = deviation(result_.cells);
        double part = 1;
        for (int halving = 0; halving < max_halvings; ++halving, part /= 2) {
            Values weights = result_.weights;
            for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += part * change[i];
            PowerCells cells = cells_of_(result_.points, weights);
            if (!(smallest(cells) >= least && deviation(cells) <= (1 - part / 2) * before)) continue;
            result_.weights = std::move(weights);
            result_.cells = std::move(cells);
            return true;
        }
        return false;
    }

    void record()
    {
        const double integral = std::accumulate(result_.cells.energies.begin(), result_.cells.energies.end(), 0.0);
        const std::size_t n = result_.points.size();
        result_.iterations.push_back(
            {relative_radius(min_toroidal_distance(result_.points), n, 2), lloyd_energy(integral, n, 2)});
    }

    void move()
    {
        for (std::size_t i = 0; i < result_.points.coordinates.size(); ++i) {
            const double moved = result_.points.coordinates[i] + result_.cells.displacements[i];
            const double wrapped = moved - std::floor(moved);
            result_.points.coordinates[i] = wrapped < 1 ? wrapped : 0; // just below 0, the sum rounds to 1
        }
    }

    const PowerCellsOf& cells_of_;
    double mean_;
    EqualAreas result_;
};

}

EqualAreas equalize_areas(const PointSet& points, std::size_t iterations, const PowerCellsOf& cells_of)
{
    return Equalizer(points, cells_of).run(iterations);
}

}
