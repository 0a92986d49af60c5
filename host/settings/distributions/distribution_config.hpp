// The settings of the kinds of [[distribution]].
#pragma once

#include "base/regions/region_reading.hpp"
#include "base/regions/space_region.hpp"
#include "base/word_table.hpp"
#include "host/settings/keys/choices.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace poissonlab {

/// From where an environment map is seen: see host/distribution/sky_lights.hpp.
enum class SeenFrom
{
    inside,
    outside
};

inline constexpr WordTable<SeenFrom, 2> seen_from_names{
    {{{SeenFrom::inside, "inside"}, {SeenFrom::outside, "outside"}}}};

/// kind = "warp": see host/sampling/warp/warp.hpp.
struct WarpSettings
{
    DensityChoice density;
    bool is_environment = false;
    SeenFrom seen_from = SeenFrom::inside;
    std::size_t points = 0;
    EvenMethodChoice method;
};

/// kind = "objects": see host/distribution/objects.hpp.
struct ObjectSettings
{
    int dimension = 2;
    std::filesystem::path tiles; ///< empty: corner tiles of 3 colours, 32 points; sphere tiles of 2, 128
    std::string object = "dots"; ///< what they look like
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
    std::string show = "tile";
    double least_radius = 0.64; ///< of a search
    std::uint32_t repeats = 1;  ///< of the function
};

/// kind = "ranks": see subdivided_points().
struct RankSettings
{
    DensityChoice density;
    std::size_t points = 0;
    SelfSimilarChoice tile;
    double zoom = 1; ///< the picture shows the middle, one over this of each side; the density follows
};

/// The ways in which marks find their places: warped even points, ranks, or warped points that Gaussian blue noise
/// makes even again.
enum class MarkPlaces
{
    warping,
    ranks, ///< of the tiles, or of the self-similar tile
    gaussian
};

inline constexpr WordTable<MarkPlaces, 3> mark_places{
    {{{MarkPlaces::warping, "warping"}, {MarkPlaces::ranks, "ranks"}, {MarkPlaces::gaussian, "gaussian"}}}};

/// Ink follows one of these measures of a picture's light.
enum class InkTones
{
    light,    ///< 1 - luminance: as much light is left as the picture has
    lightness ///< 1 - CIE lightness: equal steps to the eye are equal steps of ink, and shadows keep apart
};
inline constexpr WordTable<InkTones, 2> ink_tones{{{{InkTones::light, "light"}, {InkTones::lightness, "lightness"}}}};

/// A dot is drawn in one of these forms.
enum class DotForm
{
    circles,
    strokes, ///< a hundredth of a unit long, which a pen makes a dot of
};
inline constexpr WordTable<DotForm, 2> dot_forms{{{{DotForm::circles, "circles"}, {DotForm::strokes, "strokes"}}}};

/// Marks are drawn in one of these orders.
enum class PenTravel
{
    nearest,
    as_made, ///< as the sampler made them
};
inline constexpr WordTable<PenTravel, 2> pen_travels{
    {{{PenTravel::nearest, "nearest"}, {PenTravel::as_made, "as-made"}}}};

/// A plotter draws on such a sheet of paper: see host/distribution/ink/plot.hpp.
struct PlotSheet
{
    double width = 0; ///< of the picture, in millimetres; 0: a pixel is a unit
    double pen = 0;   ///< in millimetres; 0: the pen is as wide as marks are
    DotForm dots = DotForm::circles;
    PenTravel travel = PenTravel::nearest;
    std::string option = "travel"; ///< one of the keys that were given
};

/// kind = "stippling" and "hatching": see host/distribution/stipple.hpp. Either `points` or `mark_width` is
/// 0.
struct StippleSettings
{
    std::string image;        ///< a picture, or a formula of its ink
    std::string from = "ink"; ///< of a picture
    InkTones tones = InkTones::light;
    double ink = 1;         ///< the part of it that is printed
    std::size_t points = 0; ///< marks
    double mark_width = 0;  ///< diameter of dots, or width of strokes, in pixels of the picture
    MarkPlaces by = MarkPlaces::gaussian;
    std::size_t iterations = 200;  ///< of Gaussian blue noise
    double zoom = 1;               ///< the picture shows the middle, one over this of each side
    EvenMethodChoice method;       ///< by ranks: tiles or nothing
    bool has_strokes = false;      ///< instead of dots
    std::optional<double> angle;   ///< of strokes, radians; none: along the picture's lines
    double slenderness = 8;        ///< of strokes: length over width
    std::optional<PlotSheet> plot; ///< what is made for a plotter, if anything is
};

/// Says how a region's boundary keeps points away.
enum class RegionBoundary
{
    inside, ///< points are inside
    disks,  ///< disks of half the minimum distance around them are
    on      ///< points are inside, and first of all on the boundary
};

inline constexpr WordTable<RegionBoundary, 3> region_boundary_names{
    {{{RegionBoundary::inside, "inside"}, {RegionBoundary::disks, "disks"}, {RegionBoundary::on, "on"}}}};

/// Says which of the distances of two points these keep where distances vary.
enum class KeptDistance
{
    smaller,
    mean ///< of both
};

inline constexpr WordTable<KeptDistance, 2> kept_distances_names{
    {{{KeptDistance::smaller, "smaller"}, {KeptDistance::mean, "mean"}}}};

/// See host/distribution/regions/varied_points.hpp.
struct VariedRequest;

/// A minimum distance that varies over a region: see distance_of_text().
struct VaryingDistance
{
    std::string text; ///< a picture, or a formula in the region's units; empty: the distance does not vary
    std::string from = "light";
    std::array<double, 2> range{}; ///< of a picture: the distances where it is 0 and 1, in the region's units
    KeptDistance between = KeptDistance::smaller;
    std::shared_ptr<const VariedRequest> request{}; ///< what it was read as; empty: it is not read yet
};

/// See host/distribution/regions/region_darts.hpp.
struct RegionLand;

/// See base/regions/fixed_space.hpp.
class FixedSpace;

/// kind = "darts": see host/distribution/regions/region_darts.hpp. Points, a minimum distance, or both.
struct DartSettings
{
    std::string region; ///< a file or a description: see read_region()
    RegionReading reading;
    std::optional<std::size_t> points;
    std::optional<double> min_distance; ///< in the region's units
    VaryingDistance varying;            ///< instead of min_distance
    double relative_radius = 0.7;       ///< of so many points, where there is no minimum distance
    RegionBoundary boundary = RegionBoundary::inside;
    std::string obstacles;                   ///< empty: none; else see read_obstacles()
    std::optional<double> obstacle_distance; ///< of points from them; none: min_distance from points, else 0
    std::shared_ptr<const RegionLand> land;  ///< what both were read as; empty: they are not read yet

    std::shared_ptr<const FixedSpace> space; ///< what a region of space was read as

    bool varies() const { return !varying.text.empty(); }
    bool is_in_space() const { return is_space_region_text(region) || is_mesh_name(region); }
};

/// The ways in which points are made in a region.
enum class RegionMethod
{
    darts,
    relaxation,
    elimination,
    lloyd,
    gaussian,
    bridson
};

inline constexpr WordTable<RegionMethod, 6> region_methods{{{{RegionMethod::darts, "darts"},
                                                             {RegionMethod::relaxation, "relaxation"},
                                                             {RegionMethod::elimination, "elimination"},
                                                             {RegionMethod::lloyd, "lloyd"},
                                                             {RegionMethod::gaussian, "gaussian"},
                                                             {RegionMethod::bridson, "bridson"}}}};

/// kind = "points": see host/distribution/regions/region_points.hpp.
struct RegionPointSettings
{
    RegionMethod method = RegionMethod::darts;
    DartSettings place;                      ///< the region, obstacles, how many points or how far apart
    std::optional<std::uint32_t> attempts;   ///< failures before the radius is reduced, or a point given up
    double factor = 0.99;                    ///< of relaxation, that the radius is multiplied by
    std::uint32_t candidates = 5;            ///< of elimination, for each point
    std::optional<std::uint32_t> iterations; ///< of Lloyd's method and of Gaussian blue noise
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

}
