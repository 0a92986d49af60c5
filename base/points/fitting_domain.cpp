#include "base/points/fitting_domain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace poissonlab {
namespace {

/// The number that is written with so many digits.
double rounded_to(double value, int digits)
{
    return std::strtod(fmt::format("{:.{}g}", value, digits).c_str(), nullptr);
}

bool is_whole(double value) { return value == std::floor(value) && std::abs(value) < 1e9; }

/// The multiple of a power of ten just below `near` that is next to `value`, below it or above.
double multiple_beside(double value, double near, bool is_above)
{
    const double step = std::pow(10.0, std::floor(std::log10(near)));
    const double steps = std::floor(value / step) + (is_above ? 1 : 0);
    const double found = rounded_to(steps * step, 15);
    const bool is_beside = is_above ? found > value : found <= value;
    return is_beside ? found : std::nextafter(value, is_above ? HUGE_VAL : -HUGE_VAL);
}

/// The roundest number above `value` that is near, or a power of two. Whole numbers are counted from 0: 9 is the last
/// of 10.
double round_number_above(double value, double near, double far)
{
    if (is_whole(value) && far >= 1) return value + 1;
    if (value < 0 && -value <= near) return 0;
    for (int digits = 1; value > 0 && digits < 4; ++digits) {
        const double unit = std::pow(10.0, std::floor(std::log10(value)) + 1 - digits);
        const double power = std::exp2(std::floor(std::log2(value)) + 1);
        const double next = std::min(power, rounded_to((std::floor(value / unit) + 1) * unit, digits));
        if (next > value && next - value <= near) return next;
    }
    return multiple_beside(value, near, true);
}

/// The roundest number at `value` or below it that is near; `high` is the range's end.
double round_number_below(double value, double high, double near, double far)
{
    if (value >= 0 && value <= far) return 0;
    if (high > 0 && -high <= value && value + high <= 2 * near) return -high;
    return is_whole(value) ? value : multiple_beside(value, near, false);
}

double length_of(const CoordinateRange& range) { return range.high - range.low; }

constexpr CoordinateRange all_longitudes{-180, 180}, all_latitudes{-90, 90};

CoordinateRange within(const CoordinateRange& range, const CoordinateRange& all)
{
    return {std::max(range.low, all.low), std::min(range.high, all.high)};
}

/// Degrees of the sphere that the corners of a rectangle may be from its middle: Lambert's azimuthal equal-area plane
/// stretches lengths there by 1 / cos(45 / 2 degrees), 8 %. Regions may be stretched by 10 %, around a middle that is
/// that of the plane and not that of the degrees.
constexpr double farthest_corner = 45;

bool fits_plane(const CoordinateRange& longitudes, const CoordinateRange& latitudes)
{
    constexpr double degree = std::numbers::pi / 180;
    const double half = length_of(longitudes) / 2 * degree;
    const double middle = (latitudes.low + latitudes.high) / 2 * degree;
    return half <= std::numbers::pi / 2 &&
           std::ranges::all_of(std::array{latitudes.low, latitudes.high}, [&](double y) {
               const double cosine =
                   std::sin(middle) * std::sin(y * degree) + std::cos(middle) * std::cos(y * degree) * std::cos(half);
               return cosine >= std::cos(farthest_corner * degree);
           });
}

/// The rectangle of longitudes and latitudes as the option of a region; empty if it is too large for a plane.
std::string rectangle_of_globe(const Extent& extent, const PointOptions& options)
{
    CoordinateRange x = fitting_range(extent.longitudes(), extent.points(), 2);
    if (extent.longitudes().high < all_longitudes.high) x = within(x, all_longitudes);
    const CoordinateRange y = within(fitting_range(extent.along(1), extent.points(), 2), all_latitudes);
    if (!fits_plane(x, y)) return {};
    return fmt::format(fmt::runtime(options.region), x.low, y.low, x.high, y.high);
}

/// Returns true for places on the globe that are ten times as far from 0 as from each other.
bool are_small_and_far(const Extent& extent)
{
    constexpr double far_away = 10;
    double nearest = 0, longest = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const CoordinateRange& range = extent.along(axis);
        nearest = std::max({nearest, range.low, -range.high});
        longest = std::max(longest, length_of(range));
    }
    return fits_globe(extent) && longest > 0 && nearest > far_away * longest;
}

std::string fitting_rectangle(const Extent& extent, const PointOptions& options)
{
    const std::size_t axes = extent.dimension();
    const auto along = [&](std::size_t axis) { return fitting_range(extent.along(axis), extent.points(), axes); };
    const CoordinateRange x = along(0), y = along(1), z = axes == 3 ? along(2) : CoordinateRange{};
    const std::string_view one_range = "--domain {}:{}"; // other interfaces have other words for boxes
    if (axes == 3)
        return fmt::format("{}\"{}:{} {}:{} {}:{}\" (a periodic box)", options.domain == one_range ? "--domain " : "",
                           x.low, x.high, y.low, y.high, z.low, z.high);
    const std::string region = fmt::format(fmt::runtime(options.region), x.low, y.low, x.high, y.high);
    if (options.domain != one_range || are_small_and_far(extent)) return region;
    return fmt::format("--domain \"{}:{} {}:{}\" (a periodic box) or {}", x.low, x.high, y.low, y.high, region);
}

}

bool fits_globe(const Extent& extent, double most)
{
    const CoordinateRange &x = extent.along(0), &y = extent.along(1);
    return extent.dimension() >= 2 && x.low >= all_longitudes.low && x.high <= most && length_of(x) <= 360 &&
           y.low >= all_latitudes.low && y.high <= all_latitudes.high;
}

std::string degrees_words(const Extent& extent, const PointOptions& options, const std::string& lengths)
{
    std::string words = "are longitude and latitude in degrees, which are not lengths: ";
    if (*options.region != '\0' && extent.dimension() == 2) {
        const std::string rectangle = rectangle_of_globe(extent, options);
        words += "a region of the globe maps them to metres, ";
        words += rectangle.empty() ? "but a rectangle around all of them is too large for a plane; "
                                   : fmt::format("such as {} with {}, or a file of GeoJSON; ", rectangle, options.crs);
    }
    return words + lengths;
}

CoordinateRange Extent::longitudes() const
{
    const auto& [east, west] = halves_;
    const CoordinateRange straight{std::min(east.low, west.low), std::max(east.high, west.high)};
    const CoordinateRange across{east.low, west.high + 360};
    const bool has_both = east.low <= east.high && west.low <= west.high;
    return has_both && length_of(across) < length_of(straight) ? across : straight;
}

std::size_t Extent::dimension() const
{
    return static_cast<std::size_t>(
        std::ranges::count_if(axes_, [](const CoordinateRange& axis) { return axis.low <= axis.high; }));
}

CoordinateRange Extent::of_all() const
{
    CoordinateRange all = nothing;
    for (const CoordinateRange& axis : axes_) {
        all.low = std::min(all.low, axis.low);
        all.high = std::max(all.high, axis.high);
    }
    return all;
}

CoordinateRange fitting_range(const CoordinateRange& numbers, std::uint64_t points, std::size_t dimension)
{
    const double length = length_of(numbers), count = static_cast<double>(points);
    if (!(length > 0)) return {numbers.low, numbers.low + 1};
    const double near = length * std::max(0.002, std::min(0.1, 4 / count));
    const double far = length * std::min(0.5, 2 * std::pow(count, -1 / static_cast<double>(dimension)));
    const double high = round_number_above(numbers.high, near, far);
    return {round_number_below(numbers.low, high, near, far), high};
}

std::string fitting_words(const Extent& extent, const CoordinateRange& range, const PointOptions& options)
{
    const CoordinateRange all = extent.of_all();
    const std::size_t dimension = extent.dimension();
    if (*options.domain == '\0' || !std::isfinite(length_of(all)) || (all.low >= range.low && all.high <= range.high))
        return {};
    const auto fitting = [&](const CoordinateRange& numbers) {
        return fitting_range(numbers, extent.points(), dimension);
    };
    const CoordinateRange cube = fitting(all);
    double least = length_of(cube);
    for (std::size_t axis = 0; axis < dimension; ++axis) least = std::min(least, length_of(extent.along(axis)));
    const bool is_rectangle = dimension >= 2 && *options.region != '\0' && least < 0.9 * length_of(cube);
    std::string would_fit;
    if (!is_rectangle || least > 0.5 * length_of(cube))
        would_fit = fmt::format(fmt::runtime(options.domain), cube.low, cube.high);
    if (is_rectangle) would_fit += (would_fit.empty() ? "" : " or ") + fitting_rectangle(extent, options);
    const bool are_degrees = dimension == 2 && *options.crs != '\0' && are_small_and_far(extent);
    return fmt::format("; the numbers go from {:.6g} to {:.6g}: {} would fit{}", all.low, all.high, would_fit,
                       are_degrees ? fmt::format("; if they are longitude and latitude, {} with {}",
                                                 rectangle_of_globe(extent, options), options.crs)
                                   : "");
}

}
