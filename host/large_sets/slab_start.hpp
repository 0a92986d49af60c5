// The set that relaxation in slabs begins with. Random points are made by all processes, each a share; any other set is
// made by the process that leads, in its memory, and shared out.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/large_sets/slab_points.hpp"

#include <cstdint>

namespace poissonlab {

class SlabStart
{
public:
    /// `request` is what the start is asked for.
    SlabStart(const SamplerChoice& choice, SampleRequest request, const DistributionPlace& place, Crew& crew)
        : choice_(choice), request_(std::move(request)), place_(place), crew_(crew)
    {}

    /// Random points can be made from any one on.
    static bool is_shared(const SamplerChoice& choice) { return choice.spec->name == "random"; }

    /// Makes what one process makes. False where that failed. The number of points is known afterwards.
    bool make();

    std::uint64_t points() const { return points_; }

    /// Puts the points into slabs, and forgets them. False where a process failed.
    bool put_into(SlabPoints& slabs);

private:
    bool shares() const { return is_shared(choice_); }
    std::vector<double> piece(std::uint64_t first, std::uint64_t end) const;

    const SamplerChoice& choice_;
    SampleRequest request_;
    const DistributionPlace& place_;
    Crew& crew_;
    std::uint64_t points_ = 0;
    PointSet set_; ///< of the process that leads, where it has made it
};

/// Puts the parts of `coarse_points` points into the slabs of a finer set, of which there are `points`, see
/// split_points(). False where a process failed.
bool put_parts(const SlabPoints& coarse, std::uint64_t coarse_points, SlabPoints& fine, std::uint64_t points,
               int dimension, Crew& crew);

}
