#include "tiles/isohedral/isohedral_template.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr double tiny = 1e-9; // equations are of lengths near 1; what is no rounding is far larger

/// Numbers x and y of the edges, one after the other: unknowns of the equations.
using EdgeNumbers = std::vector<double>;

std::vector<PlanePoint> laves_polygon(const std::vector<int>& degrees)
{
    const std::size_t k = degrees.size();
    const auto half_angle = [&](std::size_t i) { return std::numbers::pi / degrees[i % k]; };
    std::vector<PlanePoint> corners;
    double turn = 0;
    PlanePoint at{0, 0};
    for (std::size_t e = 0; e < k; ++e) {
        corners.push_back(at);
        const double length = 1 / std::tan(half_angle(e)) + 1 / std::tan(half_angle(e + 1));
        at = {at[0] + length * std::cos(turn), at[1] + length * std::sin(turn)};
        turn += std::numbers::pi - 2 * half_angle(e + 1);
    }
    return corners;
}

/// Moves the mean of the corners to (0, 0).
void centre(std::vector<PlanePoint>& corners)
{
    PlanePoint mean{};
    for (const PlanePoint& p : corners)
        for (std::size_t axis = 0; axis < 2; ++axis) mean[axis] += p[axis] / static_cast<double>(corners.size());
    for (PlanePoint& p : corners)
        for (std::size_t axis = 0; axis < 2; ++axis) p[axis] -= mean[axis];
}

PlanePoint difference(const PlanePoint& a, const PlanePoint& b) { return {a[0] - b[0], a[1] - b[1]}; }

PlanePoint corner_of(const std::vector<PlanePoint>& corners, std::size_t chamber)
{
    return corners[(chamber + 1) / 2 % corners.size()];
}

/// The direction from the corner of a chamber along its edge.
PlanePoint along(const std::vector<PlanePoint>& corners, std::size_t chamber)
{
    return difference(corner_of(corners, other_half(chamber)), corner_of(corners, chamber));
}

/// The linear part that takes direction `from` to `to` of the same length; mirrored or not.
PlaneMotion linear_part(const PlanePoint& from, const PlanePoint& to, bool is_mirror)
{
    const double square = from[0] * from[0] + from[1] * from[1];
    if (is_mirror) {
        const double c = (to[0] * from[0] - to[1] * from[1]) / square;
        const double s = (to[0] * from[1] + to[1] * from[0]) / square;
        return {c, s, s, -c};
    }
    const double c = (to[0] * from[0] + to[1] * from[1]) / square;
    const double s = (to[1] * from[0] - to[0] * from[1]) / square;
    return {c, -s, s, c};
}

/// Appends the two equations: linear part times edge `from` is edge `to`, each of a chamber, along it.
void add_equations(std::vector<EdgeNumbers>& equations, std::size_t edges, const PlaneMotion& linear, std::size_t from,
                   std::size_t to)
{
    const double from_sign = from % 2 == 0 ? 1 : -1, to_sign = to % 2 == 0 ? 1 : -1;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        EdgeNumbers equation(2 * edges);
        equation[from / 2 * 2] += from_sign * (axis == 0 ? linear.xx : linear.yx);
        equation[from / 2 * 2 + 1] += from_sign * (axis == 0 ? linear.xy : linear.yy);
        equation[to / 2 * 2 + axis] -= to_sign;
        equations.push_back(std::move(equation));
    }
}

/// Solutions of homogeneous equations, by elimination with the largest pivots.
std::vector<EdgeNumbers> solutions_of(std::vector<EdgeNumbers> equations, std::size_t unknowns)
{
    std::vector<std::size_t> pivots;
    for (std::size_t column = 0; column < unknowns; ++column) {
        const std::size_t rank = pivots.size();
        std::size_t best = rank;
        for (std::size_t i = rank; i < equations.size(); ++i)
            if (std::abs(equations[i][column]) > std::abs(equations[best][column])) best = i;
        if (best >= equations.size() || std::abs(equations[best][column]) < tiny) continue;
        std::swap(equations[rank], equations[best]);
        const double pivot = equations[rank][column];
        for (double& value : equations[rank]) value /= pivot;
        for (std::size_t i = 0; i < equations.size(); ++i) {
            const double factor = equations[i][column];
            if (i == rank || factor == 0) continue;
            for (std::size_t j = 0; j < unknowns; ++j) equations[i][j] -= factor * equations[rank][j];
        }
        pivots.push_back(column);
    }
    std::vector<EdgeNumbers> solutions;
    for (std::size_t column = 0; column < unknowns; ++column) {
        if (std::ranges::find(pivots, column) != pivots.end()) continue;
        EdgeNumbers solution(unknowns);
        solution[column] = 1;
        for (std::size_t i = 0; i < pivots.size(); ++i) solution[pivots[i]] = -equations[i][column];
        solutions.push_back(std::move(solution));
    }
    return solutions;
}

/// Corners around (0, 0) from the edges between them, as one list of numbers.
EdgeNumbers corners_of(const EdgeNumbers& edges)
{
    std::vector<PlanePoint> corners{{0, 0}};
    for (std::size_t e = 0; 2 * e + 2 < edges.size(); ++e)
        corners.push_back({corners[e][0] + edges[2 * e], corners[e][1] + edges[2 * e + 1]});
    centre(corners);
    EdgeNumbers numbers;
    for (const PlanePoint& p : corners) numbers.insert(numbers.end(), p.begin(), p.end());
    return numbers;
}

/// Takes away what `vector` has in the directions of the others. Returns the length that is left.
double make_orthogonal(EdgeNumbers& vector, const std::vector<EdgeNumbers>& others)
{
    for (int again = 0; again < 2; ++again) // twice, for rounding
        for (const EdgeNumbers& other : others) {
            const double share = std::inner_product(vector.begin(), vector.end(), other.begin(), 0.0);
            for (std::size_t i = 0; i < vector.size(); ++i) vector[i] -= share * other[i];
        }
    return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

/// Appends a vector to orthogonal ones of length 1, where it is no combination of them.
bool append_direction(std::vector<EdgeNumbers>& directions, EdgeNumbers vector)
{
    const double length = make_orthogonal(vector, directions);
    if (length < 1e-6) return false;
    for (double& value : vector) value /= length;
    directions.push_back(std::move(vector));
    return true;
}

/// True where a vector is a combination of solutions.
bool solves(const std::vector<EdgeNumbers>& equations, const EdgeNumbers& edges)
{
    return std::ranges::all_of(equations, [&](const EdgeNumbers& equation) {
        return std::abs(std::inner_product(edges.begin(), edges.end(), equation.begin(), 0.0)) < 1e-6;
    });
}

void find_deformations(IsohedralTemplate& type)
{
    const std::size_t k = type.base.size();
    std::vector<EdgeNumbers> equations;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        EdgeNumbers closed(2 * k);
        for (std::size_t e = 0; e < k; ++e) closed[2 * e + axis] = 1;
        equations.push_back(std::move(closed));
    }
    for (std::size_t e = 0; e < k; ++e)
        add_equations(equations, k, type.hops[e], type.symbol.chamber_across(2 * e), 2 * e);
    for (std::size_t i = 0; i < type.symmetries.size(); ++i)
        for (std::size_t e = 0; e < k; ++e)
            add_equations(equations, k, type.symmetries[i], 2 * e, type.symbol.symmetries[i][2 * e]);
    EdgeNumbers size, turned;
    for (std::size_t e = 0; e < k; ++e) {
        const PlanePoint edge = along(type.base, 2 * e);
        size.insert(size.end(), {edge[0], edge[1]});
        turned.insert(turned.end(), {-edge[1], edge[0]});
    }
    std::vector<EdgeNumbers> directions;
    append_direction(directions, corners_of(size));
    if (solves(equations, turned)) append_direction(directions, corners_of(turned));
    const std::size_t without = directions.size();
    for (const EdgeNumbers& solution : solutions_of(equations, 2 * k))
        append_direction(directions, corners_of(solution));
    for (std::size_t i = without; i < directions.size(); ++i) {
        std::vector<PlanePoint> moved;
        for (std::size_t corner = 0; corner < k; ++corner)
            moved.push_back({directions[i][2 * corner], directions[i][2 * corner + 1]});
        type.deformations.push_back(std::move(moved));
    }
}

/// A tile, by the hops that lead to it.
struct ReachedTile
{
    HopWord word;
    PlaneMotion motion;
    std::size_t aspect = 0;
};

double squared_distance(const PlaneMotion& a, const PlaneMotion& b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/// The tiles around the first one, nearest in hops first, each with its aspect: tiles of one aspect differ by a
/// translation and a symmetry of the tile.
std::vector<ReachedTile> reached_tiles(IsohedralTemplate& type, const std::vector<PlaneMotion>& hops)
{
    constexpr std::size_t enough = 400; // twelve aspects, and several units around each
    std::vector<ReachedTile> tiles{{{}, {}, 0}};
    std::vector<PlaneMotion> aspects{{}};
    type.aspects = {{}};
    for (std::size_t i = 0; i < tiles.size() && tiles.size() < enough; ++i)
        for (std::size_t e = 0; e < hops.size(); ++e) {
            ReachedTile next{tiles[i].word, tiles[i].motion * hops[e]};
            next.word.push_back(e);
            if (std::ranges::any_of(
                    tiles, [&](const ReachedTile& tile) { return squared_distance(tile.motion, next.motion) < 1e-6; }))
                continue;
            const auto has_aspect = [&](const PlaneMotion& aspect) {
                return std::ranges::any_of(type.symmetries, [&](const PlaneMotion& symmetry) {
                    return same_linear_part(aspect * symmetry, next.motion);
                });
            };
            next.aspect = static_cast<std::size_t>(std::ranges::find_if(aspects, has_aspect) - aspects.begin());
            if (next.aspect == aspects.size()) {
                aspects.push_back(next.motion);
                type.aspects.push_back(next.word);
            }
            tiles.push_back(std::move(next));
        }
    return tiles;
}

/// The two shortest translations between which a unit has exactly as many tiles as there are aspects.
void find_translations(IsohedralTemplate& type, const std::vector<ReachedTile>& tiles,
                       const std::vector<PlaneMotion>& hops)
{
    struct Translation
    {
        PlanePoint vector;
        std::array<HopWord, 2> words;
    };
    std::vector<Translation> all;
    for (const ReachedTile& tile : tiles) {
        const PlaneMotion first = motion_of(type.aspects[tile.aspect], hops);
        const PlanePoint vector{tile.motion.x - first.x, tile.motion.y - first.y};
        if (std::hypot(vector[0], vector[1]) > 1e-3) all.push_back({vector, {type.aspects[tile.aspect], tile.word}});
    }
    // Equal lengths differ by rounding: words decide, not the last bit.
    const auto length = [](const Translation& t) { return std::llround(std::hypot(t.vector[0], t.vector[1]) * 1e6); };
    std::ranges::stable_sort(all, {}, length);
    const double area = static_cast<double>(type.aspects.size()) * area_of(type.base);
    for (std::size_t second = 1; second < all.size(); ++second)
        for (std::size_t first = 0; first < second; ++first) {
            const PlanePoint &u = all[first].vector, &v = all[second].vector;
            const double determinant = u[0] * v[1] - u[1] * v[0];
            if (std::abs(std::abs(determinant) - area) > 1e-6 * area) continue;
            type.translations = {all[first].words, all[second].words};
            if (determinant < 0) std::swap(type.translations[0], type.translations[1]);
            return;
        }
    throw std::logic_error("an isohedral tiling has no translations");
}

/// Numbers the curves in the order of the first edges that have them.
void find_curves(IsohedralTemplate& type)
{
    const TileSymbol& s = type.symbol;
    std::map<std::size_t, EdgeCurve> of_class;
    for (std::size_t edge = 0; edge < s.edges(); ++edge) {
        const std::size_t start = s.class_of[2 * edge];
        if (!of_class.contains(start)) {
            const std::size_t end = s.class_of[2 * edge + 1], curve = type.curve_shapes.size();
            type.curve_shapes.push_back(s.shape(edge));
            of_class.try_emplace(start, EdgeCurve{curve, false, false});
            of_class.try_emplace(end, EdgeCurve{curve, true, false});
            of_class.try_emplace(s.across[start], EdgeCurve{curve, false, true});
            of_class.try_emplace(s.across[end], EdgeCurve{curve, true, true});
        }
        type.edge_curves.push_back(of_class.at(start));
    }
}

}

IsohedralTemplate isohedral_template(const TileSymbol& symbol)
{
    IsohedralTemplate type;
    type.symbol = symbol;
    type.base = laves_polygon(symbol.degrees);
    centre(type.base);
    for (std::size_t e = 0; e < symbol.edges(); ++e) {
        const std::size_t from = symbol.chamber_across(2 * e);
        type.hops.push_back(linear_part(along(type.base, from), along(type.base, 2 * e), from % 2 == 0));
    }
    for (const auto& symmetry : symbol.symmetries) {
        const bool is_mirror = symmetry[0] % 2 == 1;
        type.symmetries.push_back(linear_part(along(type.base, 0), along(type.base, symmetry[0]), is_mirror));
    }
    find_deformations(type);
    const std::vector<PlaneMotion> hops = hops_of(type, type.base);
    find_translations(type, reached_tiles(type, hops), hops);
    find_curves(type);
    return type;
}

bool needs_markings(const IsohedralTemplate& type)
{
    const auto free_curves = [](const IsohedralTemplate& t) {
        std::map<EdgeShape, int> counts;
        for (const EdgeShape shape : t.curve_shapes)
            if (shape != EdgeShape::straight) ++counts[shape];
        return counts;
    };
    return std::ranges::any_of(more_symmetric(type.symbol), [&](const TileSymbol& symbol) {
        const IsohedralTemplate other = isohedral_template(symbol);
        return other.parameters() == type.parameters() && free_curves(other) == free_curves(type);
    });
}

std::vector<PlaneMotion> hops_of(const IsohedralTemplate& type, const std::vector<PlanePoint>& corners)
{
    std::vector<PlaneMotion> hops;
    for (std::size_t e = 0; e < corners.size(); ++e) {
        const std::size_t from = type.symbol.chamber_across(2 * e);
        PlaneMotion hop = type.hops[e];
        const PlanePoint shift = difference(corner_of(corners, 2 * e), hop(corner_of(corners, from)));
        hop.x = shift[0];
        hop.y = shift[1];
        hops.push_back(hop);
    }
    return hops;
}

PlaneMotion motion_of(const HopWord& word, const std::vector<PlaneMotion>& hops)
{
    PlaneMotion motion;
    for (const std::size_t edge : word) motion = motion * hops[edge];
    return motion;
}

double area_of(const std::vector<PlanePoint>& polygon)
{
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const PlanePoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

}
