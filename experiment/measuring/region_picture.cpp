#include "experiment/measuring/region_picture.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

constexpr double longest_side = 4096; ///< of the picture: its numbers have two decimals
constexpr std::size_t most_dots = 100'000;

}

MarkPicture region_picture_of(const FramedRegion& region, const PointSet& points)
{
    const RegionBox box = box_of(region.polygons());
    const double margin = longest_side / 100, scale = (longest_side - 2 * margin) / box.longest();
    const auto placed = [&](double x, double y) {
        return std::array{margin + (x - box.low[0]) * scale, margin + (y - box.low[1]) * scale};
    };
    MarkPicture picture{box.width() * scale + 2 * margin, box.height() * scale + 2 * margin};
    MarkGroup lines{"#8a8f98"}, dots{"#000000"};
    for (const RegionEdge& e : region.boundary().edges()) {
        const auto [x0, y0] = placed(e.from[0], e.from[1]);
        const auto [x1, y1] = placed(e.to[0], e.to[1]);
        lines.strokes.push_back({x0, y0, x1, y1, longest_side / 500});
    }
    const double spacing = region.unit_length() / std::sqrt(static_cast<double>(points.size()));
    const double radius = std::min(spacing * scale / 5, longest_side / 200);
    for (std::size_t i = 0; i < std::min(points.size(), most_dots); ++i) {
        const auto [x, y] = placed(points[i][0], points[i][1]);
        dots.disks.push_back({x, y, radius});
    }
    picture.groups = {std::move(lines), std::move(dots)};
    return picture;
}

}
