#include "host/distribution/relaxed_places.hpp"

#include "base/errors/errors.hpp"
#include "host/sampling/optimized/gaussian_blue_noise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

namespace poissonlab {
namespace {

constexpr double widest_gaussian = 1; // mean distances, the sampler's default
constexpr std::size_t most_square_pixels = std::size_t{1} << 26;

/// Strips around a picture that is not square show it in a mirror, along its shorter side: points at the border have
/// neighbours beyond it, as points inside have. Without them, points would be pushed onto the border and stay there.
/// They are as wide as the square leaves room for, and no wider than so many mean distances of the points. Images of
/// points are shifted along the border: each point would keep its distance from its own image otherwise, in a row.
class MirrorStrips
{
public:
    MirrorStrips(const Density& density, std::size_t points)
        : axis_(density.width < density.height ? 0 : 1), side_(std::max(density.width, density.height)),
          size_(std::min(density.width, density.height))
    {
        constexpr double widest = 16, shift = 1.5; // mean distances
        const double distance =
            std::sqrt(static_cast<double>(density.width) * density.height / static_cast<double>(points));
        const double most = std::min<double>(size_, std::ceil(widest * distance));
        shift_ = shift * distance / side_;
        const int rest = side_ - size_;
        above_ = std::min(static_cast<int>(most), rest - rest / 2);
        below_ = std::min(static_cast<int>(most), rest / 2);
    }

    /// The density as a square from its lower left corner on, which the torus repeats. Nothing is beyond the strips.
    Density squared(const Density& density) const
    {
        const auto wide = static_cast<std::size_t>(side_);
        if (wide * wide > most_square_pixels)
            throw InputError(fmt::format("Gaussian blue noise: {} x {} pixels are part of a square of {} pixels; must "
                                         "be at most {}",
                                         density.width, density.height, wide * wide, most_square_pixels));
        Density square{side_, side_, std::vector<std::uint64_t>(wide * wide)};
        for (std::size_t row = 0; row < wide; ++row)
            for (std::size_t column = 0; column < wide; ++column) {
                std::array<std::size_t, 2> at{column, row};
                const auto seen = pixel_seen(static_cast<int>(at[axis_]));
                if (!seen) continue;
                at[axis_] = static_cast<std::size_t>(*seen);
                square.weights[row * wide + column] =
                    density.weights[at[1] * static_cast<std::size_t>(density.width) + at[0]];
            }
        return square;
    }

    /// Appends the mirror images of points, whose coordinates are parts of the square. In long pictures a point may
    /// have an image in both strips.
    void append_images(PointSet& set) const
    {
        const std::size_t points = set.size();
        const auto append = [&](std::size_t i, double image) {
            std::array<double, 2> at{set[i][0], set[i][1]};
            at[axis_] = std::min(image / side_, 1 - 0x1p-53);
            at[1 - axis_] += shift_;
            at[1 - axis_] -= std::floor(at[1 - axis_]);
            set.coordinates.insert(set.coordinates.end(), at.begin(), at.end());
        };
        for (std::size_t i = 0; i < points; ++i) {
            const double place = set[i][axis_] * side_;
            if (place > 0 && place < below_) append(i, side_ - place);
            if (place < size_ && place > size_ - above_) append(i, 2.0 * size_ - place);
        }
    }

    /// The first `points` of a set, each of them in the picture. Images that came across the border stand for points
    /// that went the other way, those farthest from the border first, as long as there are some.
    PointSet inside(const PointSet& set, std::size_t points) const
    {
        const auto place = [&](std::size_t i) { return set[i][axis_] * side_; };
        const auto depth = [&](std::size_t i) { return std::min(place(i), size_ - place(i)); };
        std::vector<std::size_t> came;
        for (std::size_t i = points; i < set.size(); ++i)
            if (place(i) < size_) came.push_back(i);
        std::ranges::stable_sort(came, std::greater{}, depth);
        PointSet all{2, {}};
        auto next = came.begin();
        for (std::size_t i = 0; i < points; ++i) {
            const bool has_gone = place(i) >= size_;
            const std::size_t from = has_gone && next != came.end() ? *next++ : i;
            std::array<double, 2> at{set[from][0], set[from][1]};
            if (place(from) >= size_)
                at[axis_] = (place(from) < size_ + above_ ? 2.0 * size_ - place(from) : side_ - place(from)) / side_;
            all.coordinates.insert(all.coordinates.end(), at.begin(), at.end());
        }
        return all;
    }

private:
    /// The pixel that a row (column) of the square shows.
    std::optional<int> pixel_seen(int pixel) const
    {
        if (pixel < size_) return pixel;
        if (pixel < size_ + above_) return 2 * size_ - 1 - pixel;
        if (pixel >= side_ - below_) return side_ - 1 - pixel;
        return std::nullopt;
    }

    std::size_t axis_;
    int side_, size_;           ///< of the square, and of the picture along the axis
    int above_ = 0, below_ = 0; ///< the strips' widths
    double shift_ = 0;          ///< of images along the border, in parts of the square
};

/// A coordinate in parts of the square as a place inside of the picture.
std::uint64_t place_at(double part, int side, int size)
{
    const double place = std::ldexp(part * side, 32), most = std::ldexp(static_cast<double>(size), 32);
    return std::min(static_cast<std::uint64_t>(place), static_cast<std::uint64_t>(most) - 1);
}

}

PixelPlaces relaxed_places(const Density& density, const PixelPlaces& places, std::size_t iterations,
                           const DistributionPlace& place, const std::string& purpose)
{
    const std::size_t points = places.size() / 2;
    if (points < least_relaxed_places) return places;
    const MirrorStrips strips(density, points);
    const Density square = strips.squared(density);
    const double step = usual_gaussian_step(widest_gaussian, 2);
    if (place.on_step)
        place.on_step(fmt::format("{}Gaussian blue noise: {} points, {} iterations", purpose, points, iterations));

    PointSet set{2, {}};
    for (const std::uint64_t coordinate : places)
        set.coordinates.push_back(place_coordinate(coordinate, static_cast<std::uint32_t>(square.width)));
    strips.append_images(set);
    if (place.engine == Engine::opencl)
        check_fits("Gaussian blue noise",
                   GaussianBlueNoise::memory(gaussian_field_shape(square, widest_gaussian, set.size()), set.size()),
                   place.device().info());
    const GaussianRequest request{
        iterations, widest_gaussian, step,
        std::make_shared<const GaussianField>(gaussian_field(square, widest_gaussian, step, set.size()))};
    const PointSet relaxed = place.engine == Engine::reference
                                 ? reference::descend(set, request).points
                                 : GaussianBlueNoise(place.device()).descend(set, request).points;
    PixelPlaces moved;
    moved.reserve(places.size());
    const PointSet inside = strips.inside(relaxed, points);
    for (std::size_t i = 0; i < points; ++i) {
        moved.push_back(place_at(inside[i][0], square.width, density.width));
        moved.push_back(place_at(inside[i][1], square.width, density.height));
    }
    return moved;
}

}
