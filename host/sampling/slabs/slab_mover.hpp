// Moves the points of slabs, one slab after the other, by a method's step on a device.
#pragma once

#include "host/sampling/slabs/slab_method.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace poissonlab {

// Points of a part of a set, with their numbers in the set.

struct NumberedPoints
{
    std::vector<double> coordinates; ///< dimension values a point, in [0, 1)
    std::vector<std::uint32_t> ids;

    std::size_t size() const { return ids.size(); }

    void add(std::span<const double> place, std::uint32_t id)
    {
        coordinates.insert(coordinates.end(), place.begin(), place.end());
        ids.push_back(id);
    }

    void clear()
    {
        coordinates.clear();
        ids.clear();
    }
};

class SlabMover
{
public:
    SlabMover(Device device, int dimension, std::unique_ptr<SlabMethod> method)
        : device_(std::move(device)), dimension_(dimension), method_(std::move(method))
    {}

    const SlabMethod& method() const { return *method_; }

    /// The device memory that it takes for so many points in a part of the grid, with those around.
    static DeviceMemory memory(const SlabMethod& method, int dimension, std::size_t points, const GridPart& part)
    {
        return PointGrid::memory(dimension, with_slack(points), part) + method.memory(with_slack(points));
    }

    struct Moved
    {
        NumberedPoints points;   ///< those of the slab, after the step
        double squared_near = 0; ///< of the nearest two before it, of which one is in the slab
    };

    /// `own` are the points in cells that are asked about, at least one, `around` those of the other cells that are
    /// held. Null where points of more layers matter; else it stays until the next call. Throws InputError where the
    /// device has no room for so many points.
    const Moved* move(const GridPart& part, const NumberedPoints& own, const NumberedPoints& around);

private:
    /// Points come and go, and room is made anew seldom.
    static std::size_t with_slack(std::size_t points) { return points + points / 32; }

    void make_room(const GridPart& part, std::size_t points);

    Device device_;
    int dimension_;
    std::unique_ptr<SlabMethod> method_;
    std::optional<PointGrid> grid_;
    std::size_t room_ = 0; ///< points
    GridPart largest_{};
    Moved moved_;
    std::vector<double> read_; ///< displacements, and squared distances
};

}
