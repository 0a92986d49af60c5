// The domain of points: which coordinates a file or a user says that there can be.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace poissonlab {

/// The half-open range [low, high) of coordinates along an axis.
struct CoordinateRange
{
    double low = 0;
    double high = 1;
};

/// All numbers, which stay as they are: of points in units of their own.
inline constexpr CoordinateRange any_coordinates{-std::numeric_limits<double>::infinity(),
                                                 std::numeric_limits<double>::infinity()};

/// The range that `LOW:HIGH` says, or `HIGH` for 0:HIGH, such as "512" or "-1:1". Nothing for any other text, and where
/// LOW is not below HIGH.
std::optional<CoordinateRange> parse_range(std::string_view text);

/// A square (cube), with one range for all axes, or a rectangle (box), with one for each.
class PointDomain
{
public:
    PointDomain(CoordinateRange all = {}) : ranges_{all, all, all} {}

    /// Two or three ranges; a third coordinate that there should not be can be any number. It is here for the module of
    /// files of particles, which links nothing of this room.
    explicit PointDomain(std::span<const CoordinateRange> ranges)
        : ranges_{any_coordinates, any_coordinates, any_coordinates}, dimension_(static_cast<int>(ranges.size()))
    {
        std::ranges::copy(ranges, ranges_.begin());
    }

    const CoordinateRange& operator[](std::size_t axis) const { return ranges_[axis]; }

    /// Returns the dimension of the points that the domain is for; 0: any.
    int dimension() const { return dimension_; }

    /// The length along each axis; none of a domain with one range for all axes.
    std::vector<double> sides() const;

    bool is_square() const; ///< or a cube: all sides are the same

private:
    std::array<CoordinateRange, 3> ranges_;
    int dimension_ = 0;
};

/// The domain that a text says: a range for all axes, as for parse_range(), one for each axis with blanks between them
/// ("0:2 0:1", "10 10 30"), or the lower and the upper corner ("0 0 2 1"). Nothing for any other text.
std::optional<PointDomain> parse_domain(std::string_view text);

/// Its form, in the words of messages.
inline constexpr auto domain_form =
    "LOW:HIGH, two numbers, the first smaller; or HIGH; or one of these for each axis, such as \"0:2 0:1\"";

}
