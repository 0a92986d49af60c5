#include "tiles/sphere/spherical_tiling.hpp"

#include "base/surfaces/triangle_mesh.hpp"

#include <algorithm>

namespace poissonlab {

SphericalTiling::SphericalTiling(const SphericalTile& tile) : tile_(tile), whole_(tile.outline())
{
    for (const SphericalPolygon& part : tile.parts()) parts_.emplace_back(part);
    for (std::uint32_t i = 0; i < tile.group().size(); ++i) {
        inner_.push_back(moved(tile.group().isometry(i), whole_.inner()));
        around_.push_back(i);
    }
    std::ranges::stable_sort(around_, {}, [&](std::uint32_t i) { return -dot(inner_[i], inner_[0]); });
}

SphericalTiling::Found SphericalTiling::at(const UnitVector& place) const
{
    const SphericalGroup& group = tile_.group();
    std::uint32_t nearest = 0;
    double closest = -2;
    for (std::uint32_t i = 0; i < group.size(); ++i)
        if (const double cosine = dot(inner_[i], place); cosine > closest) {
            closest = cosine;
            nearest = i;
        }
    Found found{nearest, 0};
    UnitVector back = moved(group.isometry(group.inverse(nearest)), place);
    for (const std::uint32_t step : around_) {
        const UnitVector here = moved(group.isometry(group.inverse(step)), back);
        if (!whole_.contains(here)) continue;
        found.element = group.product(nearest, step);
        back = here;
        break;
    }
    if (parts_.size() > 1 && !parts_[0].contains(back)) found.part = 1;
    return found;
}

}
