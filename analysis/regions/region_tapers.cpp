#include "analysis/regions/region_tapers.hpp"

#include "analysis/regions/region_transform.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// A boundary on a line of the grid crosses no cell, where rounding moves it by less than this part of one.
constexpr double rounded_part = 1e-6;

/// Cells of a row, from the first one to before the end.
struct CellRun
{
    std::uint32_t begin = 0, end = 0;
};
using Runs = std::vector<CellRun>;

/// Adds the cells that an edge crosses to the runs of their rows; the edge is in units of cells. An edge along the line
/// between two cells adds an empty run, because the cells on its two sides may differ.
void mark_edge(std::array<double, 2> from, std::array<double, 2> to, const std::array<std::size_t, 2>& cells,
               std::vector<Runs>& crossed)
{
    if (from[1] > to[1]) std::swap(from, to);
    const double slope = to[1] > from[1] ? (to[0] - from[0]) / (to[1] - from[1]) : 0;
    const bool is_level = to[1] == from[1];
    const auto last_column = static_cast<double>(cells[0]);
    const auto first = static_cast<std::size_t>(std::clamp(from[1], 0.0, static_cast<double>(cells[1] - 1)));
    for (std::size_t row = first; row < cells[1] && static_cast<double>(row) + rounded_part < to[1]; ++row) {
        const double low = std::max(from[1], static_cast<double>(row) + rounded_part);
        const double high = std::min(to[1], static_cast<double>(row + 1) - rounded_part);
        if (low > high) continue;
        const double a = is_level ? from[0] : from[0] + slope * (low - from[1]);
        const double b = is_level ? to[0] : from[0] + slope * (high - from[1]);
        const double begin = std::floor(std::clamp(std::min(a, b) + rounded_part, 0.0, last_column));
        const double end = std::ceil(std::clamp(std::max(a, b) - rounded_part, 0.0, last_column));
        crossed[row].push_back({static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(std::max(begin, end))});
    }
}

/// The runs of cells of a row that are inside. The cells between two crossed runs are all inside or all outside.
template <typename Inside>
Runs runs_inside(Runs crossed, std::uint32_t columns, const Inside& is_inside)
{
    std::ranges::sort(crossed, {}, &CellRun::begin);
    crossed.push_back({columns, columns});
    Runs inside;
    std::uint32_t begin = 0;
    for (const CellRun& run : crossed) {
        if (run.begin > begin && is_inside(begin)) inside.push_back({begin, run.begin});
        begin = std::max(begin, run.end);
    }
    return inside;
}

/// Visits the columns of nodes between two rows, whose cells to the left and to the right are inside in both.
template <typename Visit>
void for_common_nodes(const Runs& below, const Runs& above, const Visit& visit)
{
    for (std::size_t i = 0, k = 0; i < below.size() && k < above.size();) {
        const std::uint32_t begin = std::max(below[i].begin, above[k].begin),
                            end = std::min(below[i].end, above[k].end);
        for (std::uint32_t column = begin + 1; column < end; ++column) visit(column);
        (below[i].end < above[k].end ? i : k) += 1;
    }
}

/// Cells of the grid along the longer side of the box, and along the shorter at least.
constexpr double taper_cells = 128;
constexpr double fewest_taper_cells = 32;

/// Nodes in excess of tapers that are needed, so that each taper has a form.
constexpr std::size_t nodes_a_taper = 16;

/// A region is long if its box is, or if the grid over its box has fewer nodes than the largest number of tapers needs.
constexpr double longest_box = 32;

/// The cells of a long region are as wide as its width, twice the area over the boundary, divided by `cells_across`.
/// The number that would fill its area is at least that of a compact region, so that tapers have a form, and is limited
/// in all and for each taper, because memory and time are.
constexpr double cells_across = 16;
constexpr double fewest_cells = 1 << 14, most_cells = 1 << 19, most_cells_times_tapers = 1 << 22;

/// Rows and columns of grids, which have a number each: 200 MiB.
constexpr double most_rows = 1 << 22;

/// Values of sums over nodes that are kept, of 16 bytes each: a GiB. Where there are more, they are summed anew.
constexpr std::size_t most_kept_values = std::size_t{1} << 26;

double sinc_of(double t) { return std::abs(t) < 1e-8 ? 1 : std::sin(std::numbers::pi * t) / (std::numbers::pi * t); }

/// The transform of a pyramid, along one axis.
double pyramid_along(double frequency, double step)
{
    const double s = sinc_of(frequency * step);
    return step * s * s;
}

}

TaperGrid::TaperGrid(const FramedRegion& region, const std::array<std::size_t, 2>& cells) : cells_(cells)
{
    const RegionBox box = box_of(region.polygons());
    for (std::size_t k = 0; k < 2; ++k) step_[k] = (box.high[k] - box.low[k]) / static_cast<double>(cells_[k]);
    std::vector<Runs> crossed(cells_[1]);
    const auto in_cells = [&](const std::array<double, 2>& p) { return std::array{p[0] / step_[0], p[1] / step_[1]}; };
    for (const RegionEdge& e : region.boundary().edges()) mark_edge(in_cells(e.from), in_cells(e.to), cells_, crossed);
    Runs below;
    for (std::size_t row = 0; row < cells_[1]; ++row) {
        const double y = (static_cast<double>(row) + 0.5) * step_[1];
        Runs above =
            runs_inside(std::move(crossed[row]), static_cast<std::uint32_t>(cells_[0]), [&](std::uint32_t column) {
                return region.contains({(column + 0.5) * step_[0], y});
            });
        row_begins_.push_back(columns_.size());
        for_common_nodes(below, above, [&](std::uint32_t column) { columns_.push_back(column); });
        below = std::move(above);
    }
    row_begins_.resize(cells_[1] + 2, columns_.size());
}

std::size_t TaperGrid::number(std::size_t column, std::size_t row) const
{
    const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(row_begins_[row]);
    const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(row_begins_[row + 1]);
    const auto found = std::lower_bound(begin, end, column);
    return found != end && *found == column ? static_cast<std::size_t>(found - columns_.begin()) : no_node;
}

namespace {

TaperGrid grid_over_box(const FramedRegion& region, double step, double fewest)
{
    const RegionBox box = box_of(region.polygons());
    std::array<std::size_t, 2> cells{};
    for (std::size_t k = 0; k < 2; ++k)
        cells[k] = static_cast<std::size_t>(
            std::min(most_rows + 1, std::max(fewest, std::round((box.high[k] - box.low[k]) / step))));
    if (std::max(cells[0], cells[1]) > static_cast<std::size_t>(most_rows))
        throw InputError("the region is too long for its width, or its parts are too far apart, for tapers");
    return {region, cells};
}

double length_of_boundary(const FramedRegion& region)
{
    double length = 0;
    for (const RegionEdge& e : region.boundary().edges())
        length += std::hypot(e.to[0] - e.from[0], e.to[1] - e.from[1]);
    return length;
}

/// The width of cells of a long region, in the frame.
double cell_of_long(const FramedRegion& region, double boundary, std::size_t tapers)
{
    const double wanted = std::pow(cells_across * boundary / 2, 2) / region.area();
    const double most = std::min(most_cells, most_cells_times_tapers / static_cast<double>(tapers));
    return std::sqrt(region.area() / std::clamp(wanted, fewest_cells, most));
}

}

RegionTapers::RegionTapers(const FramedRegion& region, std::size_t count)
    : grid_(grid_over_box(region, box_of(region.polygons()).longest() / taper_cells, fewest_taper_cells))
{
    const RegionBox box = box_of(region.polygons());
    const double shortest = std::min(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    const double boundary = length_of_boundary(region);
    const bool is_long = box.longest() > longest_box * shortest || grid_.size() < nodes_a_taper * most_tapers;
    if (is_long) grid_ = grid_over_box(region, cell_of_long(region, boundary, count), 1);
    for (std::size_t k = 0; k < 2; ++k) step_[k] = grid_.step()[k] / region.unit_length();
    if (grid_.size() < nodes_a_taper * count)
        throw InputError(fmt::format("the region is too thin for {} tapers: {} nodes of a grid of {} x {} squares over "
                                     "it have all squares around them inside; at most {} tapers",
                                     count, grid_.size(), grid_.cells()[0], grid_.cells()[1],
                                     grid_.size() / nodes_a_taper));
    DrumModes modes = is_long ? released_modes(grid_, step_, count, boundary / 2 / region.unit_length())
                              : drum_modes(grid_, step_, count);
    values_ = std::move(modes.values);
    eigenvalues_ = std::move(modes.eigenvalues);
}

double RegionTapers::at(std::size_t taper, const std::array<double, 2>& place) const
{
    std::array<std::size_t, 2> cell;
    std::array<double, 2> part;
    for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t cells = grid_.cells()[k];
        const double in_cells = std::clamp(place[k] / grid_.step()[k], 0.0, static_cast<double>(cells));
        cell[k] = std::min(static_cast<std::size_t>(in_cells), cells - 1);
        part[k] = in_cells - static_cast<double>(cell[k]);
    }
    double sum = 0;
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 2; ++x) {
            const std::size_t node = grid_.number(cell[0] + x, cell[1] + y);
            if (node == no_node) continue;
            sum += values_[taper][node] * (x == 0 ? 1 - part[0] : part[0]) * (y == 0 ? 1 - part[1] : part[1]);
        }
    return sum;
}

PointSet RegionTapers::nodes() const
{
    PointSet places{2, {}};
    for (std::size_t row = 0; row < grid_.rows(); ++row)
        for (std::size_t node = grid_.row_begin(row); node < grid_.row_begin(row + 1); ++node)
            places.coordinates.insert(places.coordinates.end(), {grid_.column(node) * grid_.step()[0],
                                                                 static_cast<double>(row) * grid_.step()[1]});
    return places;
}

TaperedPeriodogram::TaperedPeriodogram(std::shared_ptr<const FramedRegion> region,
                                       std::shared_ptr<const RegionTapers> tapers, int size, bool is_exact)
    : region_(std::move(region)), tapers_(std::move(tapers)), size_(size),
      fast_(is_exact ? nullptr : std::make_unique<NonuniformTransform>(size / 2)), nodes_(tapers_->nodes()),
      kept_(tapers_->count() * HalfPlane(size / 2).values.size() <= most_kept_values ? tapers_->count() : 1)
{}

TaperedPeriodogram::~TaperedPeriodogram() = default;

HalfPlane TaperedPeriodogram::weighted_sums(const PointSet& points, const std::vector<double>& weights)
{
    return region_sums(points, weights, region_->unit_length(), size_ / 2, fast_.get());
}

const HalfPlane& TaperedPeriodogram::node_sums(std::size_t taper)
{
    const bool are_all_kept = kept_.size() == tapers_->count();
    std::optional<HalfPlane>& kept = kept_[are_all_kept ? taper : 0];
    if (!kept || !are_all_kept) kept = weighted_sums(nodes_, tapers_->values(taper));
    return *kept;
}

void TaperedPeriodogram::compute(const PointSet& points, std::size_t taper, HalfSpectrum& result)
{
    std::vector<double> weights(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) weights[i] = tapers_->at(taper, {points[i][0], points[i][1]});
    const HalfPlane sums = weighted_sums(points, weights);
    const HalfPlane& pyramids = node_sums(taper);
    const auto n = static_cast<double>(points.size());
    const std::array<double, 2>& step = tapers_->step();
    fill_with_powers(result, size_, n, [&](int u, int v) {
        return sums.at(u, v) - n * pyramid_along(u, step[0]) * pyramid_along(v, step[1]) * pyramids.at(u, v);
    });
}

}
