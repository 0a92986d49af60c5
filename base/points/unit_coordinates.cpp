#include "base/points/unit_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// So many coordinates on the range's end may be there by rounding: few. A grid that has both of its ends has more.
std::uint64_t most_by_rounding(std::uint64_t numbers) { return std::max<std::uint64_t>(3, numbers / 10'000); }

}

CoordinatePlace place_at_byte(std::size_t offset, double value)
{
    return {0, fmt::format("byte {}: {}", offset, value)};
}

bool UnitCoordinates::is_on_border(double value, const CoordinateRange& range, double rounding)
{
    const double reach = rounding * std::max(std::abs(range.low), std::abs(range.high));
    return rounding > 0 && std::isfinite(reach) &&
           ((value < range.low && value >= range.low - reach) || (value >= range.high && value <= range.high + reach));
}

void UnitCoordinates::check_finite() const
{
    if (!std::isfinite(outside_->value)) fail(*outside_, "");
}

void UnitCoordinates::fail(const Found& found, const std::string& more) const
{
    fail_in_point_file(file_, found.place.line, found.place.value,
                       allowed_coordinate(found.value, file_.domain[found.axis]) + more);
}

void UnitCoordinates::check_degrees(const CoordinatePlace& place, double most_longitude,
                                    const std::string& lengths) const
{
    if (!fits_globe(extent_, most_longitude)) return;
    if (file_.domain[0].high != any_coordinates.high)
        fail_in_point_file(file_, place.line, place.value, degrees_words(extent_, file_.options, lengths));
    if (!file_.degrees_sentence.empty()) file_.tell(file_.degrees_sentence);
}

void UnitCoordinates::finish() const
{
    if (outside_)
        fail(*outside_, file_.domain.dimension() > 0 ? "" : fitting_words(extent_, file_.domain[0], file_.options));
    if (rounded_ == 0) return;
    if (rounded_ > most_by_rounding(numbers_))
        fail(*first_rounded_,
             fmt::format("; {} of {} coordinates lie there, more than rounding explains", rounded_, numbers_));
    const CoordinateRange& range = file_.domain[first_rounded_->axis];
    file_.tell(fmt::format("{} of {} coordinates lie on the end of [{}, {}) by rounding: taken as {}, as on the torus",
                           rounded_, numbers_, range.low, range.high, range.low));
}

}
