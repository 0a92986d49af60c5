#include "host/distribution/geometry_tiles/plant_field.hpp"

#include "host/distribution/geometry_tiles/plant_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double degree = std::numbers::pi / 180;

}

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

bool PlantField::may_be_seen(const FieldTile& tile) const
{
    const auto [low, high] = tile.ground;
    const MeshPoint middle{tile.x + 0.5, tile.y + 0.5, (low + high + set_.height) / 2};
    const MeshPoint d = difference(middle, eye_);
    const double reach = 1.0 + set_.height + (high - low) / 2, ahead = dot(d, ahead_);
    const double half = columns_ / 2.0 / focal_; // tangent of half the angle
    return ahead > -reach && std::abs(dot(d, right_)) < half * ahead + reach * std::sqrt(1 + half * half);
}

void PlantField::choose_tiles()
{
    for (std::uint32_t j = 0; j < settings_.field[1]; ++j)
        for (std::uint32_t i = 0; i < settings_.field[0]; ++i) {
            FieldTile tile{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
            tile.ground = {INFINITY, -INFINITY};
            for (int k = 0; k < (ground_cells + 1) * (ground_cells + 1); ++k) {
                const double z = ground(i + k % (ground_cells + 1) / double{ground_cells},
                                        j + k / (ground_cells + 1) / double{ground_cells});
                tile.ground = {std::min(tile.ground[0], z), std::max(tile.ground[1], z)};
            }
            if (!may_be_seen(tile)) continue;
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
                    const float color =
                        plant_level_colors[static_cast<std::size_t>(t.level)][static_cast<std::size_t>(k)];
                    plan.values[plan.at(t.x * side + x, plan.height - 1 - t.y * side - y, k)] =
                        static_cast<std::uint8_t>(255 * color * (t.direction % 2 == 0 ? 1.0F : 0.75F));
                }
    return plan;
}

}
