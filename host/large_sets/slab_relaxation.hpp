// Steps of a method for a set that processes hold together in slabs, see host/sampling/slabs/slab_division.hpp.
//
// Before each step, processes send each other the points of the layers of cells around their slabs; then each moves its
// own, slab by slab, and sends those that have left to where they are. Where points farther away matter, as around
// empty parts of the torus, all do the step again with more layers.
#pragma once

#include "host/large_sets/slab_points.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/slabs/slab_mover.hpp"

#include <cstdint>
#include <functional>
#include <memory>

namespace poissonlab {

class SlabRelaxation
{
public:
    /// `slabs` for each process.
    SlabRelaxation(Device device, int dimension, std::uint64_t points, std::unique_ptr<SlabMethod> method,
                   std::uint32_t slabs, Crew& crew);

    /// The points as they are.
    SlabPoints& points() { return *points_; }
    const SlabDivision& division() const { return division_; }

    using OnIteration = std::function<void(std::size_t iteration, double relative_radius)>;

    /// Makes the iterations; then the points are those of the iterate that is kept. False where a process failed.
    bool run(const LloydRequest& request, const OnIteration& on_iteration);

    /// The iterate that is kept, and its relative radius.
    std::size_t kept() const { return kept_; }
    double relative_radius() const { return relative_radius_; }

private:
    bool make_step();
    bool move_slabs(bool& is_known, double& squared_near);
    double least_of_all(double value);

    int dimension_;
    std::uint64_t count_;
    SlabMover mover_;
    SlabDivision division_;
    Crew& crew_;
    std::uint32_t around_; ///< layers
    std::unique_ptr<SlabPoints> points_, moved_;
    double squared_near_ = 0; ///< of the points before the step
    std::size_t kept_ = 0;
    double relative_radius_ = 0;
};

}
