// Points on the unit sphere by polyominoes over the squares of HEALPix, and other sets to compare them with.
#pragma once

#include "base/densities/density.hpp"
#include "host/distribution/surface_spectra/mesh_set.hpp"
#include "host/settings/distributions/distribution_config.hpp"
#include "tiles/sphere/polyomino_sphere.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

/// The light of an environment map as a density over the sphere. Directions are those of sky_lights.hpp.
class SphereLight
{
public:
    /// Reads a picture or a formula as sky_map() does. Throws InputError.
    SphereLight(const std::string& text, SeenFrom seen_from);

    /// The light at a place over its mean.
    double at(const SpherePlace& place) const;

    /// The largest of these numbers.
    double most() const { return most_; }

    /// The place in a unit square over which this light is even: the part of the light below, and the part of the row
    /// to the left.
    std::array<double, 2> evened(const SpherePlace& place) const;

    /// About pixels below 0; see density_of_values().
    const std::string& note() const { return density_.note; }

private:
    struct PixelPlace
    {
        std::size_t row = 0;           ///< from the bottom
        double column = 0, height = 0; ///< in pixels, and in the row
    };

    PixelPlace pixel_place(const SpherePlace& place) const;
    std::uint64_t weight(std::size_t row, std::size_t column) const
    {
        return density_.weights[row * static_cast<std::size_t>(density_.width) + column];
    }

    SeenFrom seen_from_;
    Density density_;             ///< luminance times solid angle
    std::vector<double> borders_; ///< heights z of the rows' borders, from the bottom
    std::vector<double> below_;   ///< the sum of all rows below a border
    double most_ = 0;
};

/// kind = "sphere".
struct SphereSettings
{
    std::size_t points = 0;
    Polyomino variant = Polyomino::P;
    std::string environment, environment_from = "light"; ///< empty: points are even
    SeenFrom seen_from = SeenFrom::inside;
    std::shared_ptr<const SphereLight> light{}; ///< the environment, where it was read already
};

/// The most values that are looked through for points of an environment.
double sphere_values(const SphereSettings& settings);

/// Sets of more points than these are not measured: all pairs are visited.
inline constexpr std::size_t most_measured_points = 32'768;

std::vector<SpherePlace> random_sphere_points(std::size_t points, std::uint64_t seed);

/// The spherical Fibonacci lattice: heights in equal steps, each turned by the golden section of a turn from the one
/// before (Swinbank and Purser, Fibonacci grids, 2006).
std::vector<SpherePlace> fibonacci_sphere_points(std::size_t points);

/// The counts of points in cells of equal light, in the unit square of `places`: at least ten points are expected in
/// each, and there are at most 16 x 32.
CountsOverParts counts_in_square(const std::vector<std::array<double, 2>>& places);

/// Measures of even points and, beside them, of as many random ones, of as many of the Fibonacci lattice and by dart
/// throwing on a sphere of triangles.
struct SphereSpectra
{
    MeshSpectra of;
    std::vector<double> cap_discrepancies; ///< of the points, the lattice, random points and darts
};

/// `points` are two or more, at most most_measured_points.
SphereSpectra measure_sphere(const std::vector<SpherePlace>& points, std::uint64_t seed,
                             const std::function<void(const std::string& what)>& on_step);

/// Returns kind = "sphere".
Kind sphere_kind();

}
