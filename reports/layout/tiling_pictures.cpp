#include "reports/layout/tiling_pictures.hpp"

#include "base/errors/errors.hpp"
#include "base/images/grey_image.hpp"
#include "base/images/square_image.hpp"
#include "reports/drawings/construction_image.hpp"
#include "reports/drawings/cube_tile_image.hpp"
#include "reports/drawings/drawing.hpp"
#include "reports/drawings/tile_image.hpp"
#include "results/pictures/stored_tiles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr double tiling_pixels_a_unit = 2;

/// Stored layers begin at the bottom, stored rows in the north.
CubeGrid cube_grid(const TilingResult& tiling, const std::vector<TileIndex>& tiles)
{
    if (!tiling.set.empty()) {
        const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(tiles.size()))));
        std::vector<TileIndex> cubes = tiles;
        return {tiling.colors, {side, (tiles.size() + side - 1) / side, 1}, cubes, true, tiling.kind};
    }
    CubeGrid grid{tiling.colors, tiling.size, {}, false, tiling.kind};
    const auto [width, height, depth] = tiling.size;
    for (std::size_t z = 0; z < depth; ++z)
        for (std::size_t y = 0; y < height; ++y)
            for (std::size_t x = 0; x < width; ++x)
                grid.cubes.push_back(tiles[(z * height + height - 1 - y) * width + x]);
    return grid;
}

TileGrid square_grid(const TilingResult& tiling, const std::vector<TileIndex>& tiles)
{
    const WangColors colors = tiling.all_colors();
    if (tiling.set.empty()) return {tiling.kind, colors, tiling.size[0], tiles, false};
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(tiles.size()))));
    return {tiling.kind, colors, columns, tiles, true};
}

Drawing drawing_of(const TilingResult& tiling, const std::vector<TileIndex>& tiles)
{
    const bool regions = tiling.regions > 0;
    if (axes_of(tiling.kind) == 3) {
        const CubeGrid grid = cube_grid(tiling, tiles);
        return regions ? draw_cube_regions(grid, tiling.regions) : draw_cubes(grid);
    }
    const TileGrid grid = square_grid(tiling, tiles);
    return regions ? draw_tile_regions(grid, tiling.regions) : draw_tiles(grid);
}

void draw_autocorrelation(const ReportTiling& tiling, const ColorStatistics& colors)
{
    const auto file = tiling.run->folder / colors.autocorrelation_file;
    const SquareImage z = read_square_image(file);
    if (z.size != 2 * colors.autocorrelation.lags + 1)
        throw InputError(fmt::format("{}: must be an image of {} x {}, as results.json says", file.string(),
                                     2 * colors.autocorrelation.lags + 1, 2 * colors.autocorrelation.lags + 1));
    GreyImage image(z.size, z.size, 0);
    for (int row = 0; row < z.size; ++row)
        for (int column = 0; column < z.size; ++column) {
            const double share = std::clamp(0.5 + z.at(column, row) / (2 * shown_z), 0.0, 1.0);
            image.at(column, z.size - 1 - row) = static_cast<std::uint8_t>(std::lround(255 * share));
        }
    write_png(tiling.pictures / autocorrelation_picture(colors), image);
}

}

void draw_tiling_pictures(const ReportTiling& tiling, PictureStore& store)
{
    const Drawing drawing = drawing_of(*tiling.stored, read_tiles(tiling.run->folder, *tiling.stored));
    write_drawing(tiling.pictures / "tiles", drawing, tiling_pixels_a_unit * drawing.width, store);
    if (!tiling.stored->statistics) return;
    for (const ColorStatistics& colors : tiling.stored->statistics->colors) draw_autocorrelation(tiling, colors);
}

namespace {

constexpr double pixels_a_unit = 2;

}

bool is_set(const ReportConstruction& construction) { return construction.stored->kind == "set"; }

bool has_steps(const ReportConstruction& construction)
{
    const Scene& scene = construction.scene;
    const bool is_list = scene.panels.front().caption.empty();
    return scene.dimension == 2 && scene.panels.size() > 1 && !is_list;
}

std::filesystem::path steps_page_of(const ReportConstruction& construction)
{
    return construction.pictures / "steps.html";
}

Scene pictured_scene(const ReportConstruction& construction)
{
    constexpr std::size_t few_panels = 6;
    const std::vector<ScenePanel>& all = construction.scene.panels;
    if (!is_set(construction) || all.size() <= few_panels) return construction.scene;
    Scene scene = construction.scene;
    scene.panels.clear();
    for (std::size_t i = 0; i < few_panels; ++i) scene.panels.push_back(all[i * (all.size() - 1) / (few_panels - 1)]);
    return scene;
}

void draw_construction_picture(const ReportConstruction& construction, PictureStore& store)
{
    const Drawing drawing = draw_construction(pictured_scene(construction));
    write_drawing(construction.pictures / "construction", drawing, pixels_a_unit * drawing.width, store);
}

}
