// Moves the points of slabs, one slab after the other, by a method's step on a device.
//
// The torus in slabs: layers of grid cells side by side along the last axis. A method whose grid cells are those of the
// whole torus, and that looks at points some layers away at most, does the same in a slab with so many layers around it
// as in the torus: the same points in the same order, and so the same bytes.
#pragma once

#include "host/sampling/cells/point_grid.hpp"
#include "host/sampling/slabs/slab_method.hpp"

#include <algorithm>
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

class SlabDivision
{
public:
    /// `cells_per_axis` layers in so many slabs, as equal as layers allow; some are empty where there are more slabs
    /// than layers.
    SlabDivision(std::uint32_t cells_per_axis, int dimension, std::uint32_t slabs)
        : cells_per_axis_(cells_per_axis), dimension_(dimension), slabs_(slabs), slab_of_layer_(cells_per_axis)
    {
        for (std::uint32_t slab = 0; slab < slabs; ++slab)
            std::fill(slab_of_layer_.begin() + first_layer(slab), slab_of_layer_.begin() + first_layer(slab + 1), slab);
    }

    int dimension() const { return dimension_; }
    std::uint32_t layers() const { return cells_per_axis_; }
    std::uint32_t slabs() const { return slabs_; }

    /// The first layer of a slab; of a slab after the last, the number of layers.
    std::uint32_t first_layer(std::uint32_t slab) const
    {
        return static_cast<std::uint32_t>(std::uint64_t{slab} * cells_per_axis_ / slabs_);
    }

    /// The layer of a last coordinate in [0, 1), as kernels/point_grid.cl has it.
    std::uint32_t layer_of(double last) const
    {
        return std::min(static_cast<std::uint32_t>(last * cells_per_axis_), cells_per_axis_ - 1);
    }

    std::uint32_t slab_of(double last) const { return slab_of_layer_[layer_of(last)]; }

    /// The cells of a slab that is not empty, with so many layers around it.
    GridPart part(std::uint32_t slab, std::uint32_t around) const
    {
        return layers_of_grid(cells_per_axis_, dimension_, first_layer(slab), first_layer(slab + 1), around);
    }

    /// For each layer the slabs that have it around them.
    std::vector<std::vector<std::uint32_t>> slabs_around_layers(std::uint32_t around) const;

private:
    std::uint32_t cells_per_axis_;
    int dimension_;
    std::uint32_t slabs_;
    std::vector<std::uint32_t> slab_of_layer_;
};

}
