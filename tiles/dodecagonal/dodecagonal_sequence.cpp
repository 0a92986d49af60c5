#include "tiles/dodecagonal/dodecagonal_sequence.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

__extension__ using SignedWide = __int128;

constexpr double sqrt3 = 1.7320508075688772;
constexpr double growth = 2 + sqrt3; ///< of the number of vertices, by a division

/// Squares are so small in the first tiling that they have few vertices before this division, the first one that can
/// give points of rank 1.
constexpr int first_level = 8;
constexpr std::size_t deepest_level = 32; ///< coefficients then have at most 58 bits
static_assert(DodecagonalSequence::densest < 0x1p45);

/// Vertices that come from a vertex are at most this many edges away: one after each division.
constexpr double reach = 1.0733; // 1 / (2 cos 15 degrees - 1), rounded up

/// The sign of a + b sqrt(3).
int sign_of(std::int64_t a, std::int64_t b)
{
    if (a >= 0 && b >= 0) return a > 0 || b > 0 ? 1 : 0;
    if (a <= 0 && b <= 0) return -1;
    const bool a_is_larger = SignedWide{a} * a > 3 * (SignedWide{b} * b); // never equal
    return (a > 0) == a_is_larger ? 1 : -1;
}

RingPlace turned_place(const RingPlace& x) // z^4 = z^2 - 1
{
    return {{-x.c[3], x.c[0], x.c[1] + x.c[3], x.c[2]}};
}

const std::array<RingPlace, 12>& roots_of_unity()
{
    static const std::array<RingPlace, 12> roots = [] {
        std::array<RingPlace, 12> all{{RingPlace{{1, 0, 0, 0}}}};
        for (std::size_t k = 1; k < 12; ++k) all[k] = turned_place(all[k - 1]);
        return all;
    }();
    return roots;
}

bool is_old_vertex(const RingPlace& place) { return is_dodecagonal_vertex(reduced_place(place)); }

std::array<double, 2> product(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
    return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
}

/// The new vertices of the polygon around an old vertex, a bit for each direction.
unsigned new_directions(const RingPlace& old)
{
    const auto& roots = roots_of_unity();
    unsigned found = 0;
    for (std::size_t k = 0; k < 12; ++k) {
        const RingPlace place = old + roots[k];
        if (!is_dodecagonal_vertex(place) || is_old_vertex(place)) continue;
        std::size_t first = 0;
        while (first < k && !is_old_vertex(place - roots[first])) ++first;
        if (first == k) found |= 1U << k;
    }
    return found;
}

std::uint32_t unit_of_density(double part)
{
    return static_cast<std::uint32_t>(std::clamp(part * 0x1p32, 0.0, 0x1p32 - 1));
}

/// The number of points per unit area where the density has full weight.
double densest_of(std::size_t count, const DensityBounds& density)
{
    const std::size_t pixels = std::size_t{density.width} * density.height;
    double sum = 0;
    for (std::size_t i = 0; i < pixels; ++i) sum += static_cast<double>(density.weights[i]);
    return static_cast<double>(count) * static_cast<double>(pixels) * static_cast<double>(full_weight) / sum;
}

/// The vertices of the first tiling from which points of the square can come.
std::vector<RingPlace> first_vertices(const RingPlace& middle)
{
    constexpr std::int64_t range = 4; // coefficients are at most (|x| + |x*|) * 2/sqrt(3) in size
    std::vector<RingPlace> found;
    for (std::int64_t a = -range; a <= range; ++a)
        for (std::int64_t b = -range; b <= range; ++b)
            for (std::int64_t c = -range; c <= range; ++c)
                for (std::int64_t d = -range; d <= range; ++d)
                    if (const RingPlace place = middle + RingPlace{{a, b, c, d}}; is_dodecagonal_vertex(place))
                        found.push_back(place);
    return found;
}

}

bool is_dodecagonal_vertex(const RingPlace& place)
{
    // The conjugate is (p + q sqrt(3) + (r + s sqrt(3)) i) / 2. It is tested against the edge from 1 to z; turns of the
    // place bring the other edges there.
    RingPlace x = place;
    for (int k = 0; k < 12; ++k, x = turned_place(x)) {
        const std::int64_t p = 2 * x.c[0] + x.c[2], q = -x.c[1], r = x.c[1] + 2 * x.c[3], s = -x.c[2];
        const int side = sign_of(3 * s - 2 * r - p + 2, r - 2 * s - q);
        if (side < 0 || (side == 0 && k >= 6)) return false;
    }
    return true;
}

RingPlace enlarged_place(const RingPlace& place) { return place + turned_place(place); }

RingPlace reduced_place(const RingPlace& place)
{
    const std::int64_t b = place.c[2] - place.c[3], a = place.c[1] - b;
    const std::int64_t d = a - place.c[0];
    return {{a, b, place.c[3] - d, d}};
}

std::span<const DodecagonalTurns> best_dodecagonal_turns()
{
    // The mean of N^(3/2) times the squared L2 star discrepancy, of prefixes of 60 to 1,100 points of 48 squares, was
    // made smaller by exchanges.
    static constexpr std::array all{
        DodecagonalTurns{0b10101, {1, 0, 2}},        DodecagonalTurns{0b10110, {1, 2, 0}},
        DodecagonalTurns{0b1001010, {0, 2, 1}},      DodecagonalTurns{0b1010010, {0, 2, 1}},
        DodecagonalTurns{0b10100101, {2, 0, 3, 1}},  DodecagonalTurns{0b101001010, {1, 3, 2, 0}},
        DodecagonalTurns{0b100000010010, {2, 1, 0}},
    };
    return all;
}

std::vector<DodecagonalVertex> divided_vertex(const DodecagonalVertex& vertex, std::span<const DodecagonalTurns> turns)
{
    const RingPlace old = enlarged_place(vertex.place);
    const unsigned directions = new_directions(old);
    const auto known = std::ranges::find(turns, directions, &DodecagonalTurns::directions);
    const int count = std::popcount(directions);
    std::vector<DodecagonalVertex> parts{{old, vertex.phase / growth}};
    for (std::size_t k = 0; k < 12; ++k) {
        if ((directions >> k & 1) == 0) continue;
        const std::size_t number = parts.size() - 1;
        const double turn = known == turns.end() ? static_cast<double>(number) : known->turns[number];
        parts.push_back({old + roots_of_unity()[k], (1 + (growth - 1) * ((turn + vertex.phase) / count)) / growth});
    }
    return parts;
}

RingPlace place_with_vertices(std::int64_t second, std::int64_t third)
{
    // These two make the conjugate's parts smaller than 1.
    const double b = static_cast<double>(second), c = static_cast<double>(third);
    return {{static_cast<std::int64_t>(std::floor(b * sqrt3 / 2 - c / 2)), second, third,
             static_cast<std::int64_t>(std::floor(c * sqrt3 / 2 - b / 2))}};
}

DodecagonalSequence::DodecagonalSequence(const DodecagonalMiddle& middle, std::span<const DodecagonalTurns> turns)
    : turns_(turns)
{
    const double cosine = std::sqrt(growth) / 2; // of 15 degrees
    double edge = 1, density = 1;
    for (int i = 0; i < first_level; ++i) {
        edge *= std::sqrt(growth);
        density /= growth;
    }
    // The square is turned, and so are places in it, the other way round.
    std::array<double, 2> unit{edge * std::sqrt((1 + cosine) / 2), -edge * std::sqrt((1 - cosine) / 2)};
    middle_ = product(middle.shift, unit);
    const std::array<double, 2> reduced{(1 + sqrt3 / 2) / growth, -0.5 / growth}; // 1 / (1 + z)
    RingPlace place = middle.place;
    for (std::size_t level = 0; level <= deepest_level; ++level) {
        levels_.push_back({place, unit, edge, density});
        place = enlarged_place(place);
        unit = product(unit, reduced);
        edge /= std::sqrt(growth);
        density *= growth;
    }
}

struct DodecagonalSequence::Found
{
    const DensityBounds& density;
    double most; ///< rank over weight
    std::vector<DodecagonalPoint> points{};
};

std::array<double, 2> DodecagonalSequence::position(const RingPlace& place, std::size_t level) const
{
    const auto [a, b, c, d] = (place - levels_[level].middle).c;
    const std::array<double, 2> away{static_cast<double>(2 * a + c) / 2 + static_cast<double>(b) * (sqrt3 / 2),
                                     static_cast<double>(b + 2 * d) / 2 + static_cast<double>(c) * (sqrt3 / 2)};
    const std::array<double, 2> in_square = product(away, levels_[level].unit);
    return {in_square[0] - middle_[0] + 0.5, in_square[1] - middle_[1] + 0.5};
}

void DodecagonalSequence::offer(const DodecagonalVertex& vertex, const std::array<double, 2>& place, std::size_t level,
                                Found& found) const
{
    if (place[0] < 0 || place[0] >= 1 || place[1] < 0 || place[1] >= 1) return;
    const auto weight = static_cast<double>(found.density.at({unit_of_density(place[0]), unit_of_density(place[1])}));
    const double rank = vertex.phase * levels_[level].density * static_cast<double>(full_weight);
    if (rank <= found.most * weight) found.points.push_back({place, rank / weight});
}

void DodecagonalSequence::collect(const DodecagonalVertex& vertex, const std::array<double, 2>& place,
                                  std::size_t level, Found& found) const
{
    const double away = reach * levels_[level].edge;
    const auto misses = [&](double x) { return x + away < 0 || x - away >= 1; };
    if (level == deepest_level || misses(place[0]) || misses(place[1])) return;
    const std::uint64_t weight =
        found.density.over({unit_of_density(place[0] - away), unit_of_density(place[1] - away)},
                           {unit_of_density(place[0] + away), unit_of_density(place[1] + away)});
    // New vertices have larger ranks than all vertices of this level.
    if (levels_[level].density * static_cast<double>(full_weight) > found.most * static_cast<double>(weight)) return;
    const std::vector<DodecagonalVertex> parts = divided_vertex(vertex, turns_);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::array<double, 2> at = i == 0 ? place : position(parts[i].place, level + 1);
        if (i > 0) offer(parts[i], at, level + 1, found);
        collect(parts[i], at, level + 1, found);
    }
}

std::vector<DodecagonalPoint> DodecagonalSequence::points(std::size_t count, const DensityBounds& density) const
{
    check_dodecagonal_density(count, density);
    Found found{density, densest_of(count, density) * 1.02 + 4};
    for (;; found.most *= 1.25) {
        found.points.clear();
        for (const RingPlace& place : first_vertices(levels_[0].middle)) {
            offer({place}, position(place, 0), 0, found);
            collect({place}, position(place, 0), 0, found);
        }
        if (found.points.size() >= count) break;
    }
    std::ranges::stable_sort(found.points, {}, &DodecagonalPoint::rank);
    found.points.resize(count);
    return std::move(found.points);
}

void check_dodecagonal_density(std::size_t count, const DensityBounds& density)
{
    if (const double densest = densest_of(count, density); densest > DodecagonalSequence::densest)
        throw InputError(fmt::format("has a densest place of {:.3g} points per unit area: must be at most {:.3g}",
                                     densest, DodecagonalSequence::densest));
}

}
