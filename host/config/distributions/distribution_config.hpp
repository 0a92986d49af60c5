// The tables [[distribution]], [[scheme]], [[texture]] and [[packing]] of a config become these checked settings.
#pragma once

#include "base/errors/errors.hpp"
#include "host/config/config_tree.hpp"
#include "host/config/distributions/texture_config.hpp"
#include "host/config/schemes/scheme_settings.hpp"
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

/// From where an environment map is seen: see host/distribution/sky_lights.hpp.
enum class SeenFrom
{
    inside,
    outside
};

/// Their names, in this order.
inline const std::vector<std::string> seen_from_names{"inside", "outside"};

/// kind = "warp": see host/sampling/warp/warp.hpp.
struct WarpSettings
{
    DensityChoice density;
    bool is_environment = false;
    SeenFrom seen_from = SeenFrom::inside;
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
    bool has_timing = false;   ///< look-ups a second are measured
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

/// How marks find their places: warped even points, ranks, or warped points that Gaussian blue noise makes even again.
enum class MarkPlaces
{
    warping,
    ranks, ///< of the tiles, or of the self-similar tile
    gaussian
};

/// Their names, in this order.
inline const std::vector<std::string> mark_places{"warping", "ranks", "gaussian"};

/// kind = "stippling" and "hatching": see host/distribution/stipple.hpp. Either `points` or `mark_width` is
/// 0.
struct StippleSettings
{
    std::string image;        ///< a picture, or a formula of its ink
    std::string from = "ink"; ///< of a picture
    double ink = 1;           ///< the part of it that is printed
    std::size_t points = 0;   ///< marks
    double mark_width = 0;    ///< diameter of dots, or width of strokes, in pixels of the picture
    MarkPlaces by = MarkPlaces::warping;
    std::size_t iterations = 200; ///< of Gaussian blue noise
    double zoom = 1;              ///< the picture shows the middle, one over this of each side
    EvenMethodChoice method;      ///< by ranks: tiles or nothing
    bool has_strokes = false;     ///< instead of dots
    std::optional<double> angle;  ///< of strokes, radians; none: along the picture's lines
    double slenderness = 8;       ///< of strokes: length over width
};

/// kind = "icons": see host/distribution/icons.hpp.
struct IconSettings
{
    std::string field; ///< a picture whose first two channels are the vectors; empty: `u` and `v`
    std::string u;     ///< formulas
    std::string v;
    std::size_t points = 0;
    EvenMethodChoice method;
    bool have_one_length = false; ///< else as long as their vectors
};

/// kind = "instances": see host/distribution/instances/instances.hpp.
struct InstanceSettings
{
    std::string scene = "forest";
    std::filesystem::path tiles;              ///< empty: the default of the scene's dimension
    double density = 0;                       ///< instances in a unit square or cube, on average
    std::array<double, 4> window{0, 0, 1, 1}; ///< x, y, width, height, in units
    std::uint32_t models = 1;
    SpreadChoice scale{SpreadChoice::Kind::constant, 1, 0};
    double tilt = 0;                      ///< the largest one, radians
    std::array<double, 3> ring{};         ///< of a belt: inner and outer radius around 0, and thickness
    std::string terrain;                  ///< a picture or a formula of heights; empty: flat
    std::array<double, 4> terrain_area{}; ///< the rectangle that it covers
    double height = 1;                    ///< units that 1 of the terrain is high
    std::uint32_t pixels = 1024;          ///< of the view from above, along its width
};

/// A table with everything in it, in one line.
std::string text_of(const ConfigTable& table);

struct DistributionConfig
{
    std::string kind;  ///< one of distribution_kinds() or scheme_kinds(), "texture" or "packing"
    std::string label; ///< never empty
    SourceLocation where;
    std::uint64_t seed = 1;
    std::string text;                          ///< the table, in one line: all that decides the result but for `inputs`
    std::vector<std::filesystem::path> inputs; ///< files that decide it as well
    std::variant<WarpSettings, ObjectSettings, SelfSimilarSettings, RankSettings, StippleSettings, IconSettings,
                 InstanceSettings, SchemeSettings, TextureSettings, PackingSettings>
        settings;

    bool is_scheme() const { return std::holds_alternative<SchemeSettings>(settings); }
};

}
