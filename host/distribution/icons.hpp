// Arrows that show a vector field and cannot overlap: each stays in a disk around its point, and no two disks meet.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 7.4, says no more than that icons are best placed
// according to a Poisson disk distribution. Here positions, disks and the ends of strokes are whole numbers, so that
// this can be held against integers: squared distances of points are at least those of two radii.
#pragma once

#include "base/densities/density_values.hpp"
#include "host/distribution/even_points.hpp"
#include "host/settings/distributions/distribution_config.hpp"
#include "results/pictures/mark_picture.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

struct IconSettings
{
    std::filesystem::path field; ///< a picture whose first two channels are the vectors; empty: `u` and `v`
    std::string u;               ///< formulas
    std::string v;
    std::size_t points = 0;
    EvenMethodChoice method;
    bool have_one_length = false; ///< else as long as their vectors
};

/// Vectors of a rectangle's pixels: u to the right, v upwards. Neither finite is a hole.
struct VectorField
{
    PixelValues u;
    PixelValues v;
};

/// The field of settings: the first two channels of a picture, whose transparent pixels are holes, or two formulas over
/// a square. Throws InputError for a picture of one channel beside alpha, and a field without vectors.
VectorField read_field(const IconSettings& settings);

/// The longest side of a field, in units of icons.
inline constexpr std::int64_t icon_units = std::int64_t{1} << 30;

using IconPoint = std::array<std::int64_t, 2>;

struct Icon
{
    IconPoint place{};
    std::array<double, 2> vector{};
    std::vector<std::array<IconPoint, 2>> strokes; ///< ends, from `place`; empty: a dot, as the vector is too short
};

struct Icons
{
    std::int64_t radius = 0; ///< of each icon's disk: half of the least distance, rounded down
    std::int64_t width = 0;  ///< of strokes, which have round ends, and of dots
    std::vector<Icon> icons;
    std::size_t holes = 0; ///< points where the field has no vector
};

/// Icons at even points; the vector is that of the pixel. With `have_one_length` all arrows are as long as their disks,
/// else the longest one is, and others in proportion.
Icons icons_at(const SquarePoints& points, const VectorField& field, bool have_one_length);

/// The square of the least distance of two places, by comparing those that are near each other along x; 0 for fewer
/// than two.
std::uint64_t least_squared_distance(std::vector<IconPoint> places);

/// The picture of icons, in units of the longest side, with room for the disks of those at the frame.
MarkPicture icon_picture(const Icons& icons, const VectorField& field);

/// Lines x, y, u, v under the names of their columns; x and y in units of the longest side.
std::string icons_csv(const Icons& icons);

}
