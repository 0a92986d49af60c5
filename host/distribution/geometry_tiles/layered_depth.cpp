#include "host/distribution/geometry_tiles/layered_depth.hpp"

#include "host/distribution/geometry_tiles/triangle_fill.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace poissonlab {
namespace {

constexpr MeshPoint tile_middle{0.5, 0.5, 0};

/// Samples of a pixel are one where their depths differ by less than so many sides of it.
constexpr double same_depth = 1.0;

/// A sample and its pixel.
struct PlacedSample
{
    std::uint32_t pixel = 0;
    DepthSample sample;
};

/// A sample stands for so many pixels of surface at most: surfaces that are nearly seen from their edge have others.
constexpr double most_area = 3.9;

std::uint8_t byte_of(double part) { return static_cast<std::uint8_t>(std::clamp(part, 0.0, 255.0)); }

/// Makes a sample that knows the surface of its triangle.
DepthSample sample_of_surface(const LitPlant& plant, const MeshTriangle& t, const DepthView& view)
{
    const auto place = [&](std::size_t i) -> const MeshPoint& { return plant.vertices[t[i]].place; };
    const MeshPoint normal = unit(cross(difference(place(1), place(0)), difference(place(2), place(0))));
    const double sign = normal[2] < 0 ? -127 : 127;
    DepthSample sample;
    sample.area = byte_of(64 * std::min(most_area, 1 / std::max(std::abs(dot(normal, view.back)), 0.01)));
    for (std::size_t k = 0; k < 2; ++k) sample.normal[k] = static_cast<std::int8_t>(std::lround(sign * normal[k]));
    return sample;
}

LayeredDepthImage empty_image(const DepthView& view, int level, std::uint32_t resolution)
{
    LayeredDepthImage image;
    image.view = view;
    image.level = level;
    image.pixel = static_cast<double>(1 << level) / resolution;
    image.columns = std::max(1, static_cast<int>(std::ceil(view.width / image.pixel)));
    image.rows = std::max(1, static_cast<int>(std::ceil(view.height / image.pixel)));
    return image;
}

/// Sorts samples by pixels, and in pixels from the farthest to the nearest.
void set_samples(LayeredDepthImage& image, std::vector<PlacedSample> placed)
{
    std::ranges::stable_sort(placed, [](const PlacedSample& a, const PlacedSample& b) {
        return a.pixel != b.pixel ? a.pixel < b.pixel : a.sample.depth > b.sample.depth;
    });
    image.first.assign(static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows) + 1, 0);
    for (const PlacedSample& s : placed) {
        ++image.first[s.pixel + 1];
        image.samples.push_back(s.sample);
    }
    for (std::size_t i = 1; i < image.first.size(); ++i) image.first[i] += image.first[i - 1];
}

}

double DepthSample::side_from(const MeshPoint& direction) const
{
    if (area == 0) return 1;
    const double x = normal[0] / 127.0, y = normal[1] / 127.0, z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
    return std::sqrt(area / 64.0 * std::abs(dot({x, y, z}, direction)));
}

MeshPoint DepthView::seen(const MeshPoint& place) const
{
    return {dot(place, right) - left, dot(place, up) - bottom, -dot(place, back)};
}

MeshPoint DepthView::place(const MeshPoint& seen) const
{
    MeshPoint result{};
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = (seen[0] + left) * right[i] + (seen[1] + bottom) * up[i] - seen[2] * back[i];
    return result;
}

DepthView depth_view(double azimuth, double elevation, double height)
{
    const double c = std::cos(azimuth), s = std::sin(azimuth), ce = std::cos(elevation), se = std::sin(elevation);
    DepthView view{{-s, c, 0}, {-c * se, -s * se, ce}, {c * ce, s * ce, se}};
    const double half = (std::abs(c) + std::abs(s)) / 2;
    view.left = -half;
    view.width = 2 * half;
    view.bottom = -half * se;
    view.height = 2 * half * se + height * ce;
    return view;
}

std::vector<LitPlant> lit_plants(const std::vector<Plant>& plants, const std::vector<PlantModel>& models, double radius)
{
    std::vector<LitPlant> lit;
    for (const Plant& plant : plants) {
        lit.push_back({&models[plant.model], {}});
        light_plant(models[plant.model], plant, radius, lit.back().vertices);
    }
    return lit;
}

LayeredDepthImage depth_picture(const std::vector<LitPlant>& plants, const DepthView& view, std::uint32_t resolution)
{
    LayeredDepthImage image = empty_image(view, 0, resolution);
    const std::size_t pixels = static_cast<std::size_t>(image.columns) * static_cast<std::size_t>(image.rows);
    std::vector<DepthSample> nearest(pixels, {.depth = INFINITY});
    std::vector<MeshPoint> seen;
    for (std::size_t number = 0; number < plants.size(); ++number) {
        const LitPlant& plant = plants[number];
        seen.clear();
        for (const LitVertex& v : plant.vertices) seen.push_back(view.seen(difference(v.place, tile_middle)));
        for (const MeshTriangle& t : plant.model->triangles) {
            std::array<FillCorner, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) corners[i] = {seen[t[i]][0] / image.pixel, seen[t[i]][1] / image.pixel};
            const DepthSample of_surface = sample_of_surface(plant, t, view);
            fill_triangle(corners, {image.columns, 0, image.rows},
                          [&](int column, int row, const std::array<double, 3>& w) {
                              std::array<double, 6> mean{}; // x, y and colour
                              double depth = 0;
                              for (std::size_t i = 0; i < 3; ++i) {
                                  const LitVertex& v = plant.vertices[t[i]];
                                  depth += w[i] * seen[t[i]][2];
                                  for (std::size_t k = 0; k < 2; ++k) mean[k] += w[i] * v.place[k];
                                  for (std::size_t k = 0; k < 3; ++k)
                                      mean[2 + k] += w[i] * static_cast<double>(v.color[k]);
                              }
                              DepthSample& sample =
                                  nearest[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.columns) +
                                          static_cast<std::size_t>(column)];
                              const bool is_above_tile = mean[0] >= 0 && mean[0] < 1 && mean[1] >= 0 && mean[1] < 1;
                              if (!is_above_tile || static_cast<float>(depth) >= sample.depth) return;
                              sample = of_surface;
                              sample.depth = static_cast<float>(depth);
                              sample.plant = static_cast<std::uint16_t>(number);
                              for (std::size_t k = 0; k < 3; ++k) sample.color[k] = byte_of(255 * mean[2 + k] + 0.5);
                          });
        }
    }
    image.first.push_back(0);
    for (const DepthSample& sample : nearest) {
        if (std::isfinite(sample.depth)) image.samples.push_back(sample);
        image.first.push_back(static_cast<std::uint32_t>(image.samples.size()));
    }
    return image;
}

LayeredDepthImage layered_depth_image(const std::vector<LitPlant>& plants, const DepthView& view,
                                      const std::vector<DepthView>& others, std::uint32_t resolution)
{
    LayeredDepthImage image = depth_picture(plants, view, resolution);
    std::vector<std::vector<DepthSample>> layers(image.first.size() - 1);
    for (std::size_t i = 0; i < layers.size(); ++i)
        layers[i].assign(image.samples.begin() + image.first[i], image.samples.begin() + image.first[i + 1]);
    for (const DepthView& other : others) {
        const LayeredDepthImage picture = depth_picture(plants, other, resolution);
        for (int row = 0; row < picture.rows; ++row)
            for (int column = 0; column < picture.columns; ++column)
                for (DepthSample sample : picture.at(column, row)) {
                    const MeshPoint seen = view.seen(picture.place(column, row, sample));
                    const double x = seen[0] / image.pixel, y = seen[1] / image.pixel;
                    if (!(x >= 0 && y >= 0 && x < image.columns && y < image.rows)) continue;
                    std::vector<DepthSample>& layer =
                        layers[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.columns) +
                               static_cast<std::size_t>(x)];
                    sample.depth = static_cast<float>(seen[2]);
                    sample.right = byte_of(256 * (x - std::floor(x)));
                    sample.up = byte_of(256 * (y - std::floor(y)));
                    const bool is_known = std::ranges::any_of(layer, [&](const DepthSample& known) {
                        return known.plant == sample.plant &&
                               std::abs(static_cast<double>(known.depth) - static_cast<double>(sample.depth)) <
                                   same_depth * image.pixel;
                    });
                    if (!is_known) layer.push_back(sample);
                }
    }
    std::vector<PlacedSample> placed;
    for (std::size_t i = 0; i < layers.size(); ++i)
        for (const DepthSample& sample : layers[i]) placed.push_back({static_cast<std::uint32_t>(i), sample});
    image.samples.clear();
    set_samples(image, std::move(placed));
    return image;
}

LayeredDepthImage coarser(const LayeredDepthImage& finest, int level)
{
    LayeredDepthImage image =
        empty_image(finest.view, level, static_cast<std::uint32_t>(std::lround(1 / finest.pixel)));
    struct Member
    {
        std::uint32_t pixel, plant;
        int depth_step;
        std::uint32_t fine_pixel;
        double x, y; ///< in pixels of the level
        const DepthSample* sample;
    };
    std::vector<Member> members;
    const double part = 1.0 / (1 << level);
    for (int row = 0; row < finest.rows; ++row)
        for (int column = 0; column < finest.columns; ++column)
            for (const DepthSample& s : finest.at(column, row))
                members.push_back({static_cast<std::uint32_t>((row >> level) * image.columns + (column >> level)),
                                   s.plant,
                                   static_cast<int>(std::floor(static_cast<double>(s.depth) / (2 * image.pixel))),
                                   static_cast<std::uint32_t>(row * finest.columns + column),
                                   (column + s.right / 256.0) * part, (row + s.up / 256.0) * part, &s});
    const auto group = [](const Member& m) { return std::tie(m.pixel, m.plant, m.depth_step); };
    std::ranges::stable_sort(members, [&](const Member& a, const Member& b) {
        return std::tuple_cat(group(a), std::tie(a.fine_pixel)) < std::tuple_cat(group(b), std::tie(b.fine_pixel));
    });
    std::vector<PlacedSample> placed;
    for (std::size_t begin = 0, end = 0; begin < members.size(); begin = end) {
        std::array<double, 6> sum{}; // x, y, depth, colour
        std::uint16_t covered = 0;
        for (end = begin; end < members.size() && group(members[end]) == group(members[begin]); ++end) {
            const Member& m = members[end];
            covered += end == begin || m.fine_pixel != members[end - 1].fine_pixel;
            sum[0] += m.x;
            sum[1] += m.y;
            sum[2] += static_cast<double>(m.sample->depth);
            for (std::size_t k = 0; k < 3; ++k) sum[3 + k] += m.sample->color[k];
        }
        for (double& s : sum) s /= static_cast<double>(end - begin);
        const Member& m = members[begin];
        PlacedSample one{m.pixel, {.depth = static_cast<float>(sum[2]), .plant = m.sample->plant, .covered = covered}};
        one.sample.right = byte_of(256 * (sum[0] - static_cast<int>(m.pixel) % image.columns));
        one.sample.up = byte_of(256 * (sum[1] - static_cast<int>(m.pixel) / image.columns));
        for (std::size_t k = 0; k < 3; ++k) one.sample.color[k] = byte_of(sum[3 + k] + 0.5);
        placed.push_back(one);
    }
    set_samples(image, std::move(placed));
    return image;
}

}
