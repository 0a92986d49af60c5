#include "host/distribution/regions/line_points.hpp"

#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "base/regions/obstacles.hpp"
#include "base/regions/polygon_sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

namespace poissonlab {
namespace {

using LinePlace = std::array<double, 2>;

constexpr double line_positions = 0x1p52; ///< on all lines together
constexpr double most_pieces_of_lines = 0x1p25;
constexpr double most_line_cells = 0x1p31; ///< along a side of the box

/// Darts on lines have this attempt of random numbers, so that no other darts have the same ones.
constexpr std::uint32_t line_attempt = 0x6c696e65;

/// Arcs of polygons around obstacles lie inside their circles by less than this part of the distance: see grown().
constexpr double arc_loss = 4e-5;

/// Computed distances are off by less than this, because places and ends of intervals are rounded.
double line_margin(double distance, const RegionBox& box) { return 4 * distance_rounding(distance, box); }

/// A piece of a line is straight, and not longer than the distance.
struct LinePiece
{
    LinePlace from, to;
    std::uint32_t line = 0;
    std::uint64_t steps = 0; ///< positions are 0 to this one

    double length() const
    {
        const double x = to[0] - from[0], y = to[1] - from[1];
        return std::sqrt(x * x + y * y); // std::hypot differs between libraries
    }

    LinePlace at(std::uint64_t position) const
    {
        const double part = steps == 0 ? 0 : static_cast<double>(position) / static_cast<double>(steps);
        return {from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part};
    }
};

/// Returns the edges of all lines; an edge that comes again, as where two parcels meet, counts once.
std::vector<LinePiece> edges_of(const std::vector<RegionRing>& lines)
{
    std::vector<LinePiece> edges;
    for (std::size_t line = 0; line < lines.size(); ++line)
        for (std::size_t i = 1; i < lines[line].size(); ++i)
            if (lines[line][i - 1] != lines[line][i])
                edges.push_back({lines[line][i - 1], lines[line][i], static_cast<std::uint32_t>(line)});
    const auto ends = [&](std::size_t i) -> std::pair<LinePlace, LinePlace> {
        return std::minmax(edges[i].from, edges[i].to);
    };
    std::vector<std::size_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(ends(i), i); });
    std::vector<bool> comes_again(edges.size());
    for (std::size_t k = 1; k < order.size(); ++k) comes_again[order[k]] = ends(order[k]) == ends(order[k - 1]);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!comes_again[i]) edges[kept++] = edges[i];
    edges.resize(kept);
    return edges;
}

double total_length(const std::vector<LinePiece>& edges)
{
    double length = 0;
    for (const LinePiece& edge : edges) length += edge.length();
    return length;
}

std::vector<LinePiece> pieces_of(const std::vector<LinePiece>& edges, double distance)
{
    const double length = total_length(edges);
    std::vector<LinePiece> pieces;
    for (const LinePiece& edge : edges) {
        const double count = std::max(1.0, std::ceil(edge.length() / distance));
        LinePiece piece{edge.from, edge.from, edge.line};
        for (double i = 1; i <= count; ++i) {
            piece.from = piece.to;
            for (std::size_t k = 0; k < 2; ++k)
                piece.to[k] = i == count ? edge.to[k] : edge.from[k] + (edge.to[k] - edge.from[k]) * (i / count);
            piece.steps = static_cast<std::uint64_t>(piece.length() / length * line_positions);
            pieces.push_back(piece);
        }
    }
    return pieces;
}

/// Counts the free positions of all pieces, and finds the one with a number, by a tree of sums (Fenwick 1994).
class FreePositions
{
    using Interval = std::pair<std::uint64_t, std::uint64_t>;

public:
    explicit FreePositions(const std::vector<LinePiece>& pieces) : sums_(pieces.size() + 1)
    {
        for (const LinePiece& piece : pieces) free_.push_back({Interval{0, piece.steps + 1}});
        for (std::size_t i = 1; i < sums_.size(); ++i) sums_[i] += pieces[i - 1].steps + 1;
        for (std::size_t i = 1; i < sums_.size(); ++i)
            if (const std::size_t next = i + (i & (~i + 1)); next < sums_.size()) sums_[next] += sums_[i];
        for (const LinePiece& piece : pieces) count_ += piece.steps + 1;
    }

    std::uint64_t count() const { return count_; }

    /// Returns the piece of the free position with a number, and the position on it.
    std::pair<std::size_t, std::uint64_t> free_one(std::uint64_t number) const
    {
        std::size_t piece = 0;
        for (std::size_t step = std::bit_floor(sums_.size() - 1); step > 0; step /= 2)
            if (piece + step < sums_.size() && sums_[piece + step] <= number) {
                piece += step;
                number -= sums_[piece];
            }
        for (const auto& [begin, end] : free_[piece]) {
            if (number < end - begin) return {piece, begin + number};
            number -= end - begin;
        }
        throw std::logic_error("a free position has no place"); // the sums are those of the intervals
    }

    /// Takes the positions from `begin` to before `end`.
    void take(std::size_t piece, std::uint64_t begin, std::uint64_t end)
    {
        std::vector<Interval> left;
        std::uint64_t taken = 0;
        for (const auto& [from, to] : free_[piece]) {
            const std::uint64_t low = std::clamp(begin, from, to), high = std::clamp(end, low, to);
            taken += high - low;
            if (from < low) left.emplace_back(from, low);
            if (high < to) left.emplace_back(high, to);
        }
        if (taken == 0) return;
        free_[piece] = std::move(left);
        count_ -= taken;
        for (std::size_t i = piece + 1; i < sums_.size(); i += i & (~i + 1)) sums_[i] -= taken;
    }

private:
    std::vector<std::vector<Interval>> free_;
    std::vector<std::uint64_t> sums_;
    std::uint64_t count_ = 0;
};

/// Throws darts onto pieces, which lie in cells of one and a half distances. Cells are found by bisection, so that
/// memory grows with the length of lines and not with the area around them.
class LineDarts
{
public:
    LineDarts(std::vector<LinePiece> pieces, const RegionBox& box, double distance)
        : pieces_(in_cells(std::move(pieces), box, distance)), free_(pieces_)
    {}

    bool is_full() const { return free_.count() == 0; }
    std::uint64_t free_count() const { return free_.count(); }

    /// Takes all positions nearer to a place than a distance, which must not be larger than that of the cells.
    void keep_away(const LinePlace& place, double distance)
    {
        for (std::size_t k = 0; k < 2; ++k)
            if (place[k] < box_.low[k] - 2 * side_ || place[k] > box_.high[k] + 2 * side_) return;
        const std::int64_t column = cell(place, 0), row = cell(place, 1);
        for (std::int64_t r = row - 1; r <= row + 1; ++r) {
            auto at = std::ranges::lower_bound(cells_, key(column - 1, r));
            for (; at != cells_.end() && *at <= key(column + 1, r); ++at)
                keep_piece_away(static_cast<std::size_t>(at - cells_.begin()), place, distance);
        }
    }

    /// Throws one dart. Returns its place, and the line that it is on.
    std::pair<LinePlace, std::uint32_t> dart(std::uint64_t random)
    {
        const auto number = static_cast<std::uint64_t>((static_cast<Wide>(random) * free_.count()) >> 64);
        const auto [piece, position] = free_.free_one(number);
        free_.take(piece, position, position + 1);
        return {pieces_[piece].at(position), pieces_[piece].line};
    }

private:
    __extension__ using Wide = unsigned __int128;

    std::int64_t cell(const LinePlace& place, std::size_t k) const
    {
        return static_cast<std::int64_t>(std::floor((place[k] - box_.low[k]) / side_)) + 2;
    }

    static std::uint64_t key(std::int64_t column, std::int64_t row)
    {
        return (static_cast<std::uint64_t>(row) << 32) | static_cast<std::uint64_t>(column);
    }

    std::vector<LinePiece> in_cells(std::vector<LinePiece> pieces, const RegionBox& box, double distance)
    {
        box_ = box;
        side_ = 1.5 * distance * (1 + 0x1p-20);
        std::vector<std::pair<std::uint64_t, std::size_t>> order;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const LinePlace middle{(pieces[i].from[0] + pieces[i].to[0]) / 2,
                                   (pieces[i].from[1] + pieces[i].to[1]) / 2};
            order.emplace_back(key(cell(middle, 0), cell(middle, 1)), i);
        }
        std::ranges::sort(order);
        std::vector<LinePiece> sorted;
        for (const auto& [cell, piece] : order) {
            cells_.push_back(cell);
            sorted.push_back(pieces[piece]);
        }
        return sorted;
    }

    void keep_piece_away(std::size_t i, const LinePlace& place, double distance)
    {
        const LinePiece& piece = pieces_[i];
        const LinePlace along{piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]};
        const LinePlace there{place[0] - piece.from[0], place[1] - piece.from[1]};
        const double length = piece.length(), steps = static_cast<double>(piece.steps);
        const double beside = std::abs(along[0] * there[1] - along[1] * there[0]) / length;
        if (!(beside < distance)) return;
        const double foot = (along[0] * there[0] + along[1] * there[1]) / length;
        const double half = std::sqrt((distance - beside) * (distance + beside));
        // A piece that is shorter than a step has the position 0 alone.
        const double unit = piece.steps == 0 ? 1 : steps / length;
        const double first = std::floor((foot - half) * unit) + 1, last = std::ceil((foot + half) * unit) - 1;
        if (last < 0 || first > steps || last < first) return;
        free_.take(i, static_cast<std::uint64_t>(std::max(first, 0.0)),
                   static_cast<std::uint64_t>(std::min(last, steps)) + 1);
    }

    RegionBox box_;
    double side_ = 0;
    std::vector<std::uint64_t> cells_; ///< of each piece, in order
    std::vector<LinePiece> pieces_;
    FreePositions free_;
};

/// Returns the parts of lines that are far enough from obstacles that are lines or polygons; `numbers` has the number
/// of the region's line that each part belongs to.
std::vector<RegionRing> lines_among(const RegionLand& land, double distance, std::vector<std::size_t>& numbers)
{
    const std::vector<RegionRing>& lines = lines_of(land.whole);
    const Obstacles walls{{}, land.obstacles.lines, land.obstacles.polygons};
    if (walls.count() > 0) return lines_without(lines, grown(walls, distance * (1 + arc_loss)), numbers);
    numbers.resize(lines.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return lines;
}

[[noreturn]] void fail_saturated(const DartSettings& settings, const RegionDarts& darts)
{
    const double share = static_cast<double>(darts.points.size()) / static_cast<double>(*settings.points);
    throw InputError(fmt::format(
        "the lines are saturated with {} of {} points: no further one fits; {} can be reached", darts.points.size(),
        *settings.points,
        settings.min_distance ? fmt::format("a minimum distance of about {:.4g}", darts.request.min_distance * share)
                              : fmt::format("a relative radius of about {:.4f}", settings.relative_radius * share)));
}

}

double length_along(const std::vector<RegionRing>& lines) { return total_length(edges_of(lines)); }

double distance_along(const DartSettings& settings, const std::vector<RegionRing>& lines)
{
    const double length = total_length(edges_of(lines)), longest = box_around(lines).longest();
    const double distance = settings.min_distance
                                ? *settings.min_distance
                                : settings.relative_radius * length / static_cast<double>(*settings.points);
    if (settings.min_distance && distance > longest)
        throw InputError(fmt::format("{:.6g} is more than the lines' longest side, {:.6g}: there is room for one point",
                                     distance, longest));
    if (length / distance > most_pieces_of_lines || longest / distance > most_line_cells)
        throw InputError(
            fmt::format("lines of {:.6g} have more than {:.0f} distances of {:.3g}, or are more than {:.0f} "
                        "distances across: more than memory holds",
                        length, most_pieces_of_lines, distance, most_line_cells));
    return distance;
}

RegionDarts throw_line_darts(const DartSettings& settings, std::uint64_t seed, std::uint32_t realization)
{
    RegionDarts made;
    made.points = {2, {}};
    made.request.land = region_land(settings);
    const RegionLand& land = *made.request.land;
    const std::vector<RegionRing>& lines = lines_of(land.whole);
    const RegionBox box = box_around(lines);
    made.request.min_distance = made.sure_distance = distance_along(settings, lines);
    const ObstacleDistances away = obstacle_distances(settings, made.sure_distance);
    std::vector<std::size_t> numbers;
    const std::vector<RegionRing> rest = lines_among(land, away.lines, numbers);
    const std::vector<LinePiece> edges = edges_of(rest);
    made.length = total_length(edges);
    const double apart = made.sure_distance + line_margin(made.sure_distance, box);
    const double from_points = away.points + line_margin(away.points, box);
    LineDarts darts(pieces_of(edges, made.sure_distance), box,
                    land.obstacles.points.empty() ? apart : std::max(apart, from_points));
    const std::uint64_t all = darts.free_count();
    for (const LinePlace& point : land.obstacles.points) darts.keep_away(point, from_points);
    if (darts.is_full()) throw InputError("the lines have no room for a point among the obstacles");
    if (rest != lines || darts.free_count() < all) made.request.near_obstacles = land.obstacles.count();
    const StreamKey stream = stream_key(seed, Purpose::dart_throwing, realization, line_attempt);
    const RegionSource& source = *land.whole.source;
    for (std::uint32_t i = 0; !darts.is_full() && i < settings.points.value_or(SIZE_MAX); ++i) {
        const auto words = philox({i, 0, 0, 0}, stream);
        const auto [place, line] = darts.dart((std::uint64_t{words[0]} << 32) | words[1]);
        darts.keep_away(place, apart);
        made.points.coordinates.insert(made.points.coordinates.end(), place.begin(), place.end());
        if (!source.feature_of_line.empty())
            made.features.push_back(source.features[source.feature_of_line[numbers[line]]].id);
    }
    if (settings.points && made.points.size() < *settings.points) fail_saturated(settings, made);
    made.is_saturated = !settings.points;
    return made;
}

}
