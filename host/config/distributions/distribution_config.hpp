// What the tables [[distribution]] of a config ask for, checked.
#pragma once

#include "base/errors/errors.hpp"
#include "host/sampling/parameters.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

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

/// kind = "warp": see host/distribution/warp.hpp.
struct WarpSettings
{
    DensityChoice density;
    bool is_environment = false;
    std::size_t points = 0;
    EvenMethodChoice method;
};

struct DistributionConfig
{
    std::string kind;  ///< one of distribution_kinds()
    std::string label; ///< never empty
    SourceLocation where;
    std::uint64_t seed = 1;
    std::string text;                          ///< the table, in one line: all that decides the result but for `inputs`
    std::vector<std::filesystem::path> inputs; ///< files that decide it as well
    std::variant<WarpSettings> settings;
};

}
