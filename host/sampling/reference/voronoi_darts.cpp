// Dart throwing by Voronoi cells, plain and sequential: what the kernels must reproduce.
#include "host/sampling/classics/voronoi_darts.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/torus.hpp"
#include "host/sampling/cells/cut_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace poissonlab::reference {
namespace {

using namespace contract::voronoi_darts;

/// The angle of a direction with 0 <= y <= x: to a sixteenth of half a turn by rotation, then by the series of the
/// arcus tangent.
double angle_below_diagonal(double x, double y)
{
    constexpr double tangent = 0.41421356237309503; // of an eighth of half a turn
    double base = 0, along = x, up = y;
    if (y > x * 0.66817863791929888) {
        base = std::numbers::pi / 4;
        along = x + y;
        up = y - x;
    } else if (y > x * 0.19891236737965800) {
        base = std::numbers::pi / 8;
        along = x + y * tangent;
        up = y - x * tangent;
    }
    const double z = up / along;
    double series = 1.0 / 25;
    for (int n = 23; n > 0; n -= 2) series = 1.0 / n - z * z * series;
    return base + z * series;
}

/// The angle of a direction with y >= 0 and any x.
double angle_of(double x, double y)
{
    const double across = std::abs(x);
    const double angle =
        across > y ? angle_below_diagonal(across, y) : std::numbers::pi / 2 - angle_below_diagonal(y, across);
    return x < 0 ? std::numbers::pi - angle : angle;
}

/// The area between a part of an edge of a site's cell and its disk. The part goes from `begin` to `end` along the
/// edge's line, from the foot of the site; lengths are in units of 2^-32.
struct FreePiece
{
    std::uint32_t site;
    double direction_x, direction_y;
    double height; ///< of the line
    double begin, end;
    std::uint64_t area;

    double squared_at(double along) const { return height * height + along * along; }
};

std::uint64_t area_of(const FreePiece& piece, double squared_radius)
{
    const double length = piece.end - piece.begin;
    if (!(length > 0 && piece.height > 0)) return 0;
    const double angle = angle_of(piece.height * piece.height + piece.begin * piece.end, piece.height * length);
    const double area = (piece.height * length - squared_radius * angle) / 2;
    return area > 0 ? static_cast<std::uint64_t>(area + 0.5) : 0;
}

class VoronoiThrowing
{
public:
    explicit VoronoiThrowing(const DartThrowingRequest& request)
        : request_(request), torus_(voronoi_dart_torus(request.min_distance)), offsets_(offsets_by_gap()),
          squared_radius_(static_cast<double>(torus_.squared_min_distance)),
          slots_(lattice_cells(torus_.grid_size, 2), none)
    {}

    PointSet run()
    {
        const std::size_t target = request_.points.value_or(SIZE_MAX);
        VoronoiDartBatches batches(torus_);
        for (std::uint32_t batch = 0; points_.size() < target; ++batch) {
            const bool anywhere = !batches.measures() || !measure();
            if (!anywhere && pieces_.empty()) break;
            const std::uint32_t darts =
                anywhere ? batches.darts_anywhere() : VoronoiDartBatches::darts_for(open_sites_);
            const std::size_t before = points_.size();
            for (std::uint32_t dart = 0; dart < darts; ++dart) {
                const auto position = anywhere ? place_anywhere(dart, batch) : place_in_free_area(dart, batch);
                if (position && !is_covered(*position)) add(*position);
            }
            if (!batches.goes_on(darts, points_.size() - before, anywhere)) break;
        }
        return to_point_set<2>(std::span<const TorusPoint<2>>(points_).first(std::min(points_.size(), target)));
    }

private:
    static constexpr std::uint32_t none = UINT32_MAX;

    std::uint32_t cell_of(std::uint32_t coordinate) const
    {
        return static_cast<std::uint32_t>(std::uint64_t{coordinate} * torus_.grid_size >> 32);
    }

    /// The point in a cell, and how many times the torus lies between its number and those of the grid.
    struct Neighbour
    {
        std::uint32_t point;
        int turns_x, turns_y;
    };
    Neighbour neighbour(const TorusPoint<2>& position, const Offset& offset) const
    {
        const auto size = static_cast<int>(torus_.grid_size);
        const auto turns = [&](int cell) { return cell >= 0 ? cell / size : -((size - 1 - cell) / size); };
        const int x = static_cast<int>(cell_of(position[0])) + offset.x;
        const int y = static_cast<int>(cell_of(position[1])) + offset.y;
        const int inside_x = x - turns(x) * size, inside_y = y - turns(y) * size;
        return {slots_[static_cast<std::size_t>(inside_y) * torus_.grid_size + static_cast<std::size_t>(inside_x)],
                turns(x), turns(y)};
    }

    bool is_covered(const TorusPoint<2>& position) const
    {
        return std::ranges::any_of(std::span(offsets_).first(torus_.near_offsets), [&](const Offset& offset) {
            const std::uint32_t point = neighbour(position, offset).point;
            return point != none && squared_distance<2>(points_[point], position) < torus_.squared_min_distance;
        });
    }

    void add(const TorusPoint<2>& position)
    {
        const std::size_t row = cell_of(position[1]);
        slots_[row * torus_.grid_size + cell_of(position[0])] = static_cast<std::uint32_t>(points_.size());
        points_.push_back(position);
    }

    /// The Voronoi cell of a point; empty where its disk covers it. Nothing where it is unknown.
    std::optional<CutPolygon> cell_of_site(std::uint32_t site) const
    {
        const double far = std::sqrt(torus_.squared_cell) * int{MAX_GAP};
        CutPolygon cell = square_around(far);
        double squared_radius = 2 * far * far;
        for (std::size_t i = 1; i < offsets_.size(); ++i) {
            if (offsets_[i].squared_gap * torus_.squared_cell > 4 * squared_radius * (1 + 0x1p-40)) return cell;
            const Neighbour other = neighbour(points_[site], offsets_[i]);
            if (other.point == none) continue;
            const auto difference = [&](std::size_t k, int turns) {
                return static_cast<double>(points_[other.point][k]) - static_cast<double>(points_[site][k]) +
                       turns * 0x1p32;
            };
            const double x = difference(0, other.turns_x), y = difference(1, other.turns_y);
            if (x * x + y * y >= 4 * squared_radius) continue;
            cell = without_side(cell, x, y, other.point);
            if (cell.size() > max_cut_vertices) return std::nullopt;
            squared_radius = squared_radius_of(cell);
            if (squared_radius <= squared_radius_) return CutPolygon{};
        }
        return std::nullopt;
    }

    /// Appends the pieces of an edge that have free area; at most two.
    void add_pieces(std::uint32_t site, const CutVertex& a, const CutVertex& b)
    {
        const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
        if (!(length > 0)) return;
        const double direction_x = (b.x - a.x) / length, direction_y = (b.y - a.y) / length;
        const double height = (a.x * b.y - a.y * b.x) / length;
        const double begin = a.x * direction_x + a.y * direction_y;
        const double end = b.x * direction_x + b.y * direction_y;
        const auto append = [&](double from, double to) {
            FreePiece piece{site, direction_x, direction_y, height, from, to, 0};
            piece.area = area_of(piece, squared_radius_);
            if (piece.area > 0) pieces_.push_back(piece);
        };
        const double squared_half_chord = squared_radius_ - height * height;
        if (!(squared_half_chord > 0)) return append(begin, end);
        const double half_chord = std::sqrt(squared_half_chord);
        append(begin, std::min(end, -half_chord));
        append(std::max(begin, half_chord), end);
    }

    /// All pieces of free area. False where cells are unknown.
    bool measure()
    {
        pieces_.clear();
        ends_.clear();
        open_sites_ = 0;
        std::uint64_t sum = 0;
        for (std::uint32_t site = 0; site < points_.size(); ++site) {
            const auto cell = cell_of_site(site);
            if (!cell) return false;
            const std::size_t first = pieces_.size();
            for (std::size_t i = 0; i < cell->size(); ++i)
                add_pieces(site, (*cell)[i], (*cell)[(i + 1) % cell->size()]);
            for (std::size_t i = first; i < pieces_.size(); ++i) ends_.push_back(sum += pieces_[i].area);
            open_sites_ += pieces_.size() > first;
        }
        return true;
    }

    std::array<std::uint32_t, 4> words(std::uint32_t dart, std::uint32_t batch, std::uint32_t trial) const
    {
        return philox({dart, batch, trial, 0}, request_.stream);
    }

    std::optional<TorusPoint<2>> place_anywhere(std::uint32_t dart, std::uint32_t batch) const
    {
        const auto random = words(dart, batch, 0);
        return TorusPoint<2>{random[0], random[1]};
    }

    static std::uint64_t long_word(const std::array<std::uint32_t, 4>& words)
    {
        return std::uint64_t{words[0]} << 32 | words[1];
    }

    /// A piece by its area, a place on it by how much there is between it and the disk, and a distance.
    std::optional<TorusPoint<2>> place_in_free_area(std::uint32_t dart, std::uint32_t batch) const
    {
        __extension__ using Wide = unsigned __int128;
        const auto chosen =
            static_cast<std::uint64_t>(static_cast<Wide>(long_word(words(dart, batch, 0))) * ends_.back() >> 64);
        const FreePiece& piece =
            pieces_[static_cast<std::size_t>(std::ranges::upper_bound(ends_, chosen) - ends_.begin())];
        const double farthest = std::max(piece.squared_at(piece.begin), piece.squared_at(piece.end));
        const double most = (farthest - squared_radius_) / farthest;
        for (std::uint32_t trial = 1; trial <= MAX_TRIALS; ++trial) {
            const auto random = words(dart, batch, trial);
            const double part = static_cast<double>(long_word(random) >> 11) * 0x1p-53;
            const double along = piece.begin + part * (piece.end - piece.begin);
            const double squared = piece.squared_at(along);
            if (!(random[2] * 0x1p-32 * most * squared < squared - squared_radius_)) continue;
            const double squared_distance = squared_radius_ + (random[3] + 0.5) * 0x1p-32 * (squared - squared_radius_);
            const double scale = std::sqrt(squared_distance / squared);
            const auto to_units = [](double x) {
                return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(x + 0.5)));
            };
            const double x = piece.height * piece.direction_y + along * piece.direction_x;
            const double y = along * piece.direction_y - piece.height * piece.direction_x;
            return TorusPoint<2>{points_[piece.site][0] + to_units(x * scale),
                                 points_[piece.site][1] + to_units(y * scale)};
        }
        return std::nullopt;
    }

    DartThrowingRequest request_;
    Torus torus_;
    std::vector<Offset> offsets_;
    double squared_radius_; ///< of disks that reach to the minimum distance
    std::vector<std::uint32_t> slots_;
    std::vector<TorusPoint<2>> points_;
    std::vector<FreePiece> pieces_;
    std::vector<std::uint64_t> ends_; ///< sums of areas, each with those before
    std::size_t open_sites_ = 0;      ///< that have free area
};

}

PointSet throw_voronoi_darts(const DartThrowingRequest& request) { return VoronoiThrowing(request).run(); }

}
