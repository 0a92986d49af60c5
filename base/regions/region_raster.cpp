// Marching squares: Lorensen and Cline 1987, in the plane; ambiguous squares keep their positive corners apart.
#include "base/regions/region_raster.hpp"

#include "base/densities/density.hpp"
#include "base/densities/plane_formula.hpp"
#include "base/errors/errors.hpp"
#include "base/images/linear_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace poissonlab {
namespace {

constexpr std::uint32_t no_place = std::numeric_limits<std::uint32_t>::max();

/// The light of a pixel that is half as bright as white to the eye: 0.5 in sRGB.
constexpr double half_bright = 0.21404;

/// Pixels of less alpha are outside, however bright they are.
constexpr double half_covered = 0.5;

/// Crossings keep away from nodes of a lattice, so that no two of them coincide.
constexpr double least_part = 1e-3;

double turn_of(const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& c)
{
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
}

/// Rings of pieces, each of which comes to no place twice.
class RingJoiner
{
public:
    RingJoiner(const std::vector<BoundaryPiece>& pieces, const std::vector<std::array<double, 2>>& places)
        : places_(places), next_(places.size(), {no_place, no_place}), position_(places.size(), no_place)
    {
        for (const BoundaryPiece& piece : pieces) {
            auto& [first, second] = next_[piece.from];
            (first == no_place ? first : second) = piece.to;
        }
    }

    std::vector<RegionRing> run()
    {
        for (std::uint32_t place = 0; place < next_.size(); ++place)
            while (next_[place][0] != no_place) follow(place);
        return std::move(rings_);
    }

private:
    /// Goes on from a place until it is back; what closes on the way is a ring.
    void follow(std::uint32_t begin)
    {
        std::uint32_t place = begin;
        for (;;) {
            if (position_[place] != no_place) {
                close(place);
                if (path_.empty() && place == begin) return;
            }
            position_[place] = static_cast<std::uint32_t>(path_.size());
            path_.push_back(place);
            place = step_from(place);
        }
    }

    /// Takes the way farther to the left of two, around what lies there.
    std::uint32_t step_from(std::uint32_t place)
    {
        auto& [first, second] = next_[place];
        if (second != no_place && path_.size() > 1) {
            const auto& before = places_[path_[path_.size() - 2]];
            if (turn_of(before, places_[place], places_[second]) > turn_of(before, places_[place], places_[first]))
                std::swap(first, second);
        }
        const std::uint32_t to = first;
        first = second;
        second = no_place;
        return to;
    }

    /// Takes the ring since a place off the path. Corners on straight lines are left out.
    void close(std::uint32_t place)
    {
        const auto begin = path_.begin() + position_[place];
        RegionRing ring, corners;
        for (auto at = begin; at != path_.end(); ++at) {
            if (ring.empty() || ring.back() != places_[*at]) ring.push_back(places_[*at]);
            position_[*at] = no_place;
        }
        path_.erase(begin, path_.end());
        while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
        for (std::size_t i = 0; i < ring.size(); ++i)
            if (turn_of(ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]) != 0)
                corners.push_back(ring[i]);
        if (corners.size() >= 3) rings_.push_back(std::move(corners));
    }

    const std::vector<std::array<double, 2>>& places_;
    std::vector<std::array<std::uint32_t, 2>> next_;
    std::vector<std::uint32_t> position_; ///< on the path
    std::vector<std::uint32_t> path_;
    std::vector<RegionRing> rings_;
};

struct OutlineOfRaster
{
    std::size_t polygon;
    RegionBox box;
    double area;
};

/// The values of a formula at the nodes of a lattice, row by row from below, with a border of -1 around them.
struct FormulaLattice
{
    int columns = 0, rows = 0; ///< of nodes
    std::vector<double> values;

    double at(int column, int row) const
    {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
    std::uint32_t node(int column, int row) const { return static_cast<std::uint32_t>(row * columns + column); }
};

FormulaLattice lattice_of(const std::string& formula, const std::array<double, 2>& low,
                          const std::array<double, 2>& high, double step)
{
    FormulaLattice lattice;
    const auto nodes = [&](std::size_t k) { return static_cast<int>(std::lround((high[k] - low[k]) / step)) + 1; };
    const int columns = nodes(0), rows = nodes(1);
    lattice.columns = columns + 2;
    lattice.rows = rows + 2;
    lattice.values.assign(static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows), -1);
    PlaneFormula plane(formula);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double value = plane.at(low[0] + (high[0] - low[0]) * column / (columns - 1),
                                          low[1] + (high[1] - low[1]) * row / (rows - 1));
            lattice.values[lattice.node(column + 1, row + 1)] = std::isnan(value) ? -1 : value;
        }
    return lattice;
}

/// The pieces of a lattice's squares, and the crossings between them: number 2 n lies to the right of node n, 2 n + 1
/// above it.
std::vector<BoundaryPiece> pieces_of(const FormulaLattice& lattice)
{
    std::vector<BoundaryPiece> pieces;
    for (int row = 0; row + 1 < lattice.rows; ++row)
        for (int column = 0; column + 1 < lattice.columns; ++column) {
            // Corners and sides counterclockwise from the lower left corner and the lower side.
            const std::array is_positive{lattice.at(column, row) > 0, lattice.at(column + 1, row) > 0,
                                         lattice.at(column + 1, row + 1) > 0, lattice.at(column, row + 1) > 0};
            const std::array sides{2 * lattice.node(column, row), 2 * lattice.node(column + 1, row) + 1,
                                   2 * lattice.node(column, row + 1), 2 * lattice.node(column, row) + 1};
            // The boundary comes in where the corner after a side is positive and that before it is not; the positive
            // corners that follow lie to its left until the next side that has none behind it.
            for (std::size_t side = 0; side < 4; ++side) {
                if (is_positive[side] || !is_positive[(side + 1) % 4]) continue;
                std::size_t end = (side + 1) % 4;
                while (is_positive[(end + 1) % 4]) end = (end + 1) % 4;
                pieces.push_back({sides[end], sides[side]});
            }
        }
    return pieces;
}

/// The place of the zero of a value that is linear between two nodes, as a part of the way between them.
double crossing(double from, double to) { return std::clamp(from / (from - to), least_part, 1 - least_part); }

}

bool encloses(const RegionRing& ring, const std::array<double, 2>& place)
{
    bool is_inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto &a = ring[i], &b = ring[(i + 1) % ring.size()];
        if ((a[1] <= place[1]) == (b[1] <= place[1])) continue;
        is_inside ^= (turn_of(a, b, place) > 0) == (b[1] > a[1]);
    }
    return is_inside;
}

PlaneRegion region_of_rings(std::vector<RegionRing> rings)
{
    PlaneRegion region;
    std::vector<OutlineOfRaster> outlines;
    for (RegionRing& ring : rings) {
        const double area = signed_area_of(ring);
        if (area <= 0) continue;
        outlines.push_back({region.polygons.size(), box_of({{{ring}}}), area});
        region.polygons.push_back({std::move(ring)});
        ring.clear();
    }
    std::ranges::sort(outlines, {}, &OutlineOfRaster::area);
    for (RegionRing& ring : rings) {
        if (ring.empty()) continue;
        // No outline goes through the middle of a hole's edge.
        const std::array<double, 2> middle{(ring[0][0] + ring[1][0]) / 2, (ring[0][1] + ring[1][1]) / 2};
        const auto found = std::ranges::find_if(outlines, [&](const OutlineOfRaster& outline) {
            return outline.box.low[0] <= middle[0] && middle[0] <= outline.box.high[0] &&
                   outline.box.low[1] <= middle[1] && middle[1] <= outline.box.high[1] &&
                   encloses(region.polygons[outline.polygon].outline, middle);
        });
        if (found != outlines.end()) region.polygons[found->polygon].holes.push_back(std::move(ring));
    }
    return region;
}

PlaneRegion region_of_pieces(const std::vector<BoundaryPiece>& pieces, const std::vector<std::array<double, 2>>& places)
{
    return region_of_rings(RingJoiner(pieces, places).run());
}

PlaneRegion region_of_picture(const std::string& file)
{
    const LinearPicture picture = read_linear_picture(file);
    const auto is_inside = [&](int column, int row) { // rows from the bottom
        if (column < 0 || row < 0 || column >= picture.width || row >= picture.height) return false;
        const int from_top = picture.height - 1 - row;
        const double cover = static_cast<double>(cover_at(picture, column, from_top));
        return cover > half_covered && luminance(picture, column, from_top) > half_bright * cover;
    };
    const auto corner = [&](int column, int row) {
        return static_cast<std::uint32_t>(row * (picture.width + 1) + column);
    };
    std::vector<std::array<double, 2>> places;
    for (int row = 0; row <= picture.height; ++row)
        for (int column = 0; column <= picture.width; ++column)
            places.push_back({static_cast<double>(column), static_cast<double>(row)});
    std::vector<BoundaryPiece> pieces;
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column) {
            if (!is_inside(column, row)) continue;
            if (!is_inside(column, row - 1)) pieces.push_back({corner(column, row), corner(column + 1, row)});
            if (!is_inside(column + 1, row)) pieces.push_back({corner(column + 1, row), corner(column + 1, row + 1)});
            if (!is_inside(column, row + 1)) pieces.push_back({corner(column + 1, row + 1), corner(column, row + 1)});
            if (!is_inside(column - 1, row)) pieces.push_back({corner(column, row + 1), corner(column, row)});
        }
    if (pieces.empty())
        throw InputError(fmt::format("{}: no pixel is brighter than half{}: nothing is inside", printable(file),
                                     picture.alpha ? ", and transparent ones are outside" : ""));
    return region_of_pieces(pieces, places);
}

PlaneRegion region_of_formula(const std::string& formula, const std::array<double, 2>& low,
                              const std::array<double, 2>& high)
{
    const double step = std::max(high[0] - low[0], high[1] - low[1]) / formula_cells;
    const FormulaLattice lattice = lattice_of(formula, low, high, step);
    const std::vector<BoundaryPiece> pieces = pieces_of(lattice);
    if (pieces.empty())
        throw InputError(fmt::format("formula \"{}\": is nowhere above 0 in its rectangle", shortened(formula)));
    // The border lies on the outermost nodes: what is positive there ends there.
    const auto place_of = [&](std::size_t k, double node, int nodes) {
        const double part = std::clamp((node - 1) / (nodes - 3), 0.0, 1.0);
        return low[k] + (high[k] - low[k]) * part;
    };
    std::vector<std::array<double, 2>> places(2 * lattice.values.size());
    for (const BoundaryPiece& piece : pieces) {
        const std::uint32_t node = piece.from / 2;
        const int column = static_cast<int>(node) % lattice.columns, row = static_cast<int>(node) / lattice.columns;
        const bool goes_up = piece.from % 2 == 1;
        const double part = crossing(lattice.at(column, row), lattice.at(column + !goes_up, row + goes_up));
        places[piece.from] = {place_of(0, column + (goes_up ? 0 : part), lattice.columns),
                              place_of(1, row + (goes_up ? part : 0), lattice.rows)};
    }
    return region_of_pieces(pieces, places);
}

}
