// The coordinates of a file mapped to [0, 1) while they are read. Where some lie outside of the file's range, the whole
// file is read first: the message has the first of them, and the domain in which all would be.
#pragma once

#include "base/points/fitting_domain.hpp"
#include "base/points/point_file_formats.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace poissonlab {

/// The place of a number in a file: its line, or 0, and the words for it.
struct CoordinatePlace
{
    int line = 0;
    std::string value;
};

/// The place of a number in a binary file.
CoordinatePlace place_at_byte(std::size_t offset, double value);

/// Half the relative distance between neighbours of binary numbers.
inline constexpr double half_ulp_of_float = 0x1p-24, half_ulp_of_double = 0x1p-53;

class UnitCoordinates
{
public:
    explicit UnitCoordinates(const PointFileContent& file) : file_(file) {}

    /// The coordinate in [0, 1). Numbers were rounded by so much, relative to them, before they were stored: one that
    /// rounding has moved to the range's end is its begin. `place` makes the number's CoordinatePlace. Throws
    /// InputError for what is no number.
    template <class Place>
    double operator()(double value, std::size_t axis, double rounding, const Place& place)
    {
        ++numbers_;
        extent_.add(axis, value);
        const CoordinateRange& range = file_.domain[axis];
        if (is_coordinate(value, range)) return to_unit(value, range);
        return of_outside(value, axis, rounding, place);
    }

    /// Is one outside? Then nothing that is read is needed any more.
    bool are_refused() const { return outside_.has_value(); }

    /// Throws InputError where numbers lie outside of the range, or more of them on its end than rounding explains.
    /// Else tells of those that were rounded.
    void finish() const;

    /// Throws InputError where the numbers, which the file calls longitude and latitude at `place`, fit the globe and
    /// would be measured as lengths; tells of it where their region takes them for lengths. Numbers that keep their
    /// units may be mapped to a plane later. See fits_globe() and degrees_words().
    void check_degrees(const CoordinatePlace& place, double most_longitude, const std::string& lengths) const;

private:
    struct Found
    {
        CoordinatePlace place;
        double value;
        std::size_t axis;
    };

    template <class Place>
    double of_outside(double value, std::size_t axis, double rounding, const Place& place)
    {
        const bool is_rounded = is_on_border(value, file_.domain[axis], rounding);
        auto& first = is_rounded ? first_rounded_ : outside_;
        rounded_ += is_rounded;
        if (!first) first = Found{place(), value, axis};
        if (!is_rounded) check_finite();
        return 0;
    }

    static bool is_on_border(double value, const CoordinateRange& range, double rounding);
    void check_finite() const;
    [[noreturn]] void fail(const Found& found, const std::string& more) const;

    const PointFileContent& file_;
    Extent extent_;
    std::optional<Found> outside_, first_rounded_;
    std::uint64_t numbers_ = 0, rounded_ = 0;
};

}
