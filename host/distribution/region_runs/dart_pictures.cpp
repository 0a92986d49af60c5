#include "host/distribution/region_runs/dart_pictures.hpp"

#include "host/distribution/regions/varied_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

/// The longest side of the picture: its numbers have two decimals.
constexpr double longest_of_picture = 4096;
constexpr double border_of_picture = longest_of_picture / 50;

constexpr std::size_t shades = 16;

/// Cosines and sines of the turn around z, 30 degrees, and of looking down, 20 degrees.
constexpr double turn_cos = 0.8660254037844386, turn_sin = 0.5;
constexpr double down_cos = 0.9396926207859084, down_sin = 0.3420201433256687;

/// SeenPlace has the coordinates of a place in the picture: to the right, upwards, and how far behind.
using SeenPlace = std::array<double, 3>;

SeenPlace seen_place(const std::array<double, 3>& place)
{
    const double right = turn_cos * place[0] - turn_sin * place[1];
    const double behind = turn_sin * place[0] + turn_cos * place[1];
    return {right, down_cos * place[2] + down_sin * behind, down_cos * behind - down_sin * place[2]};
}

std::array<double, 3> box_corner(const SpaceBox& box, std::size_t corner)
{
    std::array<double, 3> place{};
    for (std::size_t k = 0; k < 3; ++k) place[k] = corner >> k & 1 ? box.high[k] : box.low[k];
    return place;
}

class SpaceView
{
public:
    explicit SpaceView(const SpaceBox& box)
    {
        low_.fill(std::numeric_limits<double>::infinity());
        high_.fill(-std::numeric_limits<double>::infinity());
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const SeenPlace place = seen_place(box_corner(box, corner));
            for (std::size_t k = 0; k < 3; ++k) {
                low_[k] = std::min(low_[k], place[k]);
                high_[k] = std::max(high_[k], place[k]);
            }
        }
        scale_ = (longest_of_picture - 2 * border_of_picture) / std::max(high_[0] - low_[0], high_[1] - low_[1]);
    }

    MarkPicture picture() const
    {
        return {(high_[0] - low_[0]) * scale_ + 2 * border_of_picture,
                (high_[1] - low_[1]) * scale_ + 2 * border_of_picture};
    }
    double scale() const { return scale_; }

    /// The depth is 0 in front and 1 behind.
    SeenPlace operator()(const std::array<double, 3>& place) const
    {
        const SeenPlace at = seen_place(place);
        return {(at[0] - low_[0]) * scale_ + border_of_picture, (at[1] - low_[1]) * scale_ + border_of_picture,
                (at[2] - low_[2]) / (high_[2] - low_[2])};
    }

private:
    SeenPlace low_{}, high_{};
    double scale_ = 1;
};

MarkGroup edges_of(const SpaceBox& box, const SpaceView& view)
{
    MarkGroup edges{"#8a8f98"};
    for (std::size_t corner = 0; corner < 8; ++corner)
        for (std::size_t k = 0; k < 3; ++k) {
            if (corner >> k & 1) continue;
            const SeenPlace a = view(box_corner(box, corner)), b = view(box_corner(box, corner | std::size_t{1} << k));
            edges.strokes.push_back({a[0], a[1], b[0], b[1], longest_of_picture / 1000});
        }
    return edges;
}

/// Shades go from a light grey behind to a dark blue in front.
std::string shade_of(std::size_t shade)
{
    const double part = static_cast<double>(shade) / (shades - 1);
    const auto mixed = [&](double behind, double front) { return static_cast<int>(behind + (front - behind) * part); };
    return fmt::format("#{:02x}{:02x}{:02x}", mixed(214, 20), mixed(222, 52), mixed(232, 92));
}

/// Seen from in front and above, z up, without perspective, in the box around the region: balls of a third of the
/// distance, those behind first and lighter.
MarkPicture space_picture(const RegionDarts& darts)
{
    const SpaceBox& box = darts.space->box();
    const SpaceView view(box);
    MarkPicture picture = view.picture();
    picture.groups.push_back(edges_of(box, view));
    for (std::size_t shade = 0; shade < shades; ++shade) picture.groups.push_back({shade_of(shade)});
    const double distance = darts.sure_distance > 0 ? darts.sure_distance : darts.request.min_distance;
    const double radius = std::min(distance * view.scale() / 6, longest_of_picture / 50);
    for (std::size_t i = 0; i < darts.points.size(); ++i) {
        const SeenPlace at = view({darts.points[i][0], darts.points[i][1], darts.points[i][2]});
        const double front = std::clamp(1 - at[2], 0.0, 1.0) * shades;
        const std::size_t shade = std::min(static_cast<std::size_t>(front), shades - 1);
        picture.groups[1 + shade].disks.push_back({at[0], at[1], radius});
    }
    return picture;
}

/// The longest side of the picture: its numbers have two decimals.
constexpr double picture_side = 4096;

/// Dots in the middle of more disks than these would cover them.
constexpr std::size_t most_dotted = 4000;

/// Colours of distances, the smallest one first: viridis of Matplotlib.
constexpr std::array distance_colors{"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                     "#28ae80", "#5ec962", "#addc30", "#fde725"};

/// Maps places of a region into its picture.
class PicturePlaces
{
public:
    explicit PicturePlaces(const RegionBox& box) : box_(box), scale_((picture_side - 2 * margin) / box.longest()) {}

    std::array<double, 2> operator()(double x, double y) const
    {
        return {margin + (x - box_.low[0]) * scale_, margin + (y - box_.low[1]) * scale_};
    }

    double scale() const { return scale_; }
    MarkPicture picture() const { return {box_.width() * scale_ + 2 * margin, box_.height() * scale_ + 2 * margin}; }

    void add_line(MarkGroup& group, const std::array<double, 2>& from, const std::array<double, 2>& to) const
    {
        const auto [x0, y0] = (*this)(from[0], from[1]);
        const auto [x1, y1] = (*this)(to[0], to[1]);
        group.strokes.push_back({x0, y0, x1, y1, picture_side / 500});
    }

    void add_ring(MarkGroup& group, const RegionRing& ring) const
    {
        for (std::size_t i = 0; i < ring.size(); ++i) add_line(group, ring[i], ring[(i + 1) % ring.size()]);
    }

private:
    static constexpr double margin = picture_side / 100;
    RegionBox box_;
    double scale_;
};

/// Points as disks of the distance at each.
std::vector<MarkGroup> distance_disks(const RegionDarts& darts, const PicturePlaces& places)
{
    const std::vector<double>& distances = darts.varied->distances;
    const auto [least, most] = std::ranges::minmax(distances);
    std::vector<MarkGroup> groups;
    for (const char* color : distance_colors) groups.push_back({color});
    MarkGroup dots{"#000000"};
    for (std::size_t i = 0; i < darts.points.size(); ++i) {
        const auto [x, y] = places(darts.points[i][0], darts.points[i][1]);
        const double part = most > least ? std::log(distances[i] / least) / std::log(most / least) : 0;
        const auto color = std::min(static_cast<std::size_t>(part * distance_colors.size()), groups.size() - 1);
        const double radius = distances[i] * places.scale() / 2;
        groups[color].disks.push_back({x, y, radius});
        if (darts.points.size() <= most_dotted) dots.disks.push_back({x, y, std::min(radius / 5, picture_side / 400)});
    }
    groups.push_back(std::move(dots));
    return groups;
}

/// A bar of the colours on the right of the picture, which becomes wider, with the distances at their ends: each colour
/// stands for the same ratio of distances.
void add_color_bar(const std::vector<double>& distances, MarkPicture& picture)
{
    constexpr double wide = picture_side / 32, gap = picture_side / 40, letters = picture_side / 36;
    constexpr std::size_t count = distance_colors.size(), labelled = 3;
    const auto [least, most] = std::ranges::minmax(distances);
    if (!(most > least)) return;
    const double left = picture.width + gap, high = picture.height - 2 * letters;
    const auto height_of = [&](std::size_t i) { return letters + high * static_cast<double>(i) / count; };
    for (std::size_t i = 0; i < count; ++i)
        picture.groups.push_back({distance_colors[i],
                                  {},
                                  {},
                                  {{{left, height_of(i)},
                                    {left + wide, height_of(i)},
                                    {left + wide, height_of(i + 1)},
                                    {left, height_of(i + 1)}}}});
    for (std::size_t i = 0; i <= count; i += labelled)
        picture.words.push_back(
            {{left + wide + 2.2 * letters, height_of(i) - letters / 3},
             letters,
             fmt::format("{:.3g}", least * std::pow(most / least, static_cast<double>(i) / count))});
    picture.width = left + wide + 4.4 * letters;
}

PointSet set_of(const std::vector<std::array<double, 2>>& places)
{
    PointSet set{2, {}};
    for (const auto& place : places) set.coordinates.insert(set.coordinates.end(), place.begin(), place.end());
    return set;
}

MarkGroup disks_of(const LandDots& dots, const PicturePlaces& places)
{
    MarkGroup group{dots.color};
    for (std::size_t i = 0; i < dots.points.size(); ++i) {
        const auto [x, y] = places(dots.points[i][0], dots.points[i][1]);
        group.disks.push_back({x, y, std::min(dots.radius * places.scale(), picture_side / 100)});
    }
    return group;
}

/// Disks of points lie between outlines and obstacles, whose points are disks of this radius in units of the region.
MarkPicture picture_of(const RegionLand& land, const RegionBox& box, const PicturePlaces& places, double radius,
                       std::vector<MarkGroup> points)
{
    MarkPicture picture = places.picture();
    MarkGroup lines{"#8a8f98"}, obstacles{"#c2410c"};
    for (const RegionPolygon& polygon : land.rest.polygons) {
        places.add_ring(lines, polygon.outline);
        for (const RegionRing& hole : polygon.holes) places.add_ring(lines, hole);
    }
    for (const RegionRing& line : lines_of(land.whole))
        for (std::size_t i = 1; i < line.size(); ++i) places.add_line(lines, line[i - 1], line[i]);
    for (const auto& [x0, y0, x1, y1] : lines_within(land.obstacles, box))
        places.add_line(obstacles, {x0, y0}, {x1, y1});
    const LandDots marks{obstacles.color, set_of(points_within(land.obstacles, box)), radius};
    obstacles.disks = disks_of(marks, places).disks;
    picture.groups = {std::move(lines)};
    for (MarkGroup& group : points) picture.groups.push_back(std::move(group));
    if (land.obstacles.count() > 0) picture.groups.push_back(std::move(obstacles));
    return picture;
}

}

MarkPicture land_picture(const RegionLand& land, const RegionBox& box, const std::vector<LandDots>& dots)
{
    const PicturePlaces places(box);
    std::vector<MarkGroup> points;
    for (const LandDots& some : dots) points.push_back(disks_of(some, places));
    return picture_of(land, box, places, dots.empty() ? 0 : dots.front().radius, std::move(points));
}

MarkPicture dart_picture(const RegionDarts& darts)
{
    if (darts.space) return space_picture(darts);
    const RegionLand& land = *darts.request.land;
    const RegionBox box = darts.length > 0 ? box_around(lines_of(land.whole)) : darts.request.region->box();
    const double distance = darts.sure_distance > 0 ? darts.sure_distance : darts.request.min_distance;
    if (!darts.varied) return land_picture(land, box, {{"#000000", darts.points, distance / 6}});
    const PicturePlaces places(box);
    MarkPicture picture = picture_of(land, box, places, distance / 6, distance_disks(darts, places));
    add_color_bar(darts.varied->distances, picture);
    return picture;
}

CurveChart nearest_chart(const VariedSet& set)
{
    constexpr double low = 0.9, high = 2.1, width = 0.02;
    std::array<double, 60> counts{};
    for (const double nearest : set.nearest)
        if (nearest >= low && nearest < high)
            ++counts[std::min(static_cast<std::size_t>((nearest - low) / width), counts.size() - 1)];
    ChartCurve curve{"points", "#2c728e", {}};
    double most = 1;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double density = counts[i] / width / static_cast<double>(set.nearest.size());
        most = std::max(most, density);
        curve.places.push_back({low + width * (static_cast<double>(i) + 0.5), density});
    }
    const double step = most > 8 ? 4 : most > 4 ? 2 : 1;
    return {{"nearest distance / the distance kept", low, high, 0.2},
            {"density of points", 0, std::ceil(most / step) * step, step},
            0,
            {curve}};
}

}
