#include "host/tile_sampling/polyominoes/polyomino_kernel.hpp"

#include "kernels/common/tile_sampling/polyominoes.h"

#include <algorithm>
#include <utility>

namespace poissonlab {
namespace {

std::array<std::int32_t, 4> packed(const Pose& pose, std::uint32_t tile_class = 0)
{
    return {static_cast<std::int32_t>(pose.shift.x), static_cast<std::int32_t>(pose.shift.y), pose.turn,
            static_cast<std::int32_t>(tile_class)};
}

}

NeededBuffers PolyominoGenerator::Buffers::needed(const Sizes& sizes)
{
    return {{order, sizes.roots},       {next, sizes.classes * sizes.children},   {tiles, sizes.tiles},
            {children, sizes.children}, {corrections, sizes.classes * sizes.row}, {points, sizes.points}};
}

PolyominoGenerator::PolyominoGenerator(Device device, Polyomino shape, std::size_t work_group_size)
    : device_(std::move(device)),
      work_group_size_(work_group_size > 0 ? work_group_size
                                           : std::min<std::size_t>(256, device_.info().max_work_group_size)),
      place_points_(device_.kernel(
          kernel_program("polyominoes.cl", {{"FACTOR", factor_of(shape)}, {"CELL_UNITS", cell_units}}), "place_points"))
{}

DeviceMemory PolyominoGenerator::memory(Polyomino shape, std::uint32_t side, std::size_t points)
{
    const PolyominoCounts counts(shape, side);
    const std::uint32_t level = counts.level_of(static_cast<double>(points));
    std::size_t tiles = counts.roots;
    for (std::uint32_t i = 0; i < first_level_of(shape); ++i) tiles *= counts.children;
    const std::size_t classes = shape == Polyomino::P ? 58 : 188;
    return memory_of(Buffers{}.needed(
        {counts.roots, tiles, counts.children, classes, counts.row_of(static_cast<double>(points), level), points}));
}

PointSet PolyominoGenerator::points(const PolyominoTorus& torus, std::size_t points)
{
    const PolyominoTable& table = torus.table();
    const Neighbourhoods& all = table.neighbourhoods;
    const std::uint32_t level = torus.counts().level_of(static_cast<double>(points));
    const std::uint32_t row = torus.counts().row_of(static_cast<double>(points), level);
    std::vector<std::array<std::int32_t, 4>> tiles, children;
    for (std::size_t i = 0; i < torus.first_tiles().size(); ++i)
        tiles.push_back(packed(torus.first_tiles()[i], torus.first_classes()[i]));
    for (const Pose& child : all.rule.children) children.push_back(packed(child));
    reserve(device_,
            buffers_.needed({torus.order().size(), tiles.size(), children.size(), all.collars.size(), row, points}));
    buffers_.order.write(torus.order());
    buffers_.next.write(all.next);
    buffers_.tiles.write(tiles);
    buffers_.children.write(children);
    buffers_.corrections.write(table.rows[row - 1]);
    const LatticePlace anchor = anchor_of(all.rule.shape);
    const auto side = static_cast<std::uint64_t>(torus.side_units(level));
    const contract::polyominoes::Torus header{.roots = static_cast<std::uint32_t>(torus.counts().roots),
                                              .first_level = all.first_level,
                                              .depth = table.depth,
                                              .level = level,
                                              .row = row,
                                              .count = static_cast<std::uint32_t>(points),
                                              .side = side,
                                              .anchor_x = static_cast<int>(anchor.x),
                                              .anchor_y = static_cast<int>(anchor.y)};
    place_points_.run(points, work_group_size_, header, buffers_.order, buffers_.tiles, buffers_.children,
                      buffers_.next, buffers_.corrections, buffers_.points);
    PointSet set{2, {}};
    set.coordinates.reserve(2 * points);
    for (const auto& place : buffers_.points.read(0, points))
        for (const std::uint64_t c : place)
            set.coordinates.push_back(static_cast<double>(c) / static_cast<double>(side));
    return set;
}

}
