#include "base/images/square_image.hpp"

#include "base/errors/errors.hpp"
#include "base/images/float_image.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {
namespace {

/// Rows from the highest to the lowest y instead of the other way round, or back.
template <class To, class From>
std::vector<To> turned_over(const std::vector<From>& from, int size)
{
    std::vector<To> to(from.size());
    for (std::ptrdiff_t row = 0; row < size; ++row)
        std::transform(from.begin() + row * size, from.begin() + (row + 1) * size, to.begin() + (size - 1 - row) * size,
                       [](From value) { return static_cast<To>(value); });
    return to;
}

}

void write_square_image(const std::filesystem::path& path, const SquareImage& image,
                        const std::map<std::string, std::string>& metadata)
{
    FloatImage file{image.size, image.size, {{"Y", turned_over<float>(image.pixels, image.size)}}, {}};
    for (const auto& [name, value] : metadata) file.texts[metadata_prefix + name] = value;
    write_float_image(path, file);
}

SquareImage read_square_image(const std::filesystem::path& path)
{
    try {
        const FloatImage file = read_float_image(path);
        if (!file.channels.contains("Y")) throw std::runtime_error("there is no float32 channel \"Y\"");
        return {file.width, turned_over<double>(file.channels.at("Y"), file.width)};
    } catch (const std::exception& error) {
        throw InputError(path.string() + ": not a square image: " + error.what());
    }
}

}
