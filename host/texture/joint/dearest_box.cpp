#include "host/texture/joint/dearest_box.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace poissonlab {
namespace {

/// The costs of the seams at each place of a site, from (-T, -T) to (T, T).
class SeamMap
{
public:
    SeamMap(const Assembly& assembly, const Site& site)
        : size_(assembly.cover().size()), costs_(static_cast<std::size_t>(4 * size_ * size_))
    {
        const SetCover& cover = assembly.cover();
        for (const PlacedTile& tile : site.tiles)
            for (int y = 0; y < size_; ++y)
                for (int x = 0; x < size_; ++x) {
                    const SourcePixel here = assembly.source(cover.pixel(tile.tile, x, y)),
                                      east = assembly.source(cover.pixel(tile.tile, x + 1, y)),
                                      south = assembly.source(cover.pixel(tile.tile, x, y + 1));
                    costs_[at(x + tile.x, y + tile.y)] += assembly.seam_cost(here, east, Neighbour::east) +
                                                          assembly.seam_cost(here, south, Neighbour::south);
                }
    }

    std::int64_t cost(const SiteBox& box) const
    {
        std::int64_t sum = 0;
        for (int y = box.y; y < box.y + box.side; ++y)
            for (int x = box.x; x < box.x + box.side; ++x) sum += costs_[at(x, y)];
        return sum;
    }

private:
    std::size_t at(int x, int y) const { return static_cast<std::size_t>((y + size_) * 2 * size_ + x + size_); }

    int size_;
    std::vector<std::int64_t> costs_;
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
