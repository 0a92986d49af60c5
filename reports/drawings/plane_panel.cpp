#include "reports/drawings/plane_panel.hpp"

#include "reports/drawings/square_regions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr std::size_t arc_points = 112; // of the circle around a corner
const std::string region_outline = "#707070";
const std::string made_outline = "#303030";
const std::string disk_outline = "#8c8c8c";

class PlanePanel
{
public:
    PlanePanel(std::vector<Shape>& shapes, const Scene& scene, const ScenePanel& panel, const DrawingPoint& origin,
               double scale)
        : shapes_(shapes), scene_(scene), panel_(panel), origin_(origin), scale_(scale)
    {}

    void add_regions()
    {
        std::vector<Shape> fills, outlines;
        for (const ScenePiece& piece : panel_.pieces) {
            const RegionShape region = shown_region(scene_, panel_, piece);
            if (region.faces.empty()) continue;
            for (const ColoredPart& part : colored_parts(piece, 2)) {
                RegionShape half = region;
                for (const ShapeHalfSpace& bound : part.bounds) half = clipped(half, bound);
                if (!half.faces.empty()) fills.push_back({outline(half.faces.front()), part.fill, {}});
            }
            outlines.push_back({outline(region.faces.front()),
                                {},
                                piece.is_made ? made_outline : region_outline,
                                piece.is_made ? 1.4 : 0.7});
        }
        std::ranges::stable_sort(outlines, {}, &Shape::stroke_width);
        group_by_fill(fills);
        shapes_.insert(shapes_.end(), fills.begin(), fills.end());
        shapes_.insert(shapes_.end(), outlines.begin(), outlines.end());
    }

    /// Adds the circle of the radius around each corner, if regions are not modified and nothing lies over them.
    void add_corner_circles()
    {
        if (panel_.modified || panel_.has_points()) return;
        for (const ScenePiece& piece : panel_.pieces) {
            if (piece.axes != 0) continue;
            const ShapeVector middle{double(piece.base[0]) * tile_units, double(piece.base[1]) * tile_units, 0};
            for (std::size_t i = 0; i < arc_points; ++i) {
                const ShapeVector a = around(middle, scene_.width, i, arc_points);
                const ShapeVector b = around(middle, scene_.width, i + 1, arc_points);
                if (is_in_part(a) && is_in_part(b)) shapes_.push_back({Line{{at(a), at(b)}}, {}, region_outline, 0.7});
            }
        }
    }

    void add_tiles()
    {
        for (const ShapeVector& tile : shape_vectors(panel_.tiles)) {
            const auto corner = [&](double x, double y) {
                return at({(tile[0] + x) * tile_units, (tile[1] + y) * tile_units, 0});
            };
            shapes_.push_back({Polygon{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, {}, "#000000", 1});
        }
    }

    /// Draws the border of the torus where there is no tile to see.
    void add_frame()
    {
        if (!panel_.tiles.empty() || panel_.caption.empty()) return;
        const auto low = panel_.window.low_corner(), high = panel_.window.high_corner();
        shapes_.push_back(
            {Polygon{at(low), at({high[0], low[1], 0}), at(high), at({low[0], high[1], 0})}, {}, "#b0b0b0", 0.8});
    }

    /// Disks do not overlap where points keep their distance. Not drawn where there are no regions: only
    /// points count.
    void add_points()
    {
        const double radius = (panel_.radius > 0 ? panel_.radius : scene_.radius) * scale_;
        const bool has_disks = !panel_.pieces.empty() || !panel_.tiles.empty();
        if (has_disks)
            for (const auto& points : panel_.points)
                for (const ShapeVector& point : shape_vectors(points))
                    shapes_.push_back({Disk{at(point), radius}, {}, disk_outline, 0.5});
        const double dot = std::clamp(0.3 * radius, 1.0, 3.5);
        for (std::size_t kind = 0; kind < panel_.points.size(); ++kind)
            for (const ShapeVector& point : shape_vectors(panel_.points[kind]))
                shapes_.push_back({Disk{at(point), dot}, point_color(kind).fill, {}});
    }

private:
    DrawingPoint at(const ShapeVector& place) const
    {
        return {origin_[0] + (place[0] - panel_.window.low_corner()[0]) * scale_,
                origin_[1] + (panel_.window.high_corner()[1] - place[1]) * scale_};
    }

    std::vector<DrawingPoint> outline(const ShapeFace& face) const
    {
        std::vector<DrawingPoint> points;
        for (const ShapeVector& corner : face.corners) points.push_back(at(corner));
        return points;
    }

    static ShapeVector around(const ShapeVector& middle, double radius, std::size_t step, std::size_t steps)
    {
        const double angle = 2 * std::numbers::pi * static_cast<double>(step) / static_cast<double>(steps);
        return {middle[0] + radius * std::cos(angle), middle[1] + radius * std::sin(angle), 0};
    }

    bool is_in_part(const ShapeVector& place) const
    {
        const auto low = panel_.part.low_corner(), high = panel_.part.high_corner();
        return place[0] >= low[0] - 1 && place[0] <= high[0] + 1 && place[1] >= low[1] - 1 && place[1] <= high[1] + 1;
    }

    std::vector<Shape>& shapes_;
    const Scene& scene_;
    const ScenePanel& panel_;
    DrawingPoint origin_;
    double scale_;
};

}

DrawingPoint plane_panel_size(const ScenePanel& panel)
{
    const ShapeVector size = shape_vector(panel.window.size);
    return {size[0], size[1]};
}

void add_plane_panel(std::vector<Shape>& shapes, const Scene& scene, const ScenePanel& panel,
                     const DrawingPoint& origin, double scale)
{
    PlanePanel plane(shapes, scene, panel, origin, scale);
    plane.add_regions();
    plane.add_corner_circles();
    plane.add_frame();
    plane.add_tiles();
    plane.add_points();
}

}
