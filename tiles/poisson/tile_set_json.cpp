#include "tiles/poisson/tile_set_json.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

using Json = nlohmann::json; // its search for a key is not linear, as that of the ordered kind is
using OrderedJson = nlohmann::ordered_json;

constexpr auto format_name = "poissonlab tile set";
/// The first one knows neither borders nor joint iterations, the second no moments; the last one is for classes.
constexpr int plain_version = 3, json_version = 4;

constexpr std::array known_keys{"format",
                                "version",
                                "kind",
                                "dimension",
                                "colors",
                                "tiles",
                                "points_per_tile",
                                "relative_radius",
                                "filling",
                                "attempts",
                                "factor",
                                "lloyd_iterations",
                                "repulsion",
                                "border",
                                "joint_iterations",
                                "null_peaks",
                                "equal_moments",
                                "ranked",
                                "seed",
                                "min_distance",
                                "guaranteed_relative_radius",
                                "chain_lengths",
                                "class_points",
                                "class_distances",
                                "class_squared_distances",
                                "tile_ranks",
                                "tile_points"};

OrderedJson parameters_to_json(const PoissonTileSet& set)
{
    const PoissonTileParameters& p = set.parameters;
    OrderedJson json{{"format", format_name},
                     {"version", p.classes.is_empty() ? plain_version : json_version},
                     {"kind", kind_name(p)},
                     {"dimension", p.dimension},
                     {"colors", p.colors},
                     {"tiles", p.tiles},
                     {"points_per_tile", p.points_per_tile},
                     {"relative_radius", p.relative_radius},
                     {"filling", tile_fillings[p.filling]},
                     {"attempts", p.attempts},
                     {"factor", p.factor},
                     {"lloyd_iterations", p.lloyd_iterations},
                     {"repulsion", p.repulsion},
                     {"border", tile_borders[p.border]},
                     {"joint_iterations", p.joint_iterations},
                     {"null_peaks", p.null_peaks},
                     {"equal_moments", p.equal_moments},
                     {"ranked", p.ranked},
                     {"seed", p.seed},
                     {"min_distance", std::sqrt(static_cast<double>(set.squared_min_distance)) / tile_units},
                     {"guaranteed_relative_radius", relative_radius_of(set.squared_min_distance, p)},
                     {"chain_lengths", set.chain_lengths}};
    if (p.classes.is_empty()) return json;
    json["class_points"] = p.classes.points;
    for (std::size_t j = 0; j < p.classes.count(); ++j)
        for (std::size_t i = 0; i <= j; ++i) json["class_distances"].push_back(p.classes.distances.at(i, j));
    json["class_squared_distances"] = set.class_squared_distances;
    return json;
}

const Json& value_of(const Json& json, const char* key)
{
    const auto found = json.find(key);
    if (found == json.end()) throw InputError(fmt::format("{}: is missing", key));
    return *found;
}

/// Throws InputError with the value as it is written, shortened, and with the allowed ones.
[[noreturn]] void refuse(const std::string& what, const Json& value, const std::string& allowed)
{
    const std::string text =
        value.is_structured() ? value.type_name() : value.dump(-1, ' ', false, Json::error_handler_t::replace);
    throw InputError(fmt::format("{} = {}: must be {}", what, shortened(text), allowed));
}

/// An integer that the type can hold. Floating-point numbers are none, even 3.0.
template <class Integer>
Integer integer(const Json& json, const std::string& what)
{
    constexpr auto largest = std::numeric_limits<Integer>::max();
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > static_cast<std::uint64_t>(largest))
        refuse(what, json, fmt::format("an integer from 0 to {}", largest));
    return json.get<Integer>();
}

template <class Integer>
Integer integer_at(const Json& json, const char* key)
{
    return integer<Integer>(value_of(json, key), key);
}

double number_at(const Json& json, const char* key)
{
    const Json& value = value_of(json, key);
    if (!value.is_number()) refuse(key, value, "a number");
    return value.get<double>();
}

bool bool_at(const Json& json, const char* key)
{
    const Json& value = value_of(json, key);
    if (!value.is_boolean()) refuse(key, value, "true or false");
    return value.get<bool>();
}

/// The value that a word names.
template <typename Enum, std::size_t N>
Enum word_at(const Json& json, const char* key, const WordTable<Enum, N>& words)
{
    const Json& value = value_of(json, key);
    const auto found = value.is_string() ? words.find(value.get<std::string>()) : std::nullopt;
    if (!found) refuse(key, value, fmt::format("one of {}", fmt::join(words.all(), ", ")));
    return *found;
}

PoissonTileParameters parameters_from_json(const Json& json)
{
    PoissonTileParameters p;
    const PoissonTileFamily family = word_at(json, "kind", poisson_tile_families);
    p.kind = family.kind;
    p.dimension = integer_at<int>(json, "dimension");
    if (p.dimension != family.dimension) refuse("dimension", json["dimension"], fmt::format("{}", family.dimension));
    p.colors = integer_at<std::uint32_t>(json, "colors");
    p.tiles = integer_at<std::uint32_t>(json, "tiles");
    p.points_per_tile = integer_at<std::uint32_t>(json, "points_per_tile");
    p.relative_radius = number_at(json, "relative_radius");
    p.filling = word_at(json, "filling", tile_fillings);
    p.attempts = integer_at<std::uint32_t>(json, "attempts");
    p.factor = number_at(json, "factor");
    p.lloyd_iterations = integer_at<std::uint32_t>(json, "lloyd_iterations");
    p.repulsion = bool_at(json, "repulsion");
    if (integer_at<int>(json, "version") > 1) {
        p.border = word_at(json, "border", tile_borders);
        p.joint_iterations = integer_at<std::uint32_t>(json, "joint_iterations");
        p.null_peaks = bool_at(json, "null_peaks");
        p.ranked = bool_at(json, "ranked");
    }
    if (integer_at<int>(json, "version") > 2) p.equal_moments = integer_at<std::uint32_t>(json, "equal_moments");
    p.seed = integer_at<std::uint64_t>(json, "seed");
    return p;
}

/// The square of a distance in tiles, in whole units. Roots of integers come back as these; others are
/// rounded down, as what is guaranteed must be.
std::uint64_t squared_distance_at(const Json& json, const char* key)
{
    const double distance = number_at(json, key);
    if (!(distance >= 0 && distance <= 2)) refuse(key, json[key], "a number from 0 to 2, in tiles");
    constexpr double rounding = 1e-3; // of the root and its square, some 1e-5
    return static_cast<std::uint64_t>(distance * tile_units * (distance * tile_units) + rounding);
}

const Json& list_of(const Json& json, std::size_t size, const std::string& what)
{
    if (!json.is_array() || json.size() != size) throw InputError(fmt::format("{}: must be a list of {}", what, size));
    return json;
}

std::vector<std::uint16_t> points_from_json(const Json& json, const PoissonTileParameters& p)
{
    std::vector<std::uint16_t> points;
    const auto dimension = static_cast<std::size_t>(p.dimension);
    list_of(json, p.tiles, "tile_points");
    for (std::size_t tile = 0; tile < p.tiles; ++tile) {
        const std::string what = fmt::format("tile_points[{}]", tile);
        for (const Json& point : list_of(json[tile], p.points_per_tile, what)) {
            for (const Json& x : list_of(point, dimension, what + ": a point"))
                points.push_back(integer<std::uint16_t>(x, what));
        }
    }
    return points;
}

std::vector<std::uint16_t> ranks_from_json(const Json& json, const PoissonTileParameters& p)
{
    std::vector<std::uint16_t> ranks;
    list_of(json, p.tiles, "tile_ranks");
    for (std::size_t tile = 0; tile < p.tiles; ++tile) {
        const std::string what = fmt::format("tile_ranks[{}]", tile);
        for (const Json& rank : list_of(json[tile], p.points_per_tile, what))
            ranks.push_back(integer<std::uint16_t>(rank, what));
    }
    return ranks;
}

/// The classes of a set of a version that has them.
void classes_from_json(const Json& json, PoissonTileSet& set)
{
    TileClasses& classes = set.parameters.classes;
    const Json& points = value_of(json, "class_points");
    if (!points.is_array() || points.empty() || points.size() > most_classes)
        throw InputError(fmt::format("class_points: must be a list of 1 to {}", most_classes));
    for (const Json& count : points) classes.points.push_back(integer<std::uint32_t>(count, "class_points"));
    const std::size_t pairs = class_pair_count(classes.count());
    const Json& distances = list_of(value_of(json, "class_distances"), pairs, "class_distances");
    classes.distances = ClassDistances(classes.count());
    for (std::size_t j = 0; j < classes.count(); ++j)
        for (std::size_t i = 0; i <= j; ++i) {
            const Json& distance = distances[class_pair(i, j)];
            if (!distance.is_number()) refuse("class_distances", distance, "numbers");
            classes.distances.set(i, j, distance.get<double>());
        }
    for (const Json& squared : list_of(value_of(json, "class_squared_distances"), pairs, "class_squared_distances"))
        set.class_squared_distances.push_back(integer<std::uint64_t>(squared, "class_squared_distances"));
}

Json parsed(std::string_view text)
{
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw InputError(fmt::format("is no JSON: wrong at byte {}", error.byte));
    } catch (const Json::out_of_range&) {
        throw InputError("is no JSON: it has a number that is too large");
    }
}

}

std::string tile_set_to_json(const PoissonTileSet& set)
{
    std::string text = parameters_to_json(set).dump(2);
    text.resize(text.size() - 2); // the line feed and brace at the end
    text += ",\n  \"tile_points\": [";
    const auto dimension = static_cast<std::size_t>(set.parameters.dimension);
    const std::uint32_t n = set.parameters.points_per_tile;
    for (std::uint32_t tile = 0; tile < set.parameters.tiles; ++tile) {
        text += tile == 0 ? "\n    [" : ",\n    [";
        const std::span<const std::uint16_t> points = set.tile(tile);
        for (std::size_t i = 0; i < points.size(); i += dimension)
            fmt::format_to(std::back_inserter(text), "{}[{}]", i == 0 ? "" : ", ",
                           fmt::join(points.subspan(i, dimension), ", "));
        text += "]";
    }
    text += "\n  ],\n  \"tile_ranks\": [";
    for (std::size_t first = 0; first < set.ranks.size(); first += n)
        fmt::format_to(std::back_inserter(text), "{}\n    [{}]", first == 0 ? "" : ",",
                       fmt::join(std::span(set.ranks).subspan(first, n), ", "));
    return text + (set.ranks.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

PoissonTileSet tile_set_from_json(std::string_view text)
{
    const Json json = parsed(text);
    if (!json.is_object() || value_of(json, "format") != format_name)
        throw InputError(fmt::format("format: must be \"{}\"", format_name));
    if (const int version = integer_at<int>(json, "version"); version < 1 || version > json_version)
        refuse("version", json["version"], fmt::format("1 to {}", json_version));
    for (const auto& [key, value] : json.items()) {
        if (std::ranges::find(known_keys, key) == known_keys.end())
            throw InputError(
                fmt::format("{}: unknown key; known keys: {}", shortened(key), fmt::join(known_keys, ", ")));
    }
    PoissonTileSet set;
    set.parameters = parameters_from_json(json);
    if (integer_at<int>(json, "version") == json_version)
        classes_from_json(json, set);
    else if (json.contains("class_points"))
        throw InputError(fmt::format("class_points: is for version {}", json_version));
    check(set.parameters);
    set.squared_min_distance = squared_distance_at(json, "min_distance");
    const double radius = number_at(json, "guaranteed_relative_radius");
    if (!(std::abs(radius - relative_radius_of(set.squared_min_distance, set.parameters)) < 1e-6))
        refuse("guaranteed_relative_radius", json["guaranteed_relative_radius"], "that of min_distance");
    set.points = points_from_json(value_of(json, "tile_points"), set.parameters);
    if (set.parameters.border == TileBorder::chain) {
        const std::size_t chains = std::size_t{2} * set.parameters.colors * set.parameters.colors;
        for (const Json& length : list_of(value_of(json, "chain_lengths"), chains, "chain_lengths"))
            set.chain_lengths.push_back(integer<std::uint16_t>(length, "chain_lengths"));
    }
    if (set.parameters.ranked) set.ranks = ranks_from_json(value_of(json, "tile_ranks"), set.parameters);
    check_ranks(set);
    return set;
}

}
