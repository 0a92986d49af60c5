// Steps of a method, and its beginning, for a set that processes hold together in slabs, see
// host/sampling/slabs/slab_mover.hpp.
//
// Before each step, processes send each other the points of the layers of cells around their slabs; then each moves its
// own, slab by slab, and sends those that have left to where they are. Where points farther away matter, as around
// empty parts of the torus, all do the step again with more layers.
#pragma once

#include "host/device/device.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/large_sets/slab_points.hpp"
#include "host/sampling/lloyd_iteration.hpp"
#include "host/sampling/slabs/slab_method.hpp"
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

/// The set that relaxation in slabs begins with. Random points are made by all processes, each a share; any other set
/// is made by the process that leads, in its memory, and shared out.
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

// The division of a set into slabs, and the memory that this takes, are said and checked before any work.

/// The set that is to be relaxed, and by how many processes.
struct SlabTask
{
    int dimension = 2;
    std::uint64_t points = 0;
    std::uint32_t processes = 1;
    std::uint32_t processes_here = 1;  ///< on this machine, which share its device
    std::uint32_t least_slabs = 1;     ///< of each process, which all have as many
    std::uint64_t most_slab_bytes = 0; ///< that a slab may take on the device
    bool keeps_best = false;           ///< has a copy of the best iterate
    bool shares_start = true;          ///< else the first process has it as a whole
};

struct SlabPlan
{
    std::uint32_t slabs = 1;         ///< of each process
    std::uint64_t slab_bytes = 0;    ///< on the device
    std::uint64_t process_bytes = 0; ///< in all, the most that a process takes where points are spread evenly
};

/// Chooses as few slabs as fit in memory, or, on processors, some more, which are faster. Throws InputError, about the
/// options --memory and --points, where no number of slabs fits, or where processes have not the memory that they need,
/// with the largest set that would fit.
SlabPlan plan_slabs(const SlabMethod& method, const SlabTask& task, const DeviceInfo& device);

}
