#include "host/distribution/geometry_tiles/plant_model.hpp"

#include "base/errors/errors.hpp"
#include "tiles/poisson/tile_lookup.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double turn = 2 * std::numbers::pi;

MeshPoint plus(const MeshPoint& a, const MeshPoint& b, double times = 1)
{
    return {a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]};
}

ScreenColor mixed(const ScreenColor& a, const ScreenColor& b, double part)
{
    ScreenColor color{};
    for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<float>(a[i] + (b[i] - a[i]) * part);
    return color;
}

/// The middle, normal and radii of a head.
struct Head
{
    MeshPoint middle, normal, side, up;

    MeshPoint at(double radius, double angle, double forward) const
    {
        return plus(plus(plus(middle, side, radius * std::cos(angle)), up, radius * std::sin(angle)), normal, forward);
    }
};

/// One variation of a sunflower, part by part. Normals are those of the parts' surfaces.
class SunflowerBuilder
{
public:
    explicit SunflowerBuilder(std::uint32_t number) : number_(number)
    {
        height_ = between(4.3, 5.5);
        const double rise = between(0.15, 0.5); // of the head's direction, radians
        head_ = {{0.12, between(-0.06, 0.06), height_},
                 {std::cos(rise), 0, std::sin(rise)},
                 {0, 1, 0},
                 {-std::sin(rise), 0, std::cos(rise)}};
    }

    PlantModel build()
    {
        add_stem();
        const int leaves = static_cast<int>(between(8, 12));
        for (int i = 0; i < leaves; ++i) add_leaf(i, leaves);
        add_disc();
        const int petals = static_cast<int>(between(15, 20));
        for (int i = 0; i < 2 * petals; ++i) add_petal(i, petals);
        return std::move(model_);
    }

private:
    /// The next number of this variation, evenly between two.
    double between(double low, double high)
    {
        return low + (high - low) * (ptiles_hash(0x5f10e5, number_, drawn_++, 0) >> 8) / 16777216.0;
    }

    std::uint32_t vertex(const MeshPoint& place, const MeshPoint& normal, const ScreenColor& color)
    {
        model_.places.push_back(place);
        model_.normals.push_back(unit(normal));
        model_.colors.push_back(color);
        return static_cast<std::uint32_t>(model_.places.size() - 1);
    }

    /// Joins two rows of as many vertices by triangles.
    void strip(std::uint32_t first, std::uint32_t second, std::uint32_t count)
    {
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            model_.triangles.push_back({first + i, first + i + 1, second + i});
            model_.triangles.push_back({first + i + 1, second + i + 1, second + i});
        }
    }

    MeshPoint stem_at(double part) const
    {
        const MeshPoint& top = head_.middle;
        const double bend = part * part;
        return {(top[0] - 0.1) * bend, top[1] * bend, top[2] * part};
    }

    void add_stem()
    {
        constexpr std::uint32_t sides = 6;
        constexpr int pieces = 6;
        for (int i = 0; i <= pieces; ++i) {
            const double part = static_cast<double>(i) / pieces, radius = 0.075 - 0.025 * part;
            for (std::uint32_t k = 0; k <= sides; ++k) {
                const MeshPoint out{std::cos(turn * k / sides), std::sin(turn * k / sides), 0};
                vertex(plus(stem_at(part), out, radius), out, mixed({0.3F, 0.42F, 0.15F}, {0.45F, 0.58F, 0.2F}, part));
            }
            if (i > 0)
                strip((sides + 1) * static_cast<std::uint32_t>(i - 1), (sides + 1) * static_cast<std::uint32_t>(i),
                      sides + 1);
        }
    }

    /// A leaf that rises from the stem and droops: three vertices across, of which the middle ones lie lower.
    void add_leaf(int number, int leaves)
    {
        constexpr int pieces = 4;
        const double part = 0.16 + 0.7 * number / leaves + between(-0.03, 0.03);
        const double angle = 2.399963 * number + between(-0.3, 0.3),
                     length = between(0.75, 0.95) * (1.05 - 0.45 * part * part);
        const double width = between(0.5, 0.62) * length, rise = between(0.25, 0.7), droop = between(0.5, 1.0);
        const MeshPoint out{std::cos(angle), std::sin(angle), 0}, side{-out[1], out[0], 0}, foot = stem_at(part);
        const ScreenColor color = mixed({0.26F, 0.47F, 0.12F}, {0.46F, 0.64F, 0.2F}, between(0, 1));
        for (int i = 0; i <= pieces; ++i) {
            const double s = static_cast<double>(i) / pieces;
            const double half = width * std::sin(std::numbers::pi * std::pow(0.06 + 0.94 * s, 0.75));
            MeshPoint rib = plus(foot, out, length * s);
            rib[2] += length * (rise * s - droop * s * s);
            const double slope = rise - 2 * droop * s;
            for (int k = -1; k <= 1; ++k) {
                MeshPoint place = plus(rib, side, k * half);
                place[2] += k == 0 ? 0 : 0.22 * half;
                const MeshPoint normal{-slope * out[0] - 0.3 * k * side[0], -slope * out[1] - 0.3 * k * side[1], 1};
                vertex(place, normal, k == 0 ? mixed(color, {0.55F, 0.66F, 0.3F}, 0.5) : color);
            }
            const auto last = static_cast<std::uint32_t>(model_.places.size());
            if (i > 0) strip(last - 6, last - 3, 3);
        }
    }

    /// The seeds: rings around the middle, whose colours alternate; and the green back.
    void add_disc()
    {
        constexpr std::uint32_t sides = 14;
        constexpr std::array<double, 5> radii{0.4, 0.33, 0.24, 0.15, 0.06};
        const std::array<ScreenColor, 5> colors{{{0.5F, 0.33F, 0.06F},
                                                 {0.33F, 0.19F, 0.06F},
                                                 {0.24F, 0.13F, 0.05F},
                                                 {0.36F, 0.24F, 0.08F},
                                                 {0.27F, 0.2F, 0.07F}}};
        const auto ring = [&](double radius, double forward, double outwards, const ScreenColor& color) {
            for (std::uint32_t k = 0; k <= sides; ++k) {
                const double angle = turn * k / sides;
                const MeshPoint out = difference(head_.at(1, angle, 0), head_.middle);
                vertex(head_.at(radius, angle, forward), plus(head_.normal, out, outwards),
                       k % 2 == 0 ? color : mixed(color, {0.12F, 0.07F, 0.03F}, 0.45));
            }
            return static_cast<std::uint32_t>(model_.places.size()) - sides - 1;
        };
        std::uint32_t last = 0;
        for (std::size_t i = 0; i < radii.size(); ++i) {
            const std::uint32_t first = ring(radii[i], 0.09 - 0.5 * radii[i] * radii[i], radii[i], colors[i]);
            if (i > 0) strip(last, first, sides + 1);
            last = first;
        }
        strip(last, ring(0, 0.09, 0, colors.back()), sides + 1);
        const ScreenColor green{0.35F, 0.5F, 0.17F};
        const MeshPoint neck = head_.normal;
        const std::uint32_t border = ring(0.5, 0, 1, green), middle = ring(0.06, -0.22, 1, green);
        for (std::uint32_t i = border; i < middle + sides + 1; ++i)
            model_.normals[i] = unit(plus(difference(model_.places[i], head_.middle), neck, -0.5));
        strip(border, middle, sides + 1);
    }

    /// A petal of the front row, or of the back one: a kite whose tip bends.
    void add_petal(int number, int petals)
    {
        const bool is_behind = number >= petals;
        const double angle = turn * (number + (is_behind ? 0.5 : 0)) / petals + between(-0.06, 0.06);
        const double length = between(0.82, 0.95) + (is_behind ? 0.03 : 0), bend = between(-0.12, 0.1);
        const double forward = is_behind ? -0.02 : 0.03, wide = 1.9 / petals;
        const ScreenColor base{0.9F, 0.56F, 0.04F};
        const ScreenColor tip = mixed({0.98F, 0.76F, 0.08F}, {1.0F, 0.86F, 0.2F}, between(0, 1));
        const std::uint32_t first = vertex(head_.at(0.34, angle, forward), head_.normal, base);
        for (const double side : {-1.0, 1.0})
            vertex(head_.at(0.62, angle + side * wide, forward + 0.05), head_.normal, mixed(base, tip, 0.7));
        vertex(head_.at(length, angle, forward + bend), head_.normal, tip);
        model_.triangles.push_back({first, first + 1, first + 2});
        model_.triangles.push_back({first + 1, first + 3, first + 2});
    }

    std::uint32_t number_, drawn_ = 0;
    double height_ = 0;
    Head head_;
    PlantModel model_;
};

/// Scales the model so that it just fits the cylinder of radius 1, and says how high it is.
void fit(PlantModel& model)
{
    double radius = 0;
    for (const MeshPoint& p : model.places) radius = std::max(radius, std::hypot(p[0], p[1]));
    if (!(radius > 0)) throw InputError("the mesh has no extent along x and y");
    if (!std::isfinite(radius)) throw InputError("the mesh is too large along x and y");
    for (MeshPoint& p : model.places) {
        for (double& c : p) c /= radius;
        model.height = std::max(model.height, p[2]);
    }
}

}

std::vector<PlantModel> sunflower_models(std::uint32_t count)
{
    std::vector<PlantModel> models;
    for (std::uint32_t i = 0; i < count; ++i) {
        models.push_back(SunflowerBuilder(i).build());
        fit(models.back());
    }
    return models;
}

PlantModel plant_of_mesh(const TriangleMesh& mesh)
{
    MeshPoint low = mesh.vertices.at(0), high = low;
    for (const MeshPoint& p : mesh.vertices)
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], p[i]);
            high[i] = std::max(high[i], p[i]);
        }
    PlantModel model;
    model.normals.resize(mesh.vertices.size());
    model.colors.assign(mesh.vertices.size(), {0.36F, 0.52F, 0.2F});
    model.triangles = mesh.triangles;
    for (const MeshPoint& p : mesh.vertices)
        model.places.push_back({p[0] - (low[0] + high[0]) / 2, p[1] - (low[1] + high[1]) / 2, p[2] - low[2]});
    fit(model);
    for (const MeshTriangle& t : mesh.triangles) {
        const MeshPoint normal = cross(difference(model.places[t[1]], model.places[t[0]]),
                                       difference(model.places[t[2]], model.places[t[0]]));
        for (const std::uint32_t corner : t) model.normals[corner] = plus(model.normals[corner], normal);
    }
    for (MeshPoint& normal : model.normals) normal = unit(normal);
    return model;
}

}
