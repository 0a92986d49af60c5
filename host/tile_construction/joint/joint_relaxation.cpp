#include "host/tile_construction/joint/joint_relaxation.hpp"

#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "kernels/common/tiles/joint_nulling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// The gain is the part of a step down the gradient that is made: less takes longer, more overshoots.
constexpr double nulling_gain = 0.3;

constexpr std::size_t joint_group_size = 16;

struct JointBuffers
{
    Buffer<double> circle, weights, transform, displacements;
    Buffer<std::int32_t> positions, frequencies;

    NeededBuffers needed(std::size_t axes, std::size_t points, std::size_t frequency_count)
    {
        return {{circle, 2 * std::size_t{tile_units}},
                {weights, points},
                {positions, axes * points},
                {displacements, axes * points},
                {frequencies, axes * frequency_count},
                {transform, 2 * frequency_count}};
    }
};

class DeviceJointEngine final : public JointEngine
{
public:
    DeviceJointEngine(int dimension, Device device, std::size_t work_group_size)
        : dimension_(dimension), device_(std::move(device)),
          work_group_size_(work_group_size > 0 ? work_group_size : joint_group_size)
    {
        const KernelProgram program = kernel_program("joint_nulling.cl", {{"DIMENSION", dimension}});
        transform_ = device_.kernel(program, "transform_mean_tile");
        descend_ = device_.kernel(program, "descend");
    }

    std::vector<double> centroid_displacements(const PointSet& points) override
    {
        return voronoi_cells(device_, points).displacements;
    }

    std::vector<Displacement> nulling_displacements(std::span<const WeightedPoint> points,
                                                    std::span<const TileFrequency> frequencies, double longest) override
    {
        upload(points, frequencies);
        const contract::joint_nulling::Nulling nulling{static_cast<std::uint32_t>(points.size()),
                                                       static_cast<std::uint32_t>(frequencies.size()),
                                                       nulling_step(points), longest};
        JointBuffers& b = buffers_;
        transform_.run(padded(frequencies.size()), work_group_size_, nulling, b.circle, b.positions, b.weights,
                       b.frequencies, b.transform);
        descend_.run(padded(points.size()), work_group_size_, nulling, b.circle, b.positions, b.weights, b.frequencies,
                     b.transform, b.displacements);
        const std::vector<double> numbers = b.displacements.read(0, axes() * points.size());
        std::vector<Displacement> displacements(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            if (points[i].moves) std::copy_n(&numbers[axes() * i], axes(), displacements[i].begin());
        return displacements;
    }

private:
    std::size_t axes() const { return static_cast<std::size_t>(dimension_); }

    std::size_t padded(std::size_t items) const
    {
        return (items + work_group_size_ - 1) / work_group_size_ * work_group_size_;
    }

    void upload(std::span<const WeightedPoint> points, std::span<const TileFrequency> frequencies)
    {
        const bool is_first = buffers_.circle.size() == 0;
        reserve(device_, buffers_.needed(axes(), points.size(), frequencies.size()));
        if (is_first) {
            std::vector<double> circle;
            for (const std::complex<double>& number : unit_circle()) {
                circle.push_back(number.real());
                circle.push_back(number.imag());
            }
            buffers_.circle.write(circle);
        }
        std::vector<std::int32_t> positions, flat;
        std::vector<double> weights;
        const auto append = [this](std::vector<std::int32_t>& all, const std::array<std::int32_t, 3>& one) {
            all.insert(all.end(), one.begin(), one.begin() + dimension_);
        };
        for (const WeightedPoint& point : points) {
            append(positions, point.position);
            weights.push_back(point.weight);
        }
        for (const TileFrequency& frequency : frequencies) append(flat, frequency);
        buffers_.positions.write(positions);
        buffers_.weights.write(weights);
        buffers_.frequencies.write(flat);
    }

    int dimension_;
    Device device_;
    std::size_t work_group_size_;
    JointBuffers buffers_;
    Kernel transform_, descend_;
};

}

const std::vector<std::complex<double>>& unit_circle()
{
    static const auto circle = [] {
        std::vector<std::complex<double>> values;
        for (std::int32_t n = 0; n < tile_units; ++n) {
            const double angle = -2 * std::numbers::pi * n / tile_units;
            values.emplace_back(std::cos(angle), std::sin(angle));
        }
        return values;
    }();
    return circle;
}

std::vector<Displacement> JointEngine::mean_displacements(const JointTorus& torus, std::size_t stored)
{
    const auto axes = static_cast<std::size_t>(torus.dimension);
    PointSet points{torus.dimension, {}};
    const double size = static_cast<double>(torus.side) * tile_units;
    for (const PointCopy& copy : torus.copies)
        for (std::size_t k = 0; k < axes; ++k) points.coordinates.push_back(copy.position[k] / size);
    const std::vector<double> each = centroid_displacements(points);
    std::vector<Displacement> sums(stored);
    std::vector<std::uint32_t> counts(stored);
    for (std::size_t i = 0; i < torus.copies.size(); ++i) {
        const std::uint32_t number = torus.copies[i].stored;
        for (std::size_t k = 0; k < axes; ++k) sums[number][k] += each[axes * i + k] * size;
        ++counts[number];
    }
    for (std::size_t i = 0; i < stored; ++i)
        for (double& sum : sums[i]) sum /= std::max<std::uint32_t>(1, counts[i]);
    return sums;
}

std::vector<TileFrequency> nulled_frequencies(std::uint32_t points_per_tile, int dimension, double reach)
{
    const double squared_root = dimension == 2 ? points_per_tile : std::pow(std::cbrt(points_per_tile), 2);
    const double squared_reach = reach * reach * squared_root;
    const auto most = static_cast<std::int32_t>(std::floor(std::sqrt(squared_reach)));
    const std::int32_t above = dimension == 2 ? 0 : most;
    std::vector<TileFrequency> frequencies;
    for (std::int32_t x = 0; x <= most; ++x)
        for (std::int32_t y = x == 0 ? 0 : -most; y <= most; ++y)
            for (std::int32_t z = x == 0 && y == 0 ? 1 : -above; z <= above; ++z)
                if (x * x + y * y + z * z <= squared_reach) frequencies.push_back({x, y, z});
    return frequencies;
}

double nulling_step(std::span<const WeightedPoint> points)
{
    double squared = 0;
    for (const WeightedPoint& point : points)
        if (point.moves) squared += point.weight * point.weight;
    return nulling_gain * tile_units / (std::numbers::pi * squared);
}

DeviceMemory joint_memory(int dimension, std::size_t copies, std::size_t stored, std::uint32_t points_per_tile)
{
    const std::size_t frequencies = nulled_frequencies(points_per_tile, dimension).size();
    return voronoi_memory(dimension, copies) +
           memory_of(JointBuffers{}.needed(static_cast<std::size_t>(dimension), stored, frequencies));
}

std::unique_ptr<JointEngine> make_joint_engine(int dimension, Device device, std::size_t work_group_size)
{
    return std::make_unique<DeviceJointEngine>(dimension, std::move(device), work_group_size);
}

}
