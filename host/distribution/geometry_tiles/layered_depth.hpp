// Layered depth images of tiles with plants: for each pixel the samples that a ray through it meets, with their depths.
//
// Cohen and others 2003, section 4.1: each tile is sampled for 8 directions, with the points "seen from that
// direction", at 7 levels of detail. How the geometry is sampled is left to a technical report that did not appear;
// here as Shade, Gortler, He, Szeliski, Layered depth images, 1998, section 4.1, do it: pictures of the tile from
// several directions in the wedge are warped to one, and samples are dropped where their pixel has one at nearly their
// depth. Colours are those of plants in sunlight, before anything is seen.
#pragma once

#include "host/distribution/geometry_tiles/plant_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace poissonlab {

/// A parallel projection of a tile: its middle on the ground is the origin, and units are tiles.
struct DepthView
{
    MeshPoint right, up, back;                          ///< of length 1; `back` points to the viewer
    double left = 0, bottom = 0, width = 0, height = 0; ///< what is seen of the tile up to a height

    MeshPoint seen(const MeshPoint& place) const; ///< to the right and up from the lower left corner, and depth
    MeshPoint place(const MeshPoint& seen) const; ///< the inverse
};

/// A view from `azimuth` (from x towards y) and `elevation`, radians, of tiles with plants up to a height.
DepthView depth_view(double azimuth, double elevation, double height);

/// A surface element that is seen in a pixel.
struct DepthSample
{
    float depth = 0; ///< tiles behind the view's origin
    std::array<std::uint8_t, 3> color{};
    std::uint8_t right = 128, up = 128;  ///< in its pixel, in parts of 256
    std::uint8_t area = 0;               ///< of surface that it stands for, in 64ths of a pixel; 0: unknown
    std::array<std::int8_t, 2> normal{}; ///< x and y of the surface's, in 127ths; z is not below 0
    std::uint16_t plant = 0;             ///< its number in the tile
    std::uint16_t covered = 1;           ///< pixels of level 0 that it covers of those in its pixel

    bool operator==(const DepthSample&) const = default;

    /// The side of a square as large as the surface that it stands for looks from a direction of length 1, over that of
    /// a pixel; 1 where that is not known.
    double side_from(const MeshPoint& direction) const;
};

struct LayeredDepthImage
{
    DepthView view;
    int level = 0, columns = 0, rows = 0; ///< rows from below
    double pixel = 1;                     ///< side, in tiles
    std::vector<std::uint32_t> first;     ///< sample of each pixel, row by row, and the number of all samples
    std::vector<DepthSample> samples;     ///< of each pixel from the farthest to the nearest

    std::span<const DepthSample> at(int column, int row) const
    {
        const std::size_t pixel_number =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
        return std::span(samples).subspan(first[pixel_number], first[pixel_number + 1] - first[pixel_number]);
    }

    /// The part of its pixel that a sample covers.
    double alpha(const DepthSample& sample) const { return sample.covered / static_cast<double>(1 << 2 * level); }

    /// A sample's place, in tiles from the tile's middle.
    MeshPoint place(int column, int row, const DepthSample& sample) const
    {
        return view.place({(column + sample.right / 256.0) * pixel, (row + sample.up / 256.0) * pixel, sample.depth});
    }
};

/// Calls draw(column, row, sample) for all samples, so that none hides a later one from an eye, whose place is as
/// DepthView::seen() has it. McMillan, An image-based approach to three-dimensional computer graphics, 1997, section
/// 3.3, for a parallel projection: along a ray from the eye, pixels lead away from the one in which the eye is seen.
/// Within a pixel, rays lead to greater depths from those of the eye, or to smaller ones.
template <class Draw>
void draw_from_farthest(const LayeredDepthImage& image, const MeshPoint& eye, Draw draw)
{
    const auto order = [&](double middle, int count) {
        std::vector<int> numbers;
        const int turn = static_cast<int>(std::clamp(std::floor(middle / image.pixel), -1.0, count - 1.0));
        for (int i = 0; i < turn; ++i) numbers.push_back(i);
        for (int i = count - 1; i > turn; --i) numbers.push_back(i);
        if (turn >= 0) numbers.push_back(turn);
        return numbers;
    };
    const std::vector<int> columns = order(eye[0], image.columns);
    for (const int row : order(eye[1], image.rows))
        for (const int column : columns) {
            const std::span<const DepthSample> samples = image.at(column, row);
            std::size_t behind = 0;
            while (behind < samples.size() && static_cast<double>(samples[behind].depth) >= eye[2])
                draw(column, row, samples[behind++]);
            for (std::size_t i = samples.size(); i > behind; --i) draw(column, row, samples[i - 1]);
        }
}

/// A plant of a tile, ready to be sampled.
struct LitPlant
{
    const PlantModel* model = nullptr;
    std::vector<LitVertex> vertices;
};

std::vector<LitPlant> lit_plants(const std::vector<Plant>& plants, const std::vector<PlantModel>& models,
                                 double radius);

/// The nearest surfaces above the tile's square in the middles of pixels, `resolution` to a tile: level 0 of a layered
/// depth image with one layer.
LayeredDepthImage depth_picture(const std::vector<LitPlant>& plants, const DepthView& view, std::uint32_t resolution);

/// Level 0: the picture of the view, and what others see, warped to it.
LayeredDepthImage layered_depth_image(const std::vector<LitPlant>& plants, const DepthView& view,
                                      const std::vector<DepthView>& others, std::uint32_t resolution);

/// A level above 0 of level 0: of each plant, the samples in 2^level x 2^level pixels whose depths are near become one
/// with their mean place and colour.
LayeredDepthImage coarser(const LayeredDepthImage& finest, int level);

}
