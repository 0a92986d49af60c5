// Pictures of any kind that OpenImageIO reads, as numbers in proportion to light.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// An alpha use says how alpha changes the colours of a picture that is read.
enum class AlphaUse
{
    covers,   ///< colours are multiplied by it, in light: what is transparent is black, and its weight is nothing
    left_out, ///< colours are those beneath it; of floating-point numbers as the file has them
};

/// Pixels row by row from the top, channels side by side. Integer files hold sRGB, which is made linear here, from 0
/// to 1; those of floating-point numbers are taken as they are.
struct LinearPicture
{
    int width = 0;
    int height = 0;
    std::vector<std::string> channels; ///< their names: "R", "G", "B", "A", "Y" or what the file says
    std::optional<std::size_t> alpha;  ///< which of them says how much there is of a pixel
    std::vector<float> values;

    float at(int column, int row, std::size_t channel) const
    {
        return values[(static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(column)) *
                          channels.size() +
                      channel];
    }
};

/// Pictures whose pixels count by their alpha may have at most this number of pixels, so that the sum of their integer
/// weights stays below 2^63.
inline constexpr std::size_t most_pixels = std::size_t{1} << 23;

/// The share of a pixel that is covered, 0 to 1: its alpha, or 1 where the picture has none.
inline float cover_at(const LinearPicture& picture, int column, int row)
{
    return picture.alpha ? picture.at(column, row, *picture.alpha) : 1;
}

/// Reads a picture upright, whichever way it was photographed. Throws InputError, one line with the file's name, for
/// what is no picture, is damaged, has no channels or too many pixels. Every picture that stands for a density, ink, a
/// region, distances or a field is read here, so that transparent pixels mean one thing.
LinearPicture read_linear_picture(const std::filesystem::path& path, AlphaUse use = AlphaUse::covers);

}
