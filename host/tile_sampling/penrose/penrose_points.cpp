#include "host/tile_sampling/penrose/penrose_points.hpp"

#include "host/device/needed_buffers.hpp"
#include "host/tile_sampling/penrose/penrose_walk.hpp"
#include "tiles/penrose/penrose_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

using namespace contract::penrose;

constexpr double root_scale = 2; ///< of level 0, in sides of the unit square
constexpr double golden_inverse = 0.6180339887498949;
constexpr double row_ratio = 1.0468929862265312; ///< phi^(2/21): as many of it lead from one level to the next

/// Cosines of multiples of 18 degrees.
constexpr std::array<double, 6> cosines{
    1, 0.95105651629515357, 0.80901699437494742, 0.58778525229247313, 0.30901699437494742, 0};

double cosine(std::size_t turn)
{
    turn %= 20;
    if (turn > 10) turn = 20 - turn;
    return turn <= 5 ? cosines[turn] : -cosines[10 - turn];
}

std::int64_t fixed(double value, int bits) { return std::llround(std::ldexp(value, bits)); }

double longest(const PenroseTable& table)
{
    double squared = 0;
    for (const auto& row : table.rows)
        for (const PenroseVector& v : row)
            squared = std::max(squared, static_cast<double>(v.along) * v.along + static_cast<double>(v.left) * v.left);
    return std::ldexp(std::sqrt(squared), -vector_bits);
}

void set_directions(PenroseScale& scale, double length)
{
    for (std::size_t k = 0; k < 4; ++k) {
        scale.axis_x[k] = fixed(length * cosine(2 * k), FRACTION_BITS);
        scale.axis_y[k] = fixed(length * cosine(2 * k + 15), FRACTION_BITS); // a sine: 270 degrees on
    }
    for (std::size_t turn = 0; turn < TURNS; ++turn) {
        scale.turn_x[turn] = fixed(length * cosine(turn), FRACTION_BITS - vector_bits);
        scale.turn_y[turn] = fixed(length * cosine(turn + 15), FRACTION_BITS - vector_bits);
    }
}

/// Rows begin at equal ratios behind the last importance of the level before.
void set_rows(PenroseScale& scale)
{
    auto begin = static_cast<double>(scale.ones[0]);
    for (ulong& row : scale.rows) {
        row = static_cast<std::uint64_t>(begin) + 1;
        begin *= row_ratio;
    }
}

using contract::penrose::Tile;

/// Enough for all cores of a device.
constexpr std::size_t start_triangles = 4096;

/// A level has at most 3 triangles for each of the level before.
constexpr std::size_t most_start_triangles = 3 * start_triangles;

}

std::uint64_t most_penrose_importance() { return fibonacci(2 * DEEPEST + 2); }

PenroseScales penrose_scales(const PenroseTable& table)
{
    PenroseScales scales{};
    double length = root_scale;
    const double reach = longest(table);
    for (std::size_t level = 0; level < scales.size(); ++level) {
        PenroseScale& scale = scales[level];
        const int even = 2 * static_cast<int>(level);
        scale.ones[0] = fibonacci(even);
        scale.ones[1] = fibonacci(even + 1);
        set_directions(scale, length);
        set_rows(scale);
        length *= golden_inverse;
        // Its points are one level deeper at least. A little more is for rounding.
        scale.reach = fixed(reach * length, FRACTION_BITS) + (1 << 26);
    }
    return scales;
}

PenroseRow row_of_importance(const PenroseScales& scales, std::uint64_t importance)
{
    PenroseRow found{0, 0};
    while (scales[found.level + 1].ones[0] < importance) ++found.level;
    while (found.row + 1 < ROWS && scales[found.level].rows[found.row + 1] <= importance) ++found.row;
    return found;
}

ImportanceRange importances_of(const PenroseScales& scales, const PenroseRow& row)
{
    const bool is_last = row.row + 1 == ROWS;
    return {scales[row.level].rows[row.row],
            is_last ? scales[row.level + 1].rows[0] : scales[row.level].rows[row.row + 1]};
}

PenroseStart start_penrose(const PenroseTiling& tiling, std::uint64_t importance, const PenroseWindow& window)
{
    const PenroseWalk walk(tiling, importance, window);
    PenroseStart start;
    std::vector<PenroseTile> triangles{PenroseTile{}}, next;
    while (!triangles.empty() && triangles.size() < start_triangles) {
        next.clear();
        for (const PenroseTile& triangle : triangles) {
            if (!walk.needs(triangle)) continue;
            for (const PenroseTile& child : divided(triangle))
                is_point(child) ? walk.keep(child, start.points) : next.push_back(child);
        }
        triangles.swap(next);
    }
    for (const PenroseTile& triangle : triangles) start.triangles.push_back(record_of(triangle));
    return start;
}

PointSet point_set_of(const std::vector<PenrosePoint>& points)
{
    PointSet set;
    set.coordinates.reserve(2 * points.size());
    for (const PenrosePoint& point : points)
        for (const std::uint32_t c : point.place) set.coordinates.push_back(c * 0x1p-32);
    return set;
}

struct PenroseBuffers
{
    Buffer<PenroseScale> scales;
    Buffer<PenroseVector> vectors;
    Buffer<std::uint64_t> weights;
    Buffer<Tile> tiles;
    Buffer<std::uint32_t> counts, starts;
    Buffer<std::array<std::uint32_t, 2>> points;
    Kernel count, write;

    NeededBuffers of_tiling(std::size_t weight_count)
    {
        return {{scales, std::tuple_size_v<PenroseScales>},
                {vectors, std::size_t{contract::penrose::ROWS} * contract::penrose::INDICES},
                {weights, weight_count}};
    }

    NeededBuffers of_start()
    {
        return {{tiles, most_start_triangles}, {counts, most_start_triangles}, {starts, most_start_triangles}};
    }

    NeededBuffers of_points(std::size_t count_) { return {{points, count_}}; }
};

PenroseGenerator::PenroseGenerator(Device device, const PenroseTiling& tiling, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<PenroseBuffers>()), tiling_(&tiling)
{
    PenroseBuffers& b = *buffers_;
    const KernelProgram program = kernel_program("penrose.cl", {});
    b.count = device_.kernel(program, "count_points");
    b.write = device_.kernel(program, "write_points");
    reserve(device_, b.of_tiling(tiling.density.weights.size()));
    reserve(device_, b.of_start());
    b.scales.write(tiling.scales);
    b.weights.write(tiling.density.weights);
    for (std::size_t row = 0; row < tiling.table.rows.size(); ++row)
        b.vectors.write(tiling.table.rows[row], row * tiling.table.rows[row].size());
}

PointSet PenroseGenerator::points(std::uint64_t importance, const PenroseWindow& window)
{
    const PenroseTiling& tiling = *tiling_;
    PenroseBuffers& b = *buffers_;
    PenroseStart start = start_penrose(tiling, importance, window);
    const std::size_t triangles = start.triangles.size();
    const contract::penrose::Request request{.importance = importance,
                                             .low_x = window.low[0],
                                             .low_y = window.low[1],
                                             .side = static_cast<std::int64_t>(window.side),
                                             .root_x = penrose_root[0],
                                             .root_y = penrose_root[1],
                                             .width = tiling.density.width,
                                             .height = tiling.density.height,
                                             .tiles = static_cast<std::uint32_t>(triangles),
                                             .unused = 0};
    b.tiles.write(start.triangles);
    b.count.run(triangles, work_group_size_, request, b.scales, b.vectors, b.weights, b.tiles, b.counts);
    std::vector<std::uint32_t> starts = b.counts.read(0, triangles);
    std::uint32_t total = 0;
    for (std::uint32_t& begin : starts) total += std::exchange(begin, total);
    b.starts.write(starts);
    reserve(device_, b.of_points(std::max(1U, total)));
    b.write.run(triangles, work_group_size_, request, b.scales, b.vectors, b.weights, b.tiles, b.starts, b.points);
    PointSet set = point_set_of(start.points);
    for (const auto& place : b.points.read(0, total))
        for (const std::uint32_t c : place) set.coordinates.push_back(c * 0x1p-32);
    return set;
}

DeviceMemory PenroseGenerator::memory(std::size_t points, std::size_t weights)
{
    PenroseBuffers buffers;
    return memory_of(buffers.of_tiling(weights)) + memory_of(buffers.of_start()) + memory_of(buffers.of_points(points));
}

}
