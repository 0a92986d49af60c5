// The domain that would fit the numbers of a file, for messages about numbers that lie outside of theirs.
#pragma once

#include "base/points/point_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

namespace poissonlab {

/// The least and the largest number along each axis.
class Extent
{
public:
    void add(std::size_t axis, double value)
    {
        axes_[axis].low = std::min(axes_[axis].low, value);
        axes_[axis].high = std::max(axes_[axis].high, value);
        if (axis > 0) return;
        ++points_;
        const double longitude = value >= 180 ? value - 360 : value;
        CoordinateRange& half = halves_[longitude < 0 ? 1 : 0];
        half.low = std::min(half.low, longitude);
        half.high = std::max(half.high, longitude);
    }

    std::size_t dimension() const;
    std::uint64_t points() const { return points_; }
    const CoordinateRange& along(std::size_t axis) const { return axes_[axis]; }

    /// Returns the range of the first axis as longitudes, the shorter way around the globe: from -180 to 180, or,
    /// across the antimeridian, on beyond 180.
    CoordinateRange longitudes() const;

    /// The range of the numbers along all axes together.
    CoordinateRange of_all() const;

private:
    static constexpr CoordinateRange nothing{std::numeric_limits<double>::infinity(),
                                             -std::numeric_limits<double>::infinity()};
    std::array<CoordinateRange, 3> axes_{nothing, nothing, nothing};
    std::array<CoordinateRange, 2> halves_{nothing, nothing}; ///< of longitudes: the eastern and the western one
    std::uint64_t points_ = 0;
};

/// A range of round numbers that holds these, for so many points in so many dimensions: wider by about the distance of
/// neighbours at most, since a set says no more of the torus that it is from.
CoordinateRange fitting_range(const CoordinateRange& numbers, std::uint64_t points, std::size_t dimension);

/// Returns the end of a message about numbers that are not all in `range`: where they lie, and the option that fits.
/// It is empty if all are in the range or if there is no option. It also says how to read longitude and latitude, if
/// the numbers are close together, far from 0 and fit the globe.
std::string fitting_words(const Extent& extent, const CoordinateRange& range, const PointOptions& options);

/// Could the numbers be latitudes, and longitudes up to `most`? Some files have these from 0 to 360.
bool fits_globe(const Extent& extent, double most = 180);

/// Returns the end of a message that refuses longitude and latitude: the reason, and the options that map degrees to
/// lengths. `lengths` says how a file marks lengths. The message suggests only rectangles that a region of the globe
/// can be.
std::string degrees_words(const Extent& extent, const PointOptions& options, const std::string& lengths);

}
