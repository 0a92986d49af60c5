#include "host/distribution/runs/space_pictures.hpp"

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

/// Where a place is seen: to the right, upwards, and how far behind.
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

}

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

}
