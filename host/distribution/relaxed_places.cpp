#include "host/distribution/relaxed_places.hpp"

#include "base/errors/errors.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double widest_gaussian = 1; // mean distances, the sampler's default
constexpr std::size_t most_square_pixels = std::size_t{1} << 26;

/// The density with nothing around it: a square from its lower left corner on.
Density squared(const Density& density)
{
    const int side = std::max(density.width, density.height);
    const auto wide = static_cast<std::size_t>(side), columns = static_cast<std::size_t>(density.width);
    if (wide * wide > most_square_pixels)
        throw InputError(fmt::format("Gaussian blue noise: {} x {} pixels are part of a square of {} pixels; must be "
                                     "at most {}",
                                     density.width, density.height, wide * wide, most_square_pixels));
    Density square{side, side, std::vector<std::uint64_t>(wide * wide)};
    for (std::size_t row = 0; row < static_cast<std::size_t>(density.height); ++row)
        std::copy_n(density.weights.begin() + static_cast<std::ptrdiff_t>(row * columns), columns,
                    square.weights.begin() + static_cast<std::ptrdiff_t>(row * wide));
    return square;
}

/// A coordinate in parts of the square as a place inside of the picture.
std::uint64_t place_at(double part, int side, int size)
{
    const double place = std::ldexp(part * side, 32), most = std::ldexp(static_cast<double>(size), 32);
    return std::min(static_cast<std::uint64_t>(place), static_cast<std::uint64_t>(most) - 1);
}

}

PixelPlaces relaxed_places(const Density& density, const PixelPlaces& places, std::size_t iterations,
                           const DistributionPlace& place)
{
    const std::size_t points = places.size() / 2;
    if (points < least_relaxed_places) return places;
    const Density square = squared(density);
    const double step = usual_gaussian_step(widest_gaussian, 2);
    if (place.engine == Engine::opencl)
        check_fits("Gaussian blue noise",
                   GaussianBlueNoise::memory(gaussian_field_shape(square, widest_gaussian, points), points),
                   place.device().info());
    if (place.on_step) place.on_step(fmt::format("Gaussian blue noise: {} points, {} iterations", points, iterations));

    PointSet set{2, {}};
    set.coordinates.reserve(places.size());
    for (const std::uint64_t coordinate : places)
        set.coordinates.push_back(place_coordinate(coordinate, static_cast<std::uint32_t>(square.width)));
    const GaussianRequest request{
        iterations, widest_gaussian, step,
        std::make_shared<const GaussianField>(gaussian_field(square, widest_gaussian, step, points))};
    const PointSet relaxed = place.engine == Engine::reference
                                 ? reference::descend(set, request).points
                                 : GaussianBlueNoise(place.device()).descend(set, request).points;
    PixelPlaces moved;
    moved.reserve(places.size());
    for (std::size_t i = 0; i < relaxed.size(); ++i) {
        moved.push_back(place_at(relaxed[i][0], square.width, density.width));
        moved.push_back(place_at(relaxed[i][1], square.width, density.height));
    }
    return moved;
}

}
