#include "host/tile_construction/recursive/tile_views.hpp"

namespace poissonlab {
namespace {

std::array<std::vector<TileView>, even_wang_tiles> all_views()
{
    std::array<std::vector<TileView>, even_wang_tiles> views;
    for (std::size_t tile = 0; tile < even_wang_tiles; ++tile) {
        views[tile].push_back({tile, {0, 0}});
        for (std::size_t by = 0; by < even_wang_tiles; ++by)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    if ((x != 0 || y != 0) && may_lie_beside(by, tile, x, y)) views[tile].push_back({by, {x, y}});
    }
    return views;
}

}

const std::vector<TileView>& views_of(std::size_t tile)
{
    static const auto views = all_views();
    return views[tile];
}

PlaceGrid::PlaceGrid(std::size_t places)
{
    while (std::size_t{2} << (2 * bits_) <= places) ++bits_;
    lists_.resize(std::size_t{1} << (2 * bits_));
}

void PlaceGrid::add(const PlanePlace& place)
{
    lists_[static_cast<std::size_t>(index(place[1]) << bits_ | index(place[0]))].push_back(
        static_cast<std::uint32_t>(places_.size()));
    places_.push_back(place);
}

}
