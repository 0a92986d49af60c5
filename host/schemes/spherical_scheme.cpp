// kind = "spherical": a tiling of the sphere by copies of one tile, whose edges are curves, after Escher's carved
// spheres.
//
// Section 9.3 of Kaplan, Introductory Tiling Theory for Computer Graphics, 2009 (SIGGRAPH 2008 class notes, II); Yen
// and Séquin, Escher sphere construction kit, 2001. See tiles/sphere/spherical_tile.hpp.
#include "host/schemes/spherical_scheme.hpp"

#include "base/text/noun.hpp"
#include "host/schemes/scheme_run.hpp"
#include "host/schemes/sphere_pictures.hpp"
#include "tiles/sphere/spherical_tiling.hpp"
#include "tiles/tilings/tile_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace poissonlab {
namespace {

std::string group_name(const SphericalTileSettings& s)
{
    return s.group.find('n') == std::string::npos ? s.group : fmt::format("{}, n = {}", s.group, s.n);
}

void spherical_keys(Keys& keys, SphericalTileSettings& s)
{
    keys.word("group", s.group, spherical_group_names(), "the symmetries: orders of centres, and * before mirrors");
    keys.integer("n", s.n, 2, 16, "the order that the group's name calls n")
        .only_if(s.group.find('n') != std::string::npos, "group = 22n, *22n or 2*n");
    keys.numbers("corner", s.corner, {{0, 1}}, {"first", "second", "third"},
                 "where the edges to the three centres meet, as weights of these; [0, 0, 1] is the third")
        .only_if(s.group.find('*') == std::string::npos, "a group without mirrors");
    curve_keys(keys, s.curves);
    split_keys(keys, s.split);
    if (keys.is_read()) keys.check([&] { SphericalTile{s}; });
}

std::array<std::uint8_t, 3> bytes_of(const std::string& color)
{
    const auto number = std::stoul(color.substr(1), nullptr, 16);
    return {static_cast<std::uint8_t>(number >> 16), static_cast<std::uint8_t>(number >> 8 & 255),
            static_cast<std::uint8_t>(number & 255)};
}

/// A number for each part of each tile; a part has that of its image in a mirror, with which it is one figure.
std::vector<std::uint32_t> figures_of(const SphericalTile& tile)
{
    const auto parts = static_cast<std::uint32_t>(tile.parts().size());
    std::vector<std::uint32_t> figures(tile.group().size() * parts);
    for (std::uint32_t i = 0; i < figures.size(); ++i) figures[i] = i;
    if (parts == 1) return figures;
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (std::uint32_t i = 0; i < figures.size(); ++i)
            for (std::size_t side = 0; side < tile.sides().size(); ++side) {
                if (!tile.sides()[side].is_mirror || tile.part_of(side) != i % parts) continue;
                const std::uint32_t beyond = tile.group().product(i / parts, tile.sides()[side].neighbour);
                if (std::uint32_t& own = figures[i]; figures[beyond * parts + i % parts] < own) {
                    own = figures[beyond * parts + i % parts];
                    is_changed = true;
                }
            }
    }
    return figures;
}

void add_pictures(const SphericalTile& tile, const std::vector<std::uint32_t>& coloring, DistributionFiles& files,
                  DistributionResult& result)
{
    const SphericalTiling tiling(tile);
    const std::vector<std::uint32_t> figures = figures_of(tile);
    std::vector<std::array<std::uint8_t, 3>> colors{bytes_of("#f6efdc"), bytes_of("#2f4a6d")};
    const std::size_t parts = tile.parts().size();
    if (parts == 1) {
        colors.clear();
        for (const std::uint32_t color : coloring) colors.push_back(bytes_of(tile_color(color)));
    }
    const auto ground = [&](const SpherePlace& place) {
        const SphericalTiling::Found found = tiling.at(direction_of(place));
        return GroundPlace{colors[parts == 1 ? found.element : found.part],
                           figures[found.element * parts + found.part]};
    };
    const auto add = [&](SphereProjection projection, const std::string& name, std::string caption) {
        write_png(files.add(name), sphere_ground(projection, ground, true));
        result.pictures.push_back({name, std::move(caption)});
    };
    add(SphereProjection::globe, "globe.png",
        "Seen from outside: left from the front above, right from the other side below.");
    add(SphereProjection::mollweide, "map.png", "In Mollweide's projection of equal areas.");
    add(SphereProjection::equirectangular, "texture.png",
        "By longitude and latitude: a texture for a sphere in other programs.");
}

}

DistributionResult make_spherical(const SphericalTileSettings& settings, DistributionFiles& files)
{
    const SphericalTile tile(settings);
    const auto [corners, edges, tiles] = tile.counts();
    const std::vector<std::uint32_t> coloring = tile.coloring();
    const bool is_split = settings.split.has_value();
    DistributionResult result;
    result.facts = {fmt::format("{} {}: a group of as many elements", tiles, noun(tiles, "tile")),
                    fmt::format("{} sides of a tile, and each is shared by two", tile.sides().size())};
    if (!is_split) result.facts.emplace_back("a perfect colouring: neighbours differ, and symmetries permute colours");
    const double share = area_of(tile.outline()) * static_cast<double>(tiles) / (4 * std::numbers::pi);
    const auto euler = static_cast<double>(corners + tiles) - static_cast<double>(edges);
    result.numbers = {
        {"tiles", "Tiles", static_cast<double>(tiles), ""},
        {"edges", "Edges", static_cast<double>(edges), ""},
        {"corners", "Corners", static_cast<double>(corners), "with centres of order 2, which two tiles have"},
        {"euler", "Corners less edges plus tiles", euler, "2 for a sphere"},
        {"area_over_sphere", "Area of all tiles over that of the sphere", share, "1: tiles cover the sphere once"},
        {"colors", "Colours", is_split ? 2.0 : *std::ranges::max_element(coloring) + 1.0, ""}};
    if (is_split) {
        const std::size_t alike = tile.alike();
        result.numbers.push_back({"edges_alike", "Sides between equal parts", static_cast<double>(alike),
                                  "of a tile, but for mirrors; 0: a Heaven and Hell pattern"});
        result.numbers.push_back({"light_share", "Share of light parts",
                                  area_of(tile.parts()[0]) / area_of(tile.outline()), "of the sphere"});
    }
    add_pictures(tile, coloring, files, result);
    return result;
}

Kind spherical_kind()
{
    return make_kind<SphericalTileSettings>(
        {"scheme", "spherical", "", "Spherical tiling",
         "Draw a tiling of the sphere by a group, with edges that are curves", false},
        spherical_keys,
        [](const SphericalTileSettings& s) { return fmt::format("Tiling of the sphere by {}", group_name(s)); },
        [](const SphericalTileSettings& s, std::uint64_t, DistributionFiles& files) {
            return make_spherical(s, files);
        });
}

}
