// The tables [[distribution]] of a config become these checked settings.
#pragma once

#include "base/errors/errors.hpp"
#include "host/sampling/parameters.hpp"

#include <array>
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

/// kind = "objects": see host/distribution/objects.hpp.
struct ObjectSettings
{
    int dimension = 2;
    std::filesystem::path tiles; ///< empty: corner tiles of 3 colours, 32 points; sphere tiles of 2, 128
    std::string object;          ///< one of object_looks()
    double objects = 36;         ///< in a unit square or cube, on average
    double window = 1;           ///< side of the picture, in units
    std::array<double, 2> origin{};
    std::string view = "plane"; ///< or "sphere", "torus"
    std::uint32_t pixels = 512;
    std::uint32_t samples = 4; ///< of a pixel, along each axis
    std::int32_t period = 0;   ///< tiles after which everything repeats; 0: never
    SpreadChoice size{SpreadChoice::Kind::constant, 1, 0};
    SpreadChoice orientation; ///< radians
    SpreadChoice aspect{SpreadChoice::Kind::constant, 1, 0};
};

/// The self-similar tile that is shown or used: the starts of its coordinates, and the point of rank 0.
struct SelfSimilarChoice
{
    std::uint32_t points = 16;
    std::uint32_t x = 14'217;
    std::uint32_t y = 2'895;
};

/// kind = "self-similar-tile": see host/distribution/self_similar_tile.hpp.
struct SelfSimilarSettings
{
    SelfSimilarChoice tile;
    std::string show;          ///< one of self_similar_shows()
    double least_radius = 0;   ///< of a search
    std::uint32_t repeats = 1; ///< of the function
};

/// kind = "ranks": see subdivided_points().
struct RankSettings
{
    DensityChoice density;
    std::size_t points = 0;
    SelfSimilarChoice tile;
    double zoom = 1; ///< the picture shows the middle, one over this of each side; the density follows
};

struct DistributionConfig
{
    std::string kind;  ///< one of distribution_kinds()
    std::string label; ///< never empty
    SourceLocation where;
    std::uint64_t seed = 1;
    std::string text;                          ///< the table, in one line: all that decides the result but for `inputs`
    std::vector<std::filesystem::path> inputs; ///< files that decide it as well
    std::variant<WarpSettings, ObjectSettings, SelfSimilarSettings, RankSettings> settings;
};

}
