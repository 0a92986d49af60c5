#include "host/texture/joint/dearest_box.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace poissonlab {
namespace {

/// The costs of the seams of a site, summed from its corner (-T, -T) to each place up to (T, T).
class SeamMap
{
public:
    SeamMap(const Assembly& assembly, const Site& site)
        : size_(assembly.cover().size()), line_(static_cast<std::size_t>(2 * size_ + 1)), sums_(line_ * line_)
    {
        for (const PlacedTile& tile : site.tiles) add_seams(assembly, tile);
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

    void add_seams(const Assembly& assembly, const PlacedTile& tile)
    {
        const SetCover& cover = assembly.cover();
        for (int y = 0; y < size_; ++y)
            for (int x = 0; x < size_; ++x) {
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
    const SeamMap map(assembly, site);
    const int half = assembly.cover().size() / 2, step = std::max(1, half / 4);
    const bool is_fixed_x = site.kind == Site::Kind::corner || site.kind == Site::Kind::vertical_edge;
    const bool is_fixed_y = site.kind == Site::Kind::corner || site.kind == Site::Kind::horizontal_edge;
    std::optional<SiteBox> dearest;
    std::int64_t most = 0;
    for (int y = is_fixed_y ? -side / 2 : -half; y + side <= half; y += step) {
        for (int x = is_fixed_x ? -side / 2 : -half; x + side <= half; x += step) {
            if (!left_out.contains({x, y}))
                if (const std::int64_t cost = map.cost({x, y, side}); cost > most) {
                    most = cost;
                    dearest = {x, y, side};
                }
            if (is_fixed_x) break;
        }
        if (is_fixed_y) break;
    }
    return dearest;
}

}
