#include "host/distribution/geometry_tiles/plant_field.hpp"

#include "base/programs/interrupt.hpp"
#include "host/distribution/geometry_tiles/triangle_fill.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double least_depth = 0.05;   ///< tiles before the camera from which on things are drawn
constexpr double seen_elevation = 0.3; ///< of the views of layered depth images, radians
constexpr int rows_at_once = 54;       ///< of samples, drawn by one thread
constexpr int ground_cells = 4;        ///< along a tile's side
constexpr double splat_size = 1.2;     ///< sides of squares, in distances of samples

constexpr ScreenColor soil{0.2F, 0.27F, 0.09F}, haze_color{0.74F, 0.82F, 0.9F}, zenith{0.33F, 0.55F, 0.86F};
constexpr std::array<ScreenColor, 8> level_colors{{{0.85F, 0.1F, 0.1F},
                                                   {0.95F, 0.75F, 0.1F},
                                                   {0.3F, 0.75F, 0.2F},
                                                   {0.1F, 0.65F, 0.75F},
                                                   {0.25F, 0.35F, 0.9F},
                                                   {0.65F, 0.25F, 0.85F},
                                                   {0.95F, 0.5F, 0.15F},
                                                   {0.5F, 0.5F, 0.5F}}};

ScreenColor blend(const ScreenColor& a, const ScreenColor& b, double part)
{
    ScreenColor color{};
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<float>(static_cast<double>(a[i]) +
                                      part * (static_cast<double>(b[i]) - static_cast<double>(a[i])));
    return color;
}

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

void LayeredTiles::make(const std::vector<Key>& keys)
{
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

/// Rows of samples, with the nearest depth where something is hidden by it.
struct PlantField::Canvas
{
    int columns, first_row, last_row;
    std::vector<ScreenColor> colors;
    std::vector<float> depths;

    Canvas(int width, int first, int last)
        : columns(width), first_row(first), last_row(last),
          colors(static_cast<std::size_t>(width) * static_cast<std::size_t>(last - first)),
          depths(colors.size(), INFINITY)
    {}

    std::size_t at(int column, int row) const
    {
        return static_cast<std::size_t>(row - first_row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }

    /// A triangle of corners with column, row and depth, where nothing nearer is; `color` is called with weights.
    template <class Color>
    void triangle(const std::array<MeshPoint, 3>& c, Color color)
    {
        if (std::min({c[0][2], c[1][2], c[2][2]}) < least_depth) return;
        fill_triangle({{{c[0][0], c[0][1]}, {c[1][0], c[1][1]}, {c[2][0], c[2][1]}}}, {columns, first_row, last_row},
                      [&](int column, int row, std::array<double, 3> w) {
                          double sum = 0; // weights in space: those of the picture over depths
                          for (std::size_t i = 0; i < 3; ++i) sum += w[i] /= c[i][2];
                          const double depth = 1 / sum;
                          const std::size_t place = at(column, row);
                          if (depth >= static_cast<double>(depths[place])) return;
                          for (double& weight : w) weight *= depth;
                          depths[place] = static_cast<float>(depth);
                          colors[place] = color(w, depth);
                      });
    }
};

PlantField::PlantField(const PlantTileSet& set, const PoissonTiling& tiling, const FieldSettings& settings,
                       std::optional<Terrain> terrain)
    : set_(set), tiling_(runtime_tiling(set.tiles, tiling)), settings_(settings), terrain_(std::move(terrain))
{
    columns_ = static_cast<int>(settings.pixels) * field_samples;
    rows_ = static_cast<int>(settings.pixels * 9 / 16) * field_samples;
    eye_ = {settings.eye[0], settings.eye[1], settings.eye[2] + ground(settings.eye[0], settings.eye[1])};
    const double h = settings.heading * degree, p = settings.pitch * degree;
    ahead_ = {std::cos(h) * std::cos(p), std::sin(h) * std::cos(p), -std::sin(p)};
    right_ = {std::sin(h), -std::cos(h), 0};
    down_ = cross(ahead_, right_);
    focal_ = columns_ / 2.0 / std::tan(settings.angle_of_view * degree / 2);
    choose_tiles();
}

MeshPoint PlantField::on_screen(const MeshPoint& place) const
{
    const MeshPoint d = difference(place, eye_);
    const double depth = dot(d, ahead_), scale = focal_ / std::max(depth, 1e-9);
    return {columns_ / 2.0 + scale * dot(d, right_), rows_ / 2.0 + scale * dot(d, down_), depth};
}

/// The lowest and highest row of samples that something above the tile may fill.
std::array<double, 2> PlantField::rows_of(const FieldTile& tile) const
{
    std::array<double, 2> rows{INFINITY, -INFINITY};
    for (int i = 0; i < 8; ++i) {
        const double z = i < 4 ? tile.ground[0] - 0.1 : tile.ground[1] + set_.height + 0.1;
        const MeshPoint p = on_screen({tile.x - 0.2 + 1.4 * (i & 1), tile.y - 0.2 + 1.4 * (i >> 1 & 1), z});
        if (p[2] < least_depth) return {-INFINITY, INFINITY};
        rows = {std::min(rows[0], p[1]), std::max(rows[1], p[1])};
    }
    return rows;
}

bool PlantField::may_be_seen(std::int32_t x, std::int32_t y) const
{
    const MeshPoint middle{x + 0.5, y + 0.5, ground(x + 0.5, y + 0.5) + set_.height / 2};
    const MeshPoint d = difference(middle, eye_);
    const double reach = 1.0 + set_.height, ahead = dot(d, ahead_);
    const double half = columns_ / 2.0 / focal_; // tangent of half the angle
    return ahead > -reach && std::abs(dot(d, right_)) < half * ahead + reach * std::sqrt(1 + half * half);
}

void PlantField::choose_tiles()
{
    for (std::uint32_t j = 0; j < settings_.field[1]; ++j)
        for (std::uint32_t i = 0; i < settings_.field[0]; ++i) {
            FieldTile tile{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
            if (!may_be_seen(tile.x, tile.y)) continue;
            tile.ground = {INFINITY, -INFINITY};
            for (int k = 0; k < (ground_cells + 1) * (ground_cells + 1); ++k) {
                const double z = ground(i + k % (ground_cells + 1) / double{ground_cells},
                                        j + k / (ground_cells + 1) / double{ground_cells});
                tile.ground = {std::min(tile.ground[0], z), std::max(tile.ground[1], z)};
            }
            tile.tile = ptiles_tile(&tiling_, tile.x, tile.y, 0);
            const MeshPoint middle{i + 0.5, j + 0.5, ground(i + 0.5, j + 0.5) + set_.height / 2};
            const MeshPoint to_eye = difference(eye_, middle);
            tile.distance = std::sqrt(dot(to_eye, to_eye));
            const double part = std::atan2(to_eye[1], to_eye[0]) / (2 * std::numbers::pi) * settings_.directions;
            const auto n = static_cast<int>(settings_.directions);
            tile.direction = static_cast<std::uint32_t>((static_cast<int>(std::floor(part + 0.5)) + n) % n);
            const double wanted = settings_.sample_size * field_samples * std::max(tile.distance, least_depth) *
                                  settings_.resolution / focal_;
            while (tile.level + 1 < static_cast<int>(settings_.levels) && wanted >= 2 << tile.level) ++tile.level;
            seen_.push_back(tile);
        }
    // Along x and along y, tiles that are farther from the camera's tile come first.
    const auto rank = [&](const FieldTile& t) {
        return std::abs(t.x - std::floor(eye_[0])) + std::abs(t.y - std::floor(eye_[1]));
    };
    std::ranges::stable_sort(seen_, [&](const FieldTile& a, const FieldTile& b) { return rank(a) > rank(b); });
}

std::vector<LayeredTiles::Key> PlantField::needed() const
{
    std::vector<LayeredTiles::Key> keys;
    for (const FieldTile& t : seen_) keys.emplace_back(t.tile, t.direction, t.level);
    std::ranges::sort(keys);
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

ScreenColor PlantField::hazy(const ScreenColor& color, double depth) const
{
    return blend(color, haze_color, depth / (depth + settings_.haze));
}

void PlantField::draw_sky_and_ground(Canvas& canvas, double moved) const
{
    for (int row = canvas.first_row; row < canvas.last_row; ++row)
        for (int column = 0; column < columns_; ++column) {
            const MeshPoint d{0, (row + 0.5 - rows_ / 2.0) / focal_, 1};
            const double up = ahead_[2] * d[2] + down_[2] * d[1];
            canvas.colors[canvas.at(column, row)] = blend(haze_color, zenith, std::clamp(2 * up, 0.0, 1.0));
        }
    for (const FieldTile& tile : seen_) {
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
                const auto color = [&](const std::array<double, 3>&, double depth) { return hazy(lit, depth); };
                canvas.triangle({screen[j][i], screen[j][i + 1], screen[j + 1][i + 1]}, color);
                canvas.triangle({screen[j][i], screen[j + 1][i + 1], screen[j + 1][i]}, color);
            }
    }
}

void PlantField::draw_plants(Canvas& canvas, const FieldTile& tile, double moved) const
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

void PlantField::draw_image(Canvas& canvas, const FieldTile& tile, const LayeredDepthImage& image, bool by_level) const
{
    const std::vector<Plant>& plants = set_.plants[tile.tile];
    std::vector<double> feet;
    for (const Plant& plant : plants) feet.push_back(ground(tile.x + plant.x, tile.y + plant.y));
    // The ground's slope shears the tile. What hides what stays the same where the eye is sheared back.
    const double x = tile.x + 0.5, y = tile.y + 0.5, east = eye_[0] - x, north = eye_[1] - y;
    const double plane = ground(x, y) + east * (ground(x + 0.5, y) - ground(x - 0.5, y)) +
                         north * (ground(x, y + 0.5) - ground(x, y - 0.5));
    const MeshPoint eye = image.view.seen({east, north, eye_[2] - plane});
    const auto order = [&](double middle, int count) { // from both ends to the pixel in which the camera is seen
        std::vector<int> numbers;
        const int turn = static_cast<int>(std::clamp(std::floor(middle / image.pixel), -1.0, count - 1.0));
        for (int i = 0; i <= turn; ++i) numbers.push_back(i);
        for (int i = count - 1; i > turn; --i) numbers.push_back(i);
        return numbers;
    };
    const std::vector<int> columns = order(eye[0], image.columns), rows = order(eye[1], image.rows);
    for (const int row : rows)
        for (const int column : columns)
            for (const DepthSample& s : image.at(column, row)) {
                const MeshPoint p = image.place(column, row, s);
                const MeshPoint seen = on_screen({p[0] + x, p[1] + y, p[2] + feet[s.plant]});
                if (seen[2] < least_depth) continue;
                const double half = splat_size / 2 * focal_ * image.pixel / seen[2];
                const auto ends = [half](double middle, int least, int most) {
                    int first = static_cast<int>(std::ceil(std::clamp<double>(middle - half - 0.5, least - 1, most)));
                    int last = static_cast<int>(std::floor(std::clamp<double>(middle + half - 0.5, least - 1, most)));
                    if (first > last)
                        first = last = static_cast<int>(std::floor(std::clamp<double>(middle, least - 1, most)));
                    return std::array{std::max(first, least), std::min(last, most - 1)};
                };
                const auto [first_row, last_row] = ends(seen[1], canvas.first_row, canvas.last_row);
                if (first_row > last_row) continue;
                const auto [first_column, last_column] = ends(seen[0], 0, canvas.columns);
                ScreenColor color = by_level ? level_colors[static_cast<std::size_t>(image.level)] : ScreenColor{};
                for (std::size_t k = 0; k < 3; ++k)
                    color[k] = by_level ? color[k] * (0.35F + 0.65F * s.color[1] / 255.0F) : s.color[k] / 255.0F;
                color = hazy(color, seen[2]);
                // More of a splat than its sample stands for lets as much more through, unless nothing shines through.
                const double side = focal_ * image.pixel / seen[2];
                const double splat = (last_row - first_row + 1.0) * (last_column - first_column + 1.0);
                const double alpha = 1 - std::pow(1 - image.alpha(s), std::min(1.0, side * side / splat));
                for (int i = first_row; i <= last_row; ++i)
                    for (int k = first_column; k <= last_column; ++k) {
                        const std::size_t place = canvas.at(k, i);
                        if (seen[2] >= static_cast<double>(canvas.depths[place]) + 1.5 * image.pixel) continue;
                        canvas.colors[place] = blend(canvas.colors[place], color, alpha);
                        if (alpha >= 1)
                            canvas.depths[place] = std::min(canvas.depths[place], static_cast<float>(seen[2]));
                    }
            }
}

/// Draws bands of rows side by side, and takes the means of samples.
template <class Draw>
PngPixels PlantField::picture(Draw draw) const
{
    PngPixels pixels{columns_ / field_samples, rows_ / field_samples, 3, {}};
    pixels.values.resize(pixels.at(0, pixels.height, 0));
    tbb::parallel_for(0, (rows_ + rows_at_once - 1) / rows_at_once, [&](int band) {
        stop_if_interrupted();
        Canvas canvas(columns_, band * rows_at_once, std::min(rows_, (band + 1) * rows_at_once));
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

PngPixels PlantField::whole(double moved) const
{
    return picture([&](Canvas& canvas) {
        draw_sky_and_ground(canvas, moved);
        for (const FieldTile& tile : seen_) {
            const auto [low, high] = rows_of(tile);
            if (high >= canvas.first_row && low <= canvas.last_row) draw_plants(canvas, tile, moved);
        }
    });
}

PngPixels PlantField::layered(const LayeredTiles& images, bool by_level) const
{
    return picture([&](Canvas& canvas) {
        draw_sky_and_ground(canvas, 0);
        for (const FieldTile& tile : seen_) {
            const auto [low, high] = rows_of(tile);
            if (high >= canvas.first_row && low <= canvas.last_row)
                draw_image(canvas, tile, images.at({tile.tile, tile.direction, tile.level}), by_level);
        }
    });
}

std::vector<FieldCost> PlantField::costs(const LayeredTiles& images) const
{
    std::vector<FieldCost> costs;
    for (const FieldTile& tile : seen_) {
        const auto band = static_cast<std::size_t>(std::max(0, std::ilogb(tile.distance)));
        if (costs.size() <= band) costs.resize(band + 1);
        FieldCost& cost = costs[band];
        ++cost.tiles;
        cost.samples += images.at({tile.tile, tile.direction, tile.level}).samples.size();
        for (const Plant& plant : set_.plants[tile.tile])
            if (plant.is_in_tile()) cost.triangles += set_.models[plant.model].triangles.size();
    }
    return costs;
}

PngPixels PlantField::plan() const
{
    const auto [width, height] = settings_.field;
    const int side = std::max(1, static_cast<int>(512 / std::max(width, height)));
    PngPixels plan{static_cast<int>(width) * side, static_cast<int>(height) * side, 3, {}};
    plan.values.assign(plan.at(0, plan.height, 0), 235);
    for (const FieldTile& t : seen_)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                for (int k = 0; k < 3; ++k) {
                    const float color = level_colors[static_cast<std::size_t>(t.level)][static_cast<std::size_t>(k)];
                    plan.values[plan.at(t.x * side + x, plan.height - 1 - t.y * side - y, k)] =
                        static_cast<std::uint8_t>(255 * color * (t.direction % 2 == 0 ? 1.0F : 0.75F));
                }
    return plan;
}

}
