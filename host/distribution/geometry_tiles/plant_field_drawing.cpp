// Fields of plants are drawn in bands of rows, side by side.
#include "base/programs/interrupt.hpp"
#include "host/distribution/geometry_tiles/plant_canvas.hpp"
#include "host/distribution/geometry_tiles/plant_field.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr int rows_at_once = 54;                  ///< of samples, drawn by one thread
constexpr double splat_size = 1.2;                ///< sides of squares, in distances of samples
constexpr double least_side = 0.8, most_side = 2; ///< of surfaces in pixels: thin ones hide no more than they are

constexpr ScreenColor soil{0.2F, 0.27F, 0.09F}, haze_color{0.74F, 0.82F, 0.9F}, white{1, 1, 1},
    zenith{0.33F, 0.55F, 0.86F};

}

ScreenColor PlantField::hazy(const ScreenColor& color, double depth) const
{
    return blend(color, haze_color, depth / (depth + settings_.haze));
}

void PlantField::draw_sky_and_ground(PlantCanvas& canvas, double moved, FieldColors colors) const
{
    const bool is_cover = colors == FieldColors::cover;
    for (int row = canvas.first_row; row < canvas.last_row; ++row)
        for (int column = 0; column < columns_; ++column) {
            const MeshPoint d{0, (row + 0.5 - rows_ / 2.0) / focal_, 1};
            const double up = ahead_[2] * d[2] + down_[2] * d[1];
            canvas.colors[canvas.at(column, row)] =
                is_cover ? ScreenColor{} : blend(haze_color, zenith, std::clamp(2 * up, 0.0, 1.0));
        }
    for (const FieldTile& tile : seen_) {
        stop_if_interrupted();
        const auto [low, high] = rows_of(tile);
        if (high < canvas.first_row || low > canvas.last_row) continue;
        std::array<std::array<MeshPoint, ground_cells + 1>, ground_cells + 1> screen{}, space{};
        for (int j = 0; j <= ground_cells; ++j)
            for (int i = 0; i <= ground_cells; ++i) {
                const double x = tile.x + i / double{ground_cells}, y = tile.y + j / double{ground_cells};
                MeshPoint& place = space[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
                place = {x, y, ground(x, y)};
                MeshPoint& seen = screen[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
                seen = on_screen(place);
                for (std::size_t k = 0; k < 2; ++k) seen[k] += moved;
            }
        for (std::size_t j = 0; j < ground_cells; ++j)
            for (std::size_t i = 0; i < ground_cells; ++i) {
                const MeshPoint normal =
                    unit(cross(difference(space[j][i + 1], space[j][i]), difference(space[j + 1][i], space[j][i])));
                const double light = 0.45 + 0.75 * light_through(normal);
                const ScreenColor lit{static_cast<float>(soil[0] * light), static_cast<float>(soil[1] * light),
                                      static_cast<float>(soil[2] * light)};
                const auto color = [&](const std::array<double, 3>&, double depth) {
                    return is_cover ? ScreenColor{} : hazy(lit, depth);
                };
                canvas.triangle({screen[j][i], screen[j][i + 1], screen[j + 1][i + 1]}, color);
                canvas.triangle({screen[j][i], screen[j + 1][i + 1], screen[j + 1][i]}, color);
            }
    }
}

void PlantField::draw_plants(PlantCanvas& canvas, const FieldTile& tile, double moved, FieldColors colors) const
{
    std::vector<LitVertex> vertices;
    std::vector<MeshPoint> screen;
    for (const Plant& plant : set_.plants[tile.tile]) {
        if (!plant.is_in_tile()) continue;
        const PlantModel& model = set_.models[plant.model];
        light_plant(model, plant, set_.radius, vertices);
        const MeshPoint lift{static_cast<double>(tile.x), static_cast<double>(tile.y),
                             ground(tile.x + plant.x, tile.y + plant.y)};
        screen.clear();
        for (const LitVertex& v : vertices) {
            screen.push_back(on_screen({v.place[0] + lift[0], v.place[1] + lift[1], v.place[2] + lift[2]}));
            for (std::size_t k = 0; k < 2; ++k) screen.back()[k] += moved;
        }
        for (const MeshTriangle& t : model.triangles)
            canvas.triangle({screen[t[0]], screen[t[1]], screen[t[2]]},
                            [&](const std::array<double, 3>& w, double depth) {
                                if (colors == FieldColors::cover) return white;
                                ScreenColor color{};
                                for (std::size_t k = 0; k < 3; ++k) {
                                    double sum = 0;
                                    for (std::size_t i = 0; i < 3; ++i)
                                        sum += w[i] * static_cast<double>(vertices[t[i]].color[k]);
                                    color[k] = static_cast<float>(sum);
                                }
                                return hazy(color, depth);
                            });
    }
}

void PlantField::draw_image(PlantCanvas& canvas, const FieldTile& tile, const LayeredDepthImage& image,
                            FieldColors colors) const
{
    const bool by_level = colors == FieldColors::levels;
    const std::vector<Plant>& plants = set_.plants[tile.tile];
    std::vector<double> feet;
    for (const Plant& plant : plants) feet.push_back(ground(tile.x + plant.x, tile.y + plant.y));
    // The ground's slope shears the tile. What hides what stays the same where the eye is sheared back.
    const double x = tile.x + 0.5, y = tile.y + 0.5, east = eye_[0] - x, north = eye_[1] - y;
    const double plane = ground(x, y) + east * (ground(x + 0.5, y) - ground(x - 0.5, y)) +
                         north * (ground(x, y + 0.5) - ground(x, y - 0.5));
    const MeshPoint eye = image.view.seen({east, north, eye_[2] - plane});
    draw_from_farthest(image, eye, [&](int column, int row, const DepthSample& s) {
        const MeshPoint p = image.place(column, row, s);
        const MeshPoint seen = on_screen({p[0] + x, p[1] + y, p[2] + feet[s.plant]});
        if (seen[2] < least_depth) return;
        const MeshPoint to_eye = unit({eye_[0] - p[0] - x, eye_[1] - p[1] - y, eye_[2] - p[2] - feet[s.plant]});
        const double half =
            splat_size / 2 * std::clamp(s.side_from(to_eye), least_side, most_side) * focal_ * image.pixel / seen[2];
        const auto ends = [half](double middle, int least, int most) {
            int first = static_cast<int>(std::ceil(std::clamp<double>(middle - half - 0.5, least - 1, most)));
            int last = static_cast<int>(std::floor(std::clamp<double>(middle + half - 0.5, least - 1, most)));
            if (first > last) first = last = static_cast<int>(std::floor(std::clamp<double>(middle, least - 1, most)));
            return std::array{std::max(first, least), std::min(last, most - 1)};
        };
        const auto [first_row, last_row] = ends(seen[1], canvas.first_row, canvas.last_row);
        if (first_row > last_row) return;
        const auto [first_column, last_column] = ends(seen[0], 0, canvas.columns);
        ScreenColor color = by_level ? plant_level_colors[static_cast<std::size_t>(image.level)] : ScreenColor{};
        for (std::size_t k = 0; k < 3; ++k)
            color[k] = by_level ? color[k] * (0.35F + 0.65F * s.color[1] / 255.0F) : s.color[k] / 255.0F;
        color = colors == FieldColors::cover ? white : hazy(color, seen[2]);
        // More of a splat than its sample stands for lets as much more through, unless nothing shines through.
        const double side = focal_ * image.pixel / seen[2];
        const double splat = (last_row - first_row + 1.0) * (last_column - first_column + 1.0);
        const double alpha = 1 - std::pow(1 - image.alpha(s), std::min(1.0, side * side / splat));
        for (int i = first_row; i <= last_row; ++i)
            for (int k = first_column; k <= last_column; ++k) {
                const std::size_t place = canvas.at(k, i);
                if (seen[2] >= static_cast<double>(canvas.depths[place]) + 1.5 * image.pixel) continue;
                canvas.colors[place] = blend(canvas.colors[place], color, alpha);
                if (alpha >= 1) canvas.depths[place] = std::min(canvas.depths[place], static_cast<float>(seen[2]));
            }
    });
}

/// Draws bands of rows side by side, and takes the means of samples.
template <class Draw>
PngPixels PlantField::picture(Draw draw) const
{
    PngPixels pixels{columns_ / field_samples, rows_ / field_samples, 3, {}};
    pixels.values.resize(pixels.at(0, pixels.height, 0));
    tbb::parallel_for(0, (rows_ + rows_at_once - 1) / rows_at_once, [&](int band) {
        stop_if_interrupted();
        PlantCanvas canvas(columns_, band * rows_at_once, std::min(rows_, (band + 1) * rows_at_once));
        draw(canvas);
        for (int row = canvas.first_row / field_samples; row < canvas.last_row / field_samples; ++row)
            for (int column = 0; column < pixels.width; ++column)
                for (int k = 0; k < 3; ++k) {
                    float sum = 0;
                    for (int i = 0; i < field_samples * field_samples; ++i)
                        sum += canvas.colors[canvas.at(field_samples * column + i % field_samples,
                                                       field_samples * row + i / field_samples)]
                                            [static_cast<std::size_t>(k)];
                    const float mean = std::clamp(sum / (field_samples * field_samples), 0.0F, 1.0F);
                    pixels.values[pixels.at(column, row, k)] = static_cast<std::uint8_t>(255 * mean + 0.5F);
                }
    });
    return pixels;
}

PngPixels PlantField::whole(double moved, FieldColors colors) const
{
    return picture([&](PlantCanvas& canvas) {
        draw_sky_and_ground(canvas, moved, colors);
        for (const FieldTile& tile : seen_) {
            stop_if_interrupted();
            const auto [low, high] = rows_of(tile);
            if (high >= canvas.first_row && low <= canvas.last_row) draw_plants(canvas, tile, moved, colors);
        }
    });
}

PngPixels PlantField::layered(const LayeredTiles& images, FieldColors colors) const
{
    return picture([&](PlantCanvas& canvas) {
        draw_sky_and_ground(canvas, 0, colors);
        for (const FieldTile& tile : seen_) {
            stop_if_interrupted();
            const auto [low, high] = rows_of(tile);
            if (high >= canvas.first_row && low <= canvas.last_row)
                draw_image(canvas, tile, images.at({tile.tile, tile.direction, tile.level}), colors);
        }
    });
}

}
