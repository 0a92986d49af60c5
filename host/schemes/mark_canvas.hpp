// Draws tiles, dots and lines into a picture of marks. Later marks lie over earlier ones.
#pragma once

#include "results/pictures/mark_picture.hpp"
#include "tiles/tilings/tile_shapes.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

using MarkPoint = std::array<double, 2>; ///< y upwards

/// The parallelogram that a unit square becomes in a picture.
struct MarkSquare
{
    MarkPoint corner{}; ///< of the lower left
    MarkPoint right{1, 0};
    MarkPoint up{0, 1};

    MarkPoint at(double x, double y) const
    {
        return {corner[0] + x * right[0] + y * up[0], corner[1] + x * right[1] + y * up[1]};
    }
    std::vector<MarkPoint> outline() const { return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; }
};

class MarkCanvas
{
public:
    /// `pixels_a_unit`: where it is drawn in pixels.
    MarkCanvas(double width, double height, double pixels_a_unit);

    void polygon(const std::string& color, std::vector<MarkPoint> corners);
    void disk(const std::string& color, const MarkPoint& middle, double radius);
    void line(const std::string& color, const MarkPoint& from, const MarkPoint& to, double width);
    void dashed_line(const std::string& color, const MarkPoint& from, const MarkPoint& to, double width, double dash);
    void outline(const std::string& color, const std::vector<MarkPoint>& corners, double width);
    void ring(const std::string& color, const MarkPoint& middle, double radius, double width);
    void words(const MarkPoint& middle, double size, std::string words);

    /// A disk with a thin black border.
    void dot(const std::string& color, const MarkPoint& middle, double radius);

    /// A Wang tile, corner tile or domino with its border.
    void tile(const auto& tile, const MarkSquare& square, double border = 0.03)
    {
        for (const TileShape& shape : shapes_of(tile)) {
            std::vector<MarkPoint> corners;
            for (const auto& [x, y] : shape.corners) corners.push_back(square.at(x, y));
            polygon(tile_color(shape.color), std::move(corners));
        }
        outline("#000000", square.outline(), border);
    }

    const MarkPicture& picture() const { return picture_; }

private:
    /// The last group if it has this colour and marks that may be joined by more, else a new one.
    MarkGroup& group(const std::string& color);

    MarkPicture picture_;
};

}
