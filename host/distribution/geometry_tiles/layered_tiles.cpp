#include "host/distribution/geometry_tiles/layered_tiles.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/programs/memory_limit.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace poissonlab {
namespace {

constexpr double seen_elevation = 0.3; ///< of the views of layered depth images, radians

}

PlantTileSet::PlantTileSet(PoissonTileSet set, double disk_radius, const PlantLooks& looks,
                           std::vector<PlantModel> plant_models)
    : tiles(std::move(set)), radius(disk_radius), models(std::move(plant_models))
{
    for (std::uint32_t tile = 0; tile < tiles.parameters.tiles; ++tile)
        plants.push_back(plants_of_tile(tiles, tile, radius, looks));
    for (const PlantModel& model : models) height = std::max(height, radius * looks.scale[1] * model.height);
}

DepthView LayeredTiles::view(std::uint32_t direction) const
{
    return depth_view(2 * std::numbers::pi * direction / settings_.directions, seen_elevation, set_.height);
}

void LayeredTiles::check_room(const std::vector<Key>& keys) const
{
    // Two samples a pixel are more than plants have but at coarse levels: sunflowers have 0.7 at level 0.
    constexpr double bytes_of_pixel = sizeof(std::uint32_t) + 2 * sizeof(DepthSample), gibibyte = 1 << 30;
    double bytes = 0;
    for (const auto& [tile, direction, level] : keys) {
        const DepthView seen = view(direction);
        const double pixels = settings_.resolution / std::exp2(level); // along a tile
        bytes += bytes_of_pixel * (seen.width * pixels + 1) * (seen.height * pixels + 1);
    }
    if (const auto most = static_cast<double>(memory_limit()); bytes > most)
        throw InputError(fmt::format("{} layered depth images of {} pixels a tile and coarser ones need {:.1f} GiB of "
                                     "memory: must be at most {:.1f}",
                                     keys.size(), settings_.resolution, bytes / gibibyte, most / gibibyte));
}

void LayeredTiles::make(const std::vector<Key>& keys)
{
    check_room(keys);
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<int>> levels;
    for (const auto& [tile, direction, level] : keys)
        if (!images_.contains({tile, direction, level})) levels[{tile, direction}].push_back(level);
    const std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::vector<int>>> work(levels.begin(),
                                                                                                 levels.end());
    std::vector<std::vector<LayeredDepthImage>> made(work.size());
    tbb::parallel_for(std::size_t{0}, work.size(), [&](std::size_t i) {
        stop_if_interrupted();
        const auto& [tile, direction] = work[i].first;
        const double azimuth = 2 * std::numbers::pi * direction / settings_.directions,
                     wedge = std::numbers::pi / settings_.directions;
        std::vector<DepthView> others;
        for (const auto& [turn, elevation] : {std::pair{-wedge, 0.05}, {wedge, 0.05}, {-wedge, 0.75}, {wedge, 0.75}})
            others.push_back(depth_view(azimuth + turn, elevation, set_.height));
        const std::vector<LitPlant> plants = lit_plants(set_.plants[tile], set_.models, set_.radius);
        const LayeredDepthImage finest = layered_depth_image(plants, view(direction), others, settings_.resolution);
        for (const int level : work[i].second) made[i].push_back(level == 0 ? finest : coarser(finest, level));
    });
    for (std::size_t i = 0; i < work.size(); ++i)
        for (std::size_t k = 0; k < made[i].size(); ++k)
            images_[{work[i].first.first, work[i].first.second, work[i].second[k]}] = std::move(made[i][k]);
}

PngPixels LayeredTiles::sheet() const
{
    const LayeredDepthImage& first = at({0, 0, 0});
    int side = 0;
    for (std::uint32_t k = 0; k < settings_.directions; ++k) side = std::max(side, at({0, k, 0}).columns);
    const int shrink = (side + 159) / 160; // pixels of level 0 for one of the sheet
    const int cell = (side + shrink - 1) / shrink + 4;
    const int cell_height = (first.rows + shrink - 1) / shrink + 4;
    PngPixels sheet{
        cell * static_cast<int>(settings_.directions), cell_height * static_cast<int>(settings_.levels), 3, {}};
    sheet.values.assign(sheet.at(0, sheet.height, 0), 255);
    for (std::uint32_t k = 0; k < settings_.directions; ++k)
        for (int level = 0; level < static_cast<int>(settings_.levels); ++level) {
            const LayeredDepthImage& image = at({0, k, level});
            const int margin = (side - at({0, k, 0}).columns) / 2; // of level 0, to each side
            for (int y = 0; y < cell_height - 4; ++y)
                for (int x = 0; x < cell - 4; ++x) {
                    std::array<double, 3> sum{};
                    for (int i = 0; i < shrink * shrink; ++i) {
                        const int column = (x * shrink + i % shrink - margin) >> level,
                                  row = (y * shrink + i / shrink) >> level;
                        std::array<double, 3> seen{255, 255, 255};
                        if (column >= 0 && column < image.columns && row < image.rows)
                            for (const DepthSample& s : image.at(column, row))
                                for (std::size_t c = 0; c < 3; ++c)
                                    seen[c] += std::min(1.0, image.alpha(s)) * (s.color[c] - seen[c]);
                        for (std::size_t c = 0; c < 3; ++c) sum[c] += seen[c] / (shrink * shrink);
                    }
                    for (int c = 0; c < 3; ++c)
                        sheet.values[sheet.at(static_cast<int>(k) * cell + 2 + x, (level + 1) * cell_height - 3 - y,
                                              c)] =
                            static_cast<std::uint8_t>(std::clamp(sum[static_cast<std::size_t>(c)] + 0.5, 0.0, 255.0));
                }
        }
    return sheet;
}

}
