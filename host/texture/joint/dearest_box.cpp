#include "host/texture/joint/dearest_box.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace poissonlab {
namespace {

/// Where boxes of a site may begin: from the first places to the last ones.
struct BoxRange
{
    int left, top, right, bottom;
};

/// The costs of the seams of a site where boxes lie, summed from the corner (-T, -T) of all that it shows to each
/// place.
class SeamMap
{
public:
    SeamMap(const Assembly& assembly, const Site& site, const BoxRange& range, int side)
        : size_(assembly.cover().size()), line_(static_cast<std::size_t>(2 * size_ + 1)), sums_(line_ * line_)
    {
        for (const PlacedTile& tile : site.tiles) add_seams(assembly, tile, range, side);
        for (std::size_t i = line_ + 1; i < sums_.size(); ++i)
            if (i % line_ != 0) sums_[i] += sums_[i - 1] + sums_[i - line_] - sums_[i - line_ - 1];
    }

    std::int64_t cost(const SiteBox& box) const
    {
        const int right = box.x + box.side, below = box.y + box.side;
        return sums_[at(right, below)] - sums_[at(box.x, below)] - sums_[at(right, box.y)] + sums_[at(box.x, box.y)];
    }

private:
    /// The place of the sum of all that is west and north of a place.
    std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y + size_) * line_ + static_cast<std::size_t>(x + size_);
    }

    void add_seams(const Assembly& assembly, const PlacedTile& tile, const BoxRange& range, int side)
    {
        const SetCover& cover = assembly.cover();
        const int right = std::min(size_, range.right + side - tile.x),
                  bottom = std::min(size_, range.bottom + side - tile.y);
        for (int y = std::max(0, range.top - tile.y); y < bottom; ++y)
            for (int x = std::max(0, range.left - tile.x); x < right; ++x) {
                const SourcePixel here = assembly.source(cover.pixel(tile.tile, x, y)),
                                  east = assembly.source(cover.pixel(tile.tile, x + 1, y)),
                                  south = assembly.source(cover.pixel(tile.tile, x, y + 1));
                sums_[at(x + tile.x + 1, y + tile.y + 1)] +=
                    assembly.seam_cost(here, east, Neighbour::east) + assembly.seam_cost(here, south, Neighbour::south);
            }
    }

    int size_;
    std::size_t line_;
    std::vector<std::int64_t> sums_;
};

}

std::optional<SiteBox> dearest_box(const Assembly& assembly, const Site& site, int side, const BoxPlaces& left_out)
{
    const int half = assembly.cover().size() / 2, step = std::max(1, half / 4);
    const bool is_fixed_x = site.kind == Site::Kind::corner || site.kind == Site::Kind::vertical_edge;
    const bool is_fixed_y = site.kind == Site::Kind::corner || site.kind == Site::Kind::horizontal_edge;
    const BoxRange range{is_fixed_x ? -side / 2 : -half, is_fixed_y ? -side / 2 : -half,
                         is_fixed_x ? -side / 2 : half - side, is_fixed_y ? -side / 2 : half - side};
    const SeamMap map(assembly, site, range, side);
    std::optional<SiteBox> dearest;
    std::int64_t most = 0;
    for (int y = range.top; y <= range.bottom; y += step)
        for (int x = range.left; x <= range.right; x += step) {
            if (left_out.contains({x, y})) continue;
            const std::int64_t cost = map.cost({x, y, side});
            if (cost <= most) continue;
            most = cost;
            dearest = {x, y, side};
        }
    return dearest;
}

}
