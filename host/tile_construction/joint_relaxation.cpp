#include "host/tile_construction/joint_relaxation.hpp"

#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/tile_construction/unit_circle.hpp"
#include "kernels/common/joint_nulling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// The gain is the part of a step down the gradient that is made: less takes longer, more overshoots.
constexpr double nulling_gain = 0.3;

/// Nulling reaches frequencies up to this many square roots of the points a tile: with less, power beyond them grows.
constexpr double nulling_reach = 2;

constexpr std::size_t default_work_group_size = 16;

class DeviceJointEngine final : public JointEngine
{
public:
    DeviceJointEngine(Device device, std::size_t work_group_size)
        : device_(std::move(device)), work_group_size_(work_group_size > 0 ? work_group_size : default_work_group_size)
    {
        const KernelProgram program = kernel_program("joint_nulling.cl", {});
        transform_ = device_.kernel(program, "transform_mean_tile");
        descend_ = device_.kernel(program, "descend");
    }

    std::vector<double> centroid_displacements(const PointSet& points) override
    {
        return voronoi_cells(device_, points).displacements;
    }

    std::vector<Displacement> nulling_displacements(std::span<const WeightedPoint> points,
                                                    std::uint32_t points_per_tile, double longest) override
    {
        const auto frequencies = nulled_frequencies(points_per_tile);
        upload(points, frequencies);
        const contract::joint_nulling::Nulling nulling{static_cast<std::uint32_t>(points.size()),
                                                       static_cast<std::uint32_t>(frequencies.size()),
                                                       nulling_step(points), longest};
        Buffers& b = buffers_;
        transform_.run(padded(frequencies.size()), work_group_size_, nulling, b.circle, b.positions, b.weights,
                       b.frequencies, b.transform);
        descend_.run(padded(points.size()), work_group_size_, nulling, b.circle, b.positions, b.weights, b.frequencies,
                     b.transform, b.displacements);
        const std::vector<double> numbers = b.displacements.read(0, 2 * points.size());
        std::vector<Displacement> displacements(points.size());
        for (std::size_t i = 0; i < points.size(); ++i)
            if (points[i].moves) displacements[i] = {numbers[2 * i], numbers[2 * i + 1]};
        return displacements;
    }

private:
    struct Buffers
    {
        Buffer<double> circle, weights, transform, displacements;
        Buffer<std::int32_t> positions, frequencies;

        NeededBuffers needed(std::size_t points, std::size_t frequency_count)
        {
            return {{circle, 2 * std::size_t{tile_units}},
                    {weights, points},
                    {positions, 2 * points},
                    {displacements, 2 * points},
                    {frequencies, 2 * frequency_count},
                    {transform, 2 * frequency_count}};
        }
    };

    std::size_t padded(std::size_t items) const
    {
        return (items + work_group_size_ - 1) / work_group_size_ * work_group_size_;
    }

    void upload(std::span<const WeightedPoint> points, const std::vector<std::array<std::int32_t, 2>>& frequencies)
    {
        const bool is_first = buffers_.circle.size() == 0;
        reserve(device_, buffers_.needed(points.size(), frequencies.size()));
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
        for (const WeightedPoint& point : points) {
            positions.insert(positions.end(), {point.position[0], point.position[1]});
            weights.push_back(point.weight);
        }
        for (const auto& frequency : frequencies) flat.insert(flat.end(), frequency.begin(), frequency.end());
        buffers_.positions.write(positions);
        buffers_.weights.write(weights);
        buffers_.frequencies.write(flat);
    }

    Device device_;
    std::size_t work_group_size_;
    Buffers buffers_;
    Kernel transform_, descend_;
};

}

std::vector<Displacement> JointEngine::mean_displacements(const JointTorus& torus, std::size_t stored)
{
    PointSet points{2, {}};
    const double size = static_cast<double>(torus.side) * tile_units;
    for (const PointCopy& copy : torus.copies)
        for (const std::int32_t x : copy.position) points.coordinates.push_back(x / size);
    const std::vector<double> each = centroid_displacements(points);
    std::vector<Displacement> sums(stored);
    std::vector<std::uint32_t> counts(stored);
    for (std::size_t i = 0; i < torus.copies.size(); ++i) {
        const std::uint32_t number = torus.copies[i].stored;
        for (std::size_t k = 0; k < 2; ++k) sums[number][k] += each[2 * i + k] * size;
        ++counts[number];
    }
    for (std::size_t i = 0; i < stored; ++i)
        for (double& sum : sums[i]) sum /= std::max<std::uint32_t>(1, counts[i]);
    return sums;
}

std::vector<std::array<std::int32_t, 2>> nulled_frequencies(std::uint32_t points_per_tile)
{
    const double reach = nulling_reach * std::sqrt(points_per_tile);
    const auto most = static_cast<std::int32_t>(std::floor(reach));
    std::vector<std::array<std::int32_t, 2>> frequencies;
    for (std::int32_t x = 0; x <= most; ++x)
        for (std::int32_t y = x == 0 ? 1 : -most; y <= most; ++y)
            if (std::hypot(x, y) <= reach) frequencies.push_back({x, y});
    return frequencies;
}

double nulling_step(std::span<const WeightedPoint> points)
{
    double squared = 0;
    for (const WeightedPoint& point : points)
        if (point.moves) squared += point.weight * point.weight;
    return nulling_gain * tile_units / (std::numbers::pi * squared);
}

std::unique_ptr<JointEngine> make_joint_engine(Device device, std::size_t work_group_size)
{
    return std::make_unique<DeviceJointEngine>(std::move(device), work_group_size);
}

}
