// Values that several kinds of work take: densities, methods of even points, numbers spread over many things.
#pragma once

#include "host/sampling/parameters.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace poissonlab {

/// A density as it was typed: see density_of_text().
struct DensityChoice
{
    std::string text;
    std::string from = "light";
};

/// The method that makes even points: at most one of the two.
struct EvenMethodChoice
{
    std::filesystem::path tiles;          ///< a tile set's file
    std::optional<SamplerChoice> sampler; ///< neither: the default
};

/// A number of each object: the same, even between two, or normal by mean and standard deviation.
struct SpreadChoice
{
    enum class Kind
    {
        constant,
        uniform,
        normal
    } kind = Kind::constant;
    double a = 0;
    double b = 0;
};

}
