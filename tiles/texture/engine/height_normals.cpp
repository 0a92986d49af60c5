#include "tiles/texture/engine/height_normals.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Heights on the torus that a packed atlas is.
class PackedHeights
{
public:
    PackedHeights(const EngineMap& map, const TextureSet& set, double relief)
        : map_(map), size_(set.size), is_wang_(!set.has_corners()), relief_(relief)
    {}

    /// The slopes to the east and to the north.
    std::pair<double, double> slopes(int column, int row) const
    {
        const int in_column = column % size_, in_row = row % size_;
        const bool is_at_corner = (in_column == 0 || in_column == size_ - 1) && (in_row == 0 || in_row == size_ - 1);
        int west = column - 1, east = column + 1;
        if (is_wang_ && is_at_corner) (in_column == 0 ? west : east) = column;
        return {relief_ * (at(east, row) - at(west, row)) / (east - west),
                relief_ * (at(column, row - 1) - at(column, row + 1)) / 2};
    }

private:
    double at(int column, int row) const
    {
        const auto x = static_cast<std::size_t>((column + map_.width) % map_.width),
                   y = static_cast<std::size_t>((row + map_.height) % map_.height);
        return map_.values[y * static_cast<std::size_t>(map_.width) + x];
    }

    const EngineMap& map_;
    int size_;
    bool is_wang_;
    double relief_;
};

void check_heights(const EngineMap& heights, const TextureSet& set)
{
    if (heights.channels != 1)
        throw InputError(fmt::format("{} has {} channels: heights must have 1", heights.name, heights.channels));
    if (!has_places(set))
        throw InputError(
            fmt::format("normals of {}: must be of a complete set of corner or Wang tiles, whose neighbours "
                        "in the atlas have the texels of those in a tiling",
                        heights.name));
    if (set.ring < 1)
        throw InputError(fmt::format("normals of {}: tiles must have a ring of at least 1 texel", heights.name));
}

}

EngineMap height_normals(const EngineMap& heights, const TextureSet& set, double relief)
{
    check_heights(heights, set);
    EngineMap normals{
        heights.name + "-normals", MapMeaning::directions, SampleType::word, heights.width, heights.height, 3, {}};
    normals.values.reserve(3 * heights.values.size());
    const double unit = heights.type == SampleType::byte ? 255 : heights.type == SampleType::word ? 65535 : 1;
    const PackedHeights packed(heights, set, relief / unit);
    for (int row = 0; row < heights.height; ++row)
        for (int column = 0; column < heights.width; ++column) {
            const auto [east, north] = packed.slopes(column, row);
            const double length = std::sqrt(east * east + north * north + 1);
            for (const double part : {-east, -north, 1.0}) normals.values.push_back(part / length);
        }
    return normals;
}

}
