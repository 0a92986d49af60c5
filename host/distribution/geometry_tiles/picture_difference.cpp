#include "host/distribution/geometry_tiles/picture_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace poissonlab {

PictureDifference difference_of(const PngPixels& a, const PngPixels& b)
{
    PictureDifference d;
    d.picture = a;
    double squares = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        const int difference = std::abs(a.values[i] - b.values[i]);
        d.signed_mean += a.values[i] - b.values[i];
        d.mean += difference;
        squares += difference * difference;
        d.picture.values[i] = static_cast<std::uint8_t>(255 - std::min(255, 2 * difference));
    }
    const auto count = static_cast<double>(a.values.size());
    d.mean /= count;
    d.signed_mean /= count;
    d.root_mean_square = std::sqrt(squares / count);
    return d;
}

std::array<double, 2> cover_errors(const PngPixels& field, const PngPixels& whole)
{
    double covered = 0;
    std::array<double, 2> errors{};
    for (std::size_t i = 0; i < whole.values.size(); ++i) {
        const int more = whole.values[i] - field.values[i];
        covered += whole.values[i];
        errors[more > 0 ? 0 : 1] += std::abs(more);
    }
    for (double& error : errors) error = covered > 0 ? error / covered : 0;
    return errors;
}

}
