#include "host/tile_points/monotile_region.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {
namespace {

/// Positions are off by less than 2^-31 edge along each axis, distances thus by less than four times as much.
constexpr double distance_lost = 0x1p-29;

constexpr double points_per_strip = 0x1p20;

/// Origins of windows are multiples of so many steps, so that regions beside each other have the same one nearly
/// always, and not one coordinate differs by rounding.
constexpr double between_origins = 0x1p19;

double sure_distance(const MonotilePointsFile& file) { return pmono_min_distance(&file.set()) - distance_lost; }

}

double edge_for(double min_distance, const MonotilePointsFile& file, const RegionBox& box)
{
    if (sure_distance(file) <= 0)
        throw InputError("the tile set has no proven minimum distance, from which the scale follows");
    return (min_distance + distance_rounding(min_distance, box)) / sure_distance(file);
}

double min_distance_with(double edge, const MonotilePointsFile& file, const RegionBox& box)
{
    const double distance = edge * sure_distance(file);
    return distance - 2 * distance_rounding(distance, box);
}

MonotileRegion::MonotileRegion(const MonotilePointsFile& file, std::shared_ptr<const FixedRegion> region, double edge,
                               const std::array<std::int64_t, 2>& shift)
    : file_(file), region_(std::move(region)), edge_(edge)
{
    const RegionBox& box = region_->box();
    for (std::size_t k = 0; k < 2; ++k) {
        const double first = box.low[k] / edge, last = box.high[k] / edge, step = file_.step()[k];
        const double origin = between_origins * std::round(first / step / between_origins);
        if (!(std::abs(origin) + std::abs(static_cast<double>(shift[k])) <=
              static_cast<double>(farthest_monotile_origin)))
            throw InputError(fmt::format("with edges of {:.4g} units it lies {:.3g} edges from 0: must be at most 2^40",
                                         edge, std::max(std::abs(first), std::abs(last))));
        if (!(last - first <= between_origins))
            throw InputError(fmt::format("takes {:.0f} edges of {:.4g} units along an axis: must be at most {:.0f}",
                                         last - first, edge, between_origins));
        origin_[k] = static_cast<std::int64_t>(origin) + shift[k];
        from_origin_[k] = origin * step;
        // Points on the upper border are inside of regions.
        low_[k] = first - from_origin_[k] - 1;
        high_[k] = last - from_origin_[k] + 1;
    }
    strip_ = std::max(1.0, std::floor(points_per_strip / ((high_[0] - low_[0]) * file_.density())));
    strips_ = static_cast<std::uint32_t>(std::ceil((high_[1] - low_[1]) / strip_));
}

std::vector<pmono_point> MonotileRegion::points(std::uint32_t strip, std::uint32_t seed, double density) const
{
    const double bottom = low_[1] + strip * strip_, top = std::min(high_[1], low_[1] + (strip + 1) * strip_);
    std::vector<pmono_point> found;
    for (pmono_point& point : file_.in_window(seed, origin_, {low_[0], bottom}, {high_[0], top}, density)) {
        const std::array place{edge_ * (from_origin_[0] + point.position[0]),
                               edge_ * (from_origin_[1] + point.position[1])};
        if (!region_->contains_place(place)) continue;
        std::ranges::copy(place, point.position);
        found.push_back(point);
    }
    return found;
}

std::vector<pmono_point> MonotileRegion::all_points(std::uint32_t seed, double density) const
{
    std::vector<pmono_point> all;
    for (std::uint32_t strip = 0; strip < strips_; ++strip) {
        const std::vector<pmono_point> some = points(strip, seed, density);
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}
