#include "reports/drawings/construction_image.hpp"

#include "reports/drawings/plane_panel.hpp"
#include "reports/drawings/space_view.hpp"
#include "reports/drawings/square_regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace poissonlab {
namespace {

// Panels of the construction of Poisson sphere tiles: regions as bodies or as wires, and spheres.
//
// After Lagae, Tile-Based Methods in Computer Graphics, 2007, figures 4.30, 4.31 and 4.33 to 4.37.

constexpr double darkest_shade = 0.34; // the share of black on faces without light
constexpr double farthest_paleness = 0.6;

/// The drawn parts of the radius, by class of point, so that spheres do not hide the piece that is made.
constexpr std::array<double, stored_point_classes.size()> sphere_parts{0.3, 0.3, 0.5, 0.65};
const std::string body_outline = "#505050";
const std::string cube_outline = "#a0a0a0";

struct Edge
{
    ShapeVector a{}, b{};
    bool in_sight = false;
};

/// The edges of a body, each once; in sight if one of its faces is.
std::vector<Edge> edges_of(const RegionShape& body)
{
    using Corner = std::array<long long, 3>;
    const auto rounded = [](const ShapeVector& p) {
        return Corner{std::llround(p[0]), std::llround(p[1]), std::llround(p[2])};
    };
    std::map<std::pair<Corner, Corner>, Edge> edges;
    for (const ShapeFace& face : body.faces)
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const ShapeVector& a = face.corners[i];
            const ShapeVector& b = face.corners[(i + 1) % face.corners.size()];
            const Corner from = rounded(a), to = rounded(b);
            const auto key = std::pair(std::min(from, to), std::max(from, to));
            Edge& edge = edges.try_emplace(key, Edge{a, b, false}).first->second;
            edge.in_sight = edge.in_sight || is_in_sight(face.normal);
        }
    std::vector<Edge> result;
    for (const auto& [key, edge] : edges) result.push_back(edge);
    return result;
}

class SpacePanel
{
public:
    SpacePanel(std::vector<Shape>& shapes, const Scene& scene, const ScenePanel& panel, const DrawingPoint& origin,
               double scale)
        : shapes_(shapes), scene_(scene), panel_(panel), origin_(origin), corner_(projected_window(panel)[0]),
          scale_(scale)
    {
        for (const ScenePiece& piece : panel.pieces) {
            RegionShape body = shown_region(scene, panel, piece);
            if (body.faces.empty()) continue;
            bodies_.push_back(std::move(body));
            pieces_.push_back(&piece);
        }
    }

    /// The edges of the panel's tiles on the side that the viewer sees, or on the other one.
    void add_cubes(bool in_sight)
    {
        for (const ShapeVector& tile : shape_vectors(panel_.tiles)) {
            ShapeVector low{}, high{};
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = tile[k] * tile_units;
                high[k] = low[k] + tile_units;
            }
            add_edges(box_shape(3, low, high), in_sight, cube_outline, 0.7);
        }
    }

    void add_bodies()
    {
        for (const std::size_t i : back_to_front(bodies_)) {
            for (const ShapeFace& face : bodies_[i].faces) {
                if (!is_in_sight(face.normal)) continue;
                const double shade = darkest_shade * (1 - light_on(face.normal));
                for (const ColoredPart& part : colored_parts(*pieces_[i], 3)) {
                    RegionShape piece{{face}};
                    for (const ShapeHalfSpace& bound : part.bounds) piece = clipped(piece, bound);
                    if (!piece.faces.empty())
                        shapes_.push_back({outline(piece.faces.front()), mixed_color(part.fill, "#000000", shade), {}});
                }
                shapes_.push_back({outline(face), {}, body_outline, 0.7});
            }
        }
    }

    /// Adds the lines in sight of pieces that are there already; they stay behind the spheres.
    void add_held_wires()
    {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (!pieces_[i]->is_made)
                add_edges(bodies_[i], true, mixed_color(wire_color(*pieces_[i]), "#ffffff", 0.45), 0.7);
    }

    /// Adds the lines of the piece that is made: those before or those behind the spheres.
    void add_made_wires(bool in_sight)
    {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (pieces_[i]->is_made)
                add_edges(bodies_[i], in_sight, in_sight ? "#303030" : "#909090", in_sight ? 1.3 : 0.9);
    }

    /// Adds the spheres, those behind first, and paler.
    void add_spheres()
    {
        struct Sphere
        {
            double near = 0;
            ShapeVector place{};
            std::size_t kind = 0;
        };
        std::vector<Sphere> spheres;
        for (std::size_t kind = 0; kind < panel_.points.size(); ++kind)
            for (const ShapeVector& point : shape_vectors(panel_.points[kind]))
                spheres.push_back({nearness(point), point, kind});
        if (spheres.empty()) return;
        std::ranges::stable_sort(spheres, {}, &Sphere::near);
        const auto [farthest, nearest] = ends_of_sight();
        for (const Sphere& sphere : spheres) {
            const double radius = sphere_parts.at(sphere.kind) * scene_.radius * scale_;
            const double depth = std::clamp((nearest - sphere.near) / (nearest - farthest), 0.0, 1.0);
            const std::string color = mixed_color(point_color(sphere.kind).fill, "#ffffff", farthest_paleness * depth);
            const DrawingPoint middle = at(sphere.place);
            shapes_.push_back({Disk{middle, radius}, color, mixed_color(color, "#000000", 0.3), 0.5});
            const DrawingPoint shine{middle[0] - 0.3 * radius, middle[1] - 0.35 * radius};
            shapes_.push_back({Disk{shine, 0.32 * radius}, mixed_color(color, "#ffffff", 0.5), {}});
        }
    }

private:
    DrawingPoint at(const ShapeVector& place) const
    {
        const DrawingPoint p = projected(place);
        return {origin_[0] + (p[0] - corner_[0]) * scale_, origin_[1] + (p[1] - corner_[1]) * scale_};
    }

    std::vector<DrawingPoint> outline(const ShapeFace& face) const
    {
        std::vector<DrawingPoint> points;
        for (const ShapeVector& corner : face.corners) points.push_back(at(corner));
        return points;
    }

    void add_edges(const RegionShape& body, bool in_sight, const std::string& color, double width)
    {
        for (const Edge& edge : edges_of(body))
            if (edge.in_sight == in_sight) shapes_.push_back({Line{{at(edge.a), at(edge.b)}}, {}, color, width});
    }

    /// The nearness of the farthest and the nearest corner of the window.
    std::array<double, 2> ends_of_sight() const
    {
        const auto [farthest, nearest] =
            std::ranges::minmax(window_corners(panel_), {}, [](const ShapeVector& corner) { return nearness(corner); });
        return {nearness(farthest), nearness(nearest)};
    }

    std::vector<Shape>& shapes_;
    const Scene& scene_;
    const ScenePanel& panel_;
    DrawingPoint origin_;
    DrawingPoint corner_;
    double scale_;
    std::vector<RegionShape> bodies_;
    std::vector<const ScenePiece*> pieces_;
};

/// Width and height of a panel's projected window, units of tiles.
DrawingPoint space_panel_size(const ScenePanel& panel)
{
    const auto [low, high] = projected_window(panel);
    return {high[0] - low[0], high[1] - low[1]};
}

/// Appends what the panel shows, with its projected window's upper left corner at `origin`. `scale`: units of
/// the drawing a unit of tiles.
void add_space_panel(std::vector<Shape>& shapes, const Scene& scene, const ScenePanel& panel,
                     const DrawingPoint& origin, double scale)
{
    SpacePanel space(shapes, scene, panel, origin, scale);
    space.add_cubes(false);
    if (scene.is_solid) {
        space.add_bodies();
    } else {
        space.add_held_wires();
        space.add_made_wires(false);
        space.add_spheres();
        space.add_made_wires(true);
    }
    space.add_cubes(true);
}

constexpr double picture_width = 860;
constexpr double widest_panel = 400; // and highest
constexpr double margin = 14;
constexpr double gap = 26;         // more than two disks at the borders of panels
constexpr double label_space = 22; // from a row of panels to the middle of its letters, and on to the next row
constexpr double letter_size = 16;

DrawingPoint panel_size(const Scene& scene, const ScenePanel& panel)
{
    return scene.dimension == 2 ? plane_panel_size(panel) : space_panel_size(panel);
}

bool has_labels(const Scene& scene)
{
    return scene.panels.size() > 1 &&
           std::ranges::any_of(scene.panels, [](const ScenePanel& panel) { return !panel.caption.empty(); });
}

}

std::string panel_letter(std::size_t panel)
{
    return panel < 26 ? std::string{'(', static_cast<char>('a' + panel), ')'} : "";
}

std::vector<PanelPlace> panel_places(const Scene& scene, DrawingPoint& size)
{
    const std::size_t columns = std::min(scene.columns, scene.panels.size());
    double widest = 0, highest = 0;
    for (const ScenePanel& panel : scene.panels) {
        widest = std::max(widest, panel_size(scene, panel)[0]);
        highest = std::max(highest, panel_size(scene, panel)[1]);
    }
    const auto count = static_cast<double>(columns);
    const double room = (picture_width - 2 * margin - (count - 1) * gap) / count;
    const double scale =
        columns == 1 ? room / widest : std::min({room, widest_panel, widest_panel * widest / highest}) / widest;
    const double pitch = scale * widest;
    std::vector<PanelPlace> places;
    double y = margin;
    for (std::size_t first = 0; first < scene.panels.size(); first += columns) {
        const std::size_t end = std::min(first + columns, scene.panels.size());
        double high = 0;
        for (std::size_t i = first; i < end; ++i) high = std::max(high, scale * panel_size(scene, scene.panels[i])[1]);
        for (std::size_t i = first; i < end; ++i) {
            const DrawingPoint own = panel_size(scene, scene.panels[i]);
            const double x = margin + static_cast<double>(i - first) * (pitch + gap);
            places.push_back({{x + (pitch - scale * own[0]) / 2, y + (high - scale * own[1]) / 2},
                              scale,
                              {x + pitch / 2, y + high + label_space}});
        }
        y += high + (has_labels(scene) ? 2 * label_space : gap);
    }
    size = {2 * margin + count * (pitch + gap) - gap, y - (has_labels(scene) ? label_space : gap) + margin};
    return places;
}

Drawing draw_construction(const Scene& scene)
{
    DrawingPoint size{};
    const std::vector<PanelPlace> places = panel_places(scene, size);
    Drawing drawing{size[0], size[1], {}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ScenePanel& panel = scene.panels[i];
        const auto [origin, scale, label] = places[i];
        if (scene.dimension == 2)
            add_plane_panel(drawing.shapes, scene, panel, origin, scale);
        else
            add_space_panel(drawing.shapes, scene, panel, origin, scale);
        // Half of a small letter's height below the middle.
        if (has_labels(scene))
            drawing.shapes.push_back(
                {Text{{label[0], label[1] + 0.27 * letter_size}, letter_size, panel_letter(i), true}, "#202020", {}});
    }
    return drawing;
}

}
