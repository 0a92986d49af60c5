// Relaxation dart throwing on the unit torus: dart throwing to a number of points, with a radius that is
// reduced where darts keep failing.
//
// McCool and Fiume, Hierarchical Poisson disk sampling distributions, Graphics Interface 1992; dissertation,
// sections 4.2.4.2 and 6.4. A dart becomes a point when no point is nearer than twice the radius. After
// `attempts` failures in a row (a success starts the count again) the radius is multiplied by `factor`.
//
// In a region of the plane or of space darts fall into the least box around it, and those outside the region fail as
// well.
//
// Darts are numbered. In 2D darts 2 j and 2 j + 1 are the first and the second two words of Philox at
// counter j, in 3D dart j is the first three: coordinates in units of 2^-32.
#pragma once

#include "base/geometry/point_set.hpp"
#include "base/random/random.hpp"
#include "base/regions/fixed_region.hpp"
#include "base/regions/fixed_space.hpp"
#include "base/regions/region_squares.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/sampler.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace poissonlab {

struct RelaxationDartThrowingRequest
{
    int dimension = 2;
    std::size_t points = 0;        ///< below 2^31
    double initial_radius = 0.15;  ///< r, half the minimum distance, in (0, 0.5], unit lengths
    double factor = 0.99;          ///< that the radius is multiplied by, in (0, 1)
    std::uint64_t attempts = 1000; ///< failures in a row until then, from 1 to max_relaxation_attempts
    StreamKey stream{};

    /// In 2D: the points lie in this region, in its fixed-point coordinates; initial_radius is at most 1/4. Empty:
    /// everywhere.
    std::shared_ptr<const FixedRegion> region{};

    /// In 3D: the points lie in this part of space, of which all holds that is said of `region`.
    std::shared_ptr<const FixedSpace> space{};

    /// Darts fall into these squares of the region, or cubes of the space; empty: into the box around it.
    std::shared_ptr<const RegionSquares<FixedRegion>> squares{};
    std::shared_ptr<const RegionSquares<FixedSpace>> cubes{};

    bool is_in_squares() const { return squares || cubes; }
};

/// Keeps counts of failures far from the end of 64 bits.
inline constexpr std::uint64_t max_relaxation_attempts = std::uint64_t{1} << 40;

struct RelaxationDarts
{
    PointSet points;         ///< in the order of acceptance: any prefix is a well spread set
    double radius = 0;       ///< r when the last point was accepted; points are at least 2 r apart
    std::uint64_t darts = 0; ///< thrown, up to and with the last point

    bool operator==(const RelaxationDarts&) const = default;
};

/// The radii that the algorithm goes through: level k has initial_radius * factor^k, by repeated
/// multiplication.
class RadiusLevels
{
public:
    explicit RadiusLevels(const RelaxationDartThrowingRequest& request)
        : radius_(request.initial_radius), factor_(request.factor)
    {}

    std::uint64_t level() const { return level_; }
    double radius() const { return radius_; }

    /// Darts are rejected by points at a smaller squared distance (units of 2^-64). At least 1, so that
    /// points do not coincide even where the radius has come to nothing.
    std::uint64_t squared_min_distance() const;

    void reduce()
    {
        radius_ *= factor_;
        ++level_;
    }

private:
    double radius_;
    double factor_;
    std::uint64_t level_ = 0;
};

namespace reference {
RelaxationDarts throw_relaxation_darts(const RelaxationDartThrowingRequest& request);
}

/// Throws darts by kernels/relaxation_dart_throwing.cl: every device finds the bytes of the reference.
class RelaxationDartThrower : DeviceMethod<struct RelaxationDartBuffers>
{
public:
    /// `work_group_size` 0: the default.
    explicit RelaxationDartThrower(Device device, std::size_t work_group_size = 0);

    RelaxationDarts throw_darts(const RelaxationDartThrowingRequest& request);

    /// The memory that throw_darts() takes.
    static DeviceMemory memory(const RelaxationDartThrowingRequest& request);
};

/// The sampler "relaxation-dart-throwing": initial_radius, factor, attempts.
SamplerSpec relaxation_dart_throwing_sampler();

}
