#include "analysis/regions/random_in_region.hpp"

#include "analysis/regions/region_distances.hpp"
#include "base/errors/errors.hpp"
#include "base/random/random_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr std::size_t places_for_mean = 1 << 16;
/// Squares are made for regions of which random positions in cells would find less than this.
constexpr double least_share_of_squares = 1.0 / 64;

constexpr std::uint64_t envelope_seed = 0; ///< one seed for every series, so that envelopes compare

}

RegionDensity::RegionDensity(Density density, const FramedRegion& region)
    : density_(std::move(density)), box_(box_of(region.polygons()))
{
    const RegionPlaces places(region, places_for_mean, 0);
    double sum = 0;
    for (const auto& place : places.places()) sum += static_cast<double>(weight(place));
    mean_ = sum / static_cast<double>(places.places().size());
    if (!(mean_ > 0)) throw InputError("is 0 in all of the region");
}

std::uint64_t RegionDensity::weight(const std::array<double, 2>& place) const
{
    const double x = (place[0] - box_.low[0]) / box_.width(), y = (place[1] - box_.low[1]) / box_.height();
    return density_.at(std::clamp(x, 0.0, 1 - 0x1p-53), std::clamp(y, 0.0, 1 - 0x1p-53));
}

std::vector<double> RegionDensity::intensities(const PointSet& points, const FramedRegion& region,
                                               const std::string& name) const
{
    std::vector<double> intensities;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::array place{points[i][0], points[i][1]};
        const double density = at(place);
        if (!(density > 0))
            throw InputError(fmt::format("{}: point {}, ({}, {}), lies where the density is 0", name, i + 1,
                                         region.own(place)[0], region.own(place)[1]));
        intensities.push_back(density * static_cast<double>(points.size()) / region.area());
    }
    return intensities;
}

RandomInRegion::RandomInRegion(const FramedRegion& region, const RegionDensity* density)
    : region_(region), density_(density)
{
    const FixedRegion& fixed = region.fixed();
    const auto cells = fixed.cells();
    const int bits = fixed.bits();
    squares_.shift = FixedRegion::coordinate_bits - bits;
    // The squares are the cells of the exact region that are not outside altogether.
    for (std::uint32_t cell = 0; cell + 1 < cells.size(); ++cell)
        if (cells[cell] % 2 == 1 || cells[cell + 1] / 2 != cells[cell] / 2)
            squares_.corners.push_back({(cell & ((1u << bits) - 1)) << squares_.shift, cell >> bits << squares_.shift});
    const double squares = static_cast<double>(squares_.corners.size()) * std::pow(4.0, -bits);
    if (region.area() < least_share_of_squares * squares) squares_ = squares_of(fixed, most_region_squares);
}

/// A square, a place in it, and again where that is outside or the density says so.
PointSet RandomInRegion::points(std::size_t count, std::uint32_t realization) const
{
    RandomWords words(stream_key(envelope_seed, Purpose::region_envelope, realization), 0);
    const auto within = [&] { return squares_.shift == 0 ? 0 : words.next() >> (32 - squares_.shift); };
    PointSet points{2, {}};
    while (points.size() < count) {
        const TorusPoint<2>& corner =
            squares_.corners[words.below(static_cast<std::uint32_t>(squares_.corners.size()))];
        TorusPoint<2> position;
        for (std::size_t k = 0; k < 2; ++k) position[k] = corner[k] | within();
        if (!region_.fixed().contains(position)) continue;
        const std::array place{position[0] * 0x1p-31, position[1] * 0x1p-31};
        if (density_) {
            const std::uint64_t level = std::uint64_t{words.next()} << 8;
            if (level >= density_->weight(place)) continue;
        }
        points.coordinates.insert(points.coordinates.end(), place.begin(), place.end());
    }
    return points;
}

}
