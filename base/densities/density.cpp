#include "base/densities/density.hpp"

#include "base/densities/density_values.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace poissonlab {

Density density_of_values(int width, int height, std::vector<double> values, const std::string& name)
{
    Density density{width, height, {}, clamp_rounding(values, name)};
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!(values[i] >= 0) || std::isinf(values[i]))
            throw InputError(fmt::format("{}: {}: density {}: must be a number that is not negative", name,
                                         pixel_name(width, height, i), values[i]));
        largest = std::max(largest, values[i]);
    }
    if (largest == 0) throw InputError(fmt::format("{}: is 0 everywhere: must be positive somewhere", name));
    density.weights.reserve(values.size());
    for (const double value : values)
        density.weights.push_back(
            static_cast<std::uint64_t>(std::floor(value / largest * static_cast<double>(full_weight))));
    return density;
}

Density density_of_picture(const LinearPicture& picture, std::string_view channel, const std::string& name)
{
    PixelValues values = picture_values(picture, channel, name);
    Density density = density_of_values(values.width, values.height, std::move(values.values), name);
    if (density.note.empty()) density.note = values.note;
    return density;
}

}
