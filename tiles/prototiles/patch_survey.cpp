#include "tiles/prototiles/patch_survey.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace poissonlab {
namespace {

using Point = std::array<double, 2>;

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
double plane_cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
double plane_dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }

/// The corners of a patch as numbers, and which lie within an edge.
class PatchVertices
{
public:
    explicit PatchVertices(const PolygonTiling& tiling) : tiling_(tiling) {}

    std::size_t number(const RingPlace& place)
    {
        const auto [found, is_new] = numbers_.emplace(place, places_.size());
        if (is_new) {
            places_.push_back(place);
            points_.push_back(point_of(tiling_, place - places_[0])); // near each other, though far from the origin
        }
        return found->second;
    }

    std::size_t size() const { return places_.size(); }
    const RingPlace& place(std::size_t vertex) const { return places_[vertex]; }
    const Point& point(std::size_t vertex) const { return points_[vertex]; }

    /// Sorts vertices into cells of this side.
    void sort_into_cells(double side)
    {
        side_ = side;
        for (std::size_t i = 0; i < points_.size(); ++i) cells_[cell_of(points_[i])].push_back(i);
    }

    /// The vertices within an edge, from a to b.
    std::vector<std::size_t> within(std::size_t a, std::size_t b) const
    {
        const Point along = difference(points_[b], points_[a]);
        std::vector<std::pair<double, std::size_t>> found;
        const Cell low = cell_of({std::min(points_[a][0], points_[b][0]), std::min(points_[a][1], points_[b][1])});
        const Cell high = cell_of({std::max(points_[a][0], points_[b][0]), std::max(points_[a][1], points_[b][1])});
        for (std::int64_t x = low.first; x <= high.first; ++x)
            for (std::int64_t y = low.second; y <= high.second; ++y) {
                const auto cell = cells_.find({x, y});
                if (cell == cells_.end()) continue;
                for (const std::size_t v : cell->second) {
                    const double part = plane_dot(difference(points_[v], points_[a]), along) / plane_dot(along, along);
                    if (v != a && v != b && part > 0 && part < 1 && is_on_line(a, b, v)) found.emplace_back(part, v);
                }
            }
        std::ranges::sort(found);
        std::vector<std::size_t> vertices;
        for (const auto& [part, v] : found) vertices.push_back(v);
        return vertices;
    }

private:
    using Cell = std::pair<std::int64_t, std::int64_t>;

    Cell cell_of(const Point& p) const
    {
        return {static_cast<std::int64_t>(std::floor(p[0] / side_)),
                static_cast<std::int64_t>(std::floor(p[1] / side_))};
    }

    /// Exact, after a look at rounded places: the differences are those of near places.
    bool is_on_line(std::size_t a, std::size_t b, std::size_t v) const
    {
        const Point along = difference(points_[b], points_[a]), to = difference(points_[v], points_[a]);
        if (std::abs(plane_cross(along, to)) > 1e-3 * plane_dot(along, along)) return false;
        const RootRing& ring = tiling_.ring;
        return ring.is_real(ring.times(ring.conjugate(places_[b] - places_[a]), places_[v] - places_[a]));
    }

    const PolygonTiling& tiling_;
    std::unordered_map<RingPlace, std::size_t, RingPlaceHash> numbers_;
    std::vector<RingPlace> places_;
    std::vector<Point> points_;
    std::map<Cell, std::vector<std::size_t>> cells_;
    double side_ = 1;
};

/// A piece of an edge from one vertex to another, with its tile to the left.
struct EdgePiece
{
    std::size_t tile = 0;
    std::size_t edge = 0;     ///< of corners_of()
    bool is_whole = false;    ///< no vertex lies within the edge
    std::size_t before = 0;   ///< the vertex before it along the tile's outline
    bool starts_edge = false; ///< at a corner of the tile, not within its edge
};

using Direction = std::pair<std::size_t, std::size_t>;

struct DirectionHash
{
    std::size_t operator()(const Direction& d) const { return d.first * 0x9E3779B97F4A7C15U ^ d.second; }
};

class PatchSurveyor
{
public:
    PatchSurveyor(const PolygonTiling& tiling, std::span<const PlacedTile> tiles)
        : tiling_(tiling), tiles_(tiles), vertices_(tiling)
    {}

    PatchSurvey survey()
    {
        if (tiles_.empty()) return {};
        find_vertices();
        for (std::size_t i = 0; i < tiles_.size(); ++i) add_outline(i);
        survey_edges();
        survey_vertices();
        return std::move(survey_);
    }

private:
    void find_vertices()
    {
        double longest = 0;
        for (const PlacedTile& tile : tiles_) {
            corners_.emplace_back();
            for (const RingPlace& corner : corners_of(tiling_, tile))
                corners_.back().push_back(vertices_.number(corner));
            for (std::size_t i = 0; i < corners_.back().size(); ++i) {
                const Point side = difference(vertices_.point(corners_.back()[i]),
                                              vertices_.point(corners_.back()[(i + 1) % corners_.back().size()]));
                longest = std::max(longest, std::sqrt(plane_dot(side, side)));
            }
        }
        vertices_.sort_into_cells(longest);
    }

    void add_outline(std::size_t tile)
    {
        const std::vector<std::size_t>& corners = corners_[tile];
        std::vector<std::pair<std::size_t, EdgePiece>> outline; // the vertex where each piece starts
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::vector<std::size_t> within = vertices_.within(corners[i], corners[(i + 1) % corners.size()]);
            outline.emplace_back(corners[i], EdgePiece{tile, i, within.empty(), 0, true});
            for (const std::size_t v : within) outline.emplace_back(v, EdgePiece{tile, i, false, 0, false});
            if (!within.empty()) survey_.is_edge_to_edge = false;
        }
        for (std::size_t i = 0; i < outline.size(); ++i) {
            EdgePiece piece = outline[i].second;
            piece.before = outline[(i + outline.size() - 1) % outline.size()].first;
            const Direction direction{outline[i].first, outline[(i + 1) % outline.size()].first};
            if (!pieces_.emplace(direction, piece).second) ++survey_.crowded_edges;
            if (starts_.size() <= outline[i].first) starts_.resize(vertices_.size());
            starts_[outline[i].first].push_back(direction.second);
        }
    }

    void survey_edges()
    {
        for (const auto& [direction, piece] : pieces_) {
            const auto other = pieces_.find({direction.second, direction.first});
            if (other == pieces_.end()) {
                ++survey_.border_edges;
                survey_.border.push_back(vertices_.place(direction.first));
                continue;
            }
            if (direction.first > direction.second) continue;
            ++survey_.inner_edges;
            if (!piece.is_whole || !other->second.is_whole) continue;
            const char one = edge_letter(tiling_, tiles_[piece.tile], piece.edge);
            const char two = edge_letter(tiling_, tiles_[other->second.tile], other->second.edge);
            if (one == 0 || two == 0) continue;
            ++survey_.labelled_edges;
            survey_.unfit_edges += !letters_fit(one, two);
        }
    }

    /// Walks around each vertex from tile to tile.
    void survey_vertices()
    {
        std::map<std::string, std::size_t> figures;
        for (std::size_t v = 0; v < starts_.size(); ++v) {
            std::vector<std::string> around;
            double angle = 0;
            std::size_t next = starts_[v].front();
            do {
                const auto piece = pieces_.find({v, next});
                if (piece == pieces_.end()) break; // nothing lies there: the border
                const double here = angle_between(v, next, piece->second.before);
                angle += here;
                around.push_back(corner_name(piece->second, here));
                next = piece->second.before;
            } while (next != starts_[v].front() && around.size() <= starts_[v].size());
            if (next != starts_[v].front()) continue;
            ++survey_.inner_vertices;
            constexpr double rounding = 1e-9;
            const bool is_turn = std::abs(angle - 2 * std::numbers::pi) < rounding;
            survey_.odd_vertices += !is_turn || around.size() != starts_[v].size();
            ++figures[figure_name(std::move(around))];
        }
        for (auto& [name, count] : figures) survey_.figures.push_back({name, count});
        std::ranges::stable_sort(survey_.figures, std::greater{}, &VertexFigure::count);
    }

    /// From the direction of one vertex counterclockwise to that of another.
    double angle_between(std::size_t v, std::size_t from, std::size_t to) const
    {
        const Point a = difference(vertices_.point(from), vertices_.point(v));
        const Point b = difference(vertices_.point(to), vertices_.point(v));
        const double angle = std::atan2(plane_cross(a, b), plane_dot(a, b));
        return angle > 0 ? angle : angle + 2 * std::numbers::pi;
    }

    bool all_are_regular() const
    {
        return std::ranges::all_of(tiling_.prototiles, [](const Prototile& p) { return p.is_regular; });
    }

    std::string corner_name(const EdgePiece& piece, double angle) const
    {
        const PlacedTile& tile = tiles_[piece.tile];
        const Prototile& prototile = tiling_.prototiles[tile.prototile];
        if (all_are_regular()) return fmt::format("{}", prototile.corners.size());
        const auto degrees = std::lround(angle * 180 / std::numbers::pi);
        if (!piece.starts_edge) return fmt::format("{} side", prototile.name);
        const bool has_one_letter =
            prototile.edges.find_first_not_of(prototile.edges.substr(0, 1)) == std::string::npos;
        if (has_one_letter) return fmt::format("{} {}\u00b0", prototile.name, degrees);
        const std::size_t count = prototile.corners.size();
        return fmt::format("{} {}\u00b0 {}", prototile.name, degrees,
                           corner_letters(tile, (piece.edge + count - 1) % count, piece.edge));
    }

    /// The letters of the two edges at a corner: those of the corner's mirror image where they come first.
    std::string corner_letters(const PlacedTile& tile, std::size_t before, std::size_t after) const
    {
        const std::string letters{edge_letter(tiling_, tile, before), edge_letter(tiling_, tile, after)};
        PlacedTile mirrored = tile;
        mirrored.motion.is_mirrored = !tile.motion.is_mirrored;
        const std::size_t count = tiling_.prototiles[tile.prototile].corners.size();
        const auto twin = [&](std::size_t edge) {
            return edge_letter(tiling_, mirrored, (2 * count - 2 - edge) % count);
        };
        return std::max(letters, std::string{twin(after), twin(before)});
    }

    /// The corners around a vertex, from the one and in the direction that come first in the alphabet, so that turned
    /// and mirrored figures have one name.
    std::string figure_name(std::vector<std::string> around) const
    {
        std::vector<std::string> first = around;
        for (int way = 0; way < 2; ++way) {
            for (std::size_t i = 0; i < around.size(); ++i) {
                std::ranges::rotate(around, around.begin() + 1);
                if (is_before(around, first)) first = around;
            }
            std::ranges::reverse(around);
        }
        return fmt::format("{}", fmt::join(first, all_are_regular() ? "." : ", "));
    }

    /// Numbers of sides are compared as numbers.
    static bool is_before(const std::vector<std::string>& a, const std::vector<std::string>& b)
    {
        return std::ranges::lexicographical_compare(a, b, [](const std::string& x, const std::string& y) {
            const bool are_numbers = x.size() <= 2 && y.size() <= 2;
            return are_numbers && x.size() != y.size() ? x.size() < y.size() : x < y;
        });
    }

    const PolygonTiling& tiling_;
    std::span<const PlacedTile> tiles_;
    PatchVertices vertices_;
    std::vector<std::vector<std::size_t>> corners_; ///< of each tile
    std::unordered_map<Direction, EdgePiece, DirectionHash> pieces_;
    std::vector<std::vector<std::size_t>> starts_; ///< the vertices at the ends of the pieces that start at each
    PatchSurvey survey_;
};

}

PatchSurvey survey_patch(const PolygonTiling& tiling, std::span<const PlacedTile> tiles)
{
    return PatchSurveyor(tiling, tiles).survey();
}

}
