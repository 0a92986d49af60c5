#include "analysis/regions/region_tapers.hpp"

#include "analysis/regions/drum_modes.hpp"
#include "analysis/regions/region_transform.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

/// Cells of the grid along the longer side of the box, and along the shorter at least.
constexpr double taper_cells = 128;
constexpr double fewest_taper_cells = 32;

/// A boundary on a line of the grid crosses no cell, where rounding moves it by less than this part of one.
constexpr double rounded_part = 1e-6;

/// Nodes in excess of tapers that are needed, so that each taper has a form.
constexpr std::size_t nodes_a_taper = 16;

/// Values of sums over nodes that are kept, of 16 bytes each: a GiB. Where there are more, they are summed anew.
constexpr std::size_t most_kept_values = std::size_t{1} << 26;

/// Marks the cells whose inside an edge goes through; it is in units of cells.
void mark_edge(std::array<double, 2> from, std::array<double, 2> to, const std::array<std::size_t, 2>& cells,
               std::vector<char>& is_crossed)
{
    if (from[1] > to[1]) std::swap(from, to);
    const auto first = static_cast<std::size_t>(std::clamp(from[1], 0.0, static_cast<double>(cells[1] - 1)));
    for (std::size_t row = first; row < cells[1] && static_cast<double>(row) + rounded_part < to[1]; ++row) {
        const double low = std::max(from[1], static_cast<double>(row) + rounded_part);
        const double high = std::min(to[1], static_cast<double>(row + 1) - rounded_part);
        if (low > high) continue;
        const double slope = to[1] > from[1] ? (to[0] - from[0]) / (to[1] - from[1]) : 0;
        const bool is_level = to[1] == from[1];
        const double a = is_level ? from[0] : from[0] + slope * (low - from[1]);
        const double b = is_level ? to[0] : from[0] + slope * (high - from[1]);
        const double left = std::min(a, b), right = std::max(a, b);
        for (auto column = static_cast<std::size_t>(std::clamp(left, 0.0, static_cast<double>(cells[0] - 1)));
             column < cells[0] && static_cast<double>(column) + rounded_part < right; ++column)
            if (static_cast<double>(column + 1) - rounded_part > left) is_crossed[row * cells[0] + column] = 1;
    }
}

double sinc_of(double t) { return std::abs(t) < 1e-8 ? 1 : std::sin(std::numbers::pi * t) / (std::numbers::pi * t); }

/// The transform of a pyramid, along one axis.
double pyramid_along(double frequency, double step)
{
    const double s = sinc_of(frequency * step);
    return step * s * s;
}

}

/// The grid's nodes that have cells within the region on all sides.
void RegionTapers::find_nodes(const FramedRegion& region)
{
    const RegionBox box = box_of(region.polygons());
    const double longest = box.longest();
    for (std::size_t k = 0; k < 2; ++k) {
        const double side = box.high[k] - box.low[k];
        cells_[k] = static_cast<std::size_t>(std::max(fewest_taper_cells, std::round(taper_cells * side / longest)));
        frame_step_[k] = side / static_cast<double>(cells_[k]);
        step_[k] = frame_step_[k] / region.unit_length();
    }
    std::vector<char> is_out(cells_[0] * cells_[1]);
    const auto in_cells = [&](const std::array<double, 2>& p) {
        return std::array{p[0] / frame_step_[0], p[1] / frame_step_[1]};
    };
    for (const RegionEdge& e : region.boundary().edges()) mark_edge(in_cells(e.from), in_cells(e.to), cells_, is_out);
    for (std::size_t row = 0; row < cells_[1]; ++row)
        for (std::size_t column = 0; column < cells_[0]; ++column)
            if (!region.contains({(static_cast<double>(column) + 0.5) * frame_step_[0],
                                  (static_cast<double>(row) + 0.5) * frame_step_[1]}))
                is_out[row * cells_[0] + column] = 1;
    const std::size_t columns = cells_[0] + 1;
    number_.assign(columns * (cells_[1] + 1), no_node);
    for (std::size_t row = 1; row < cells_[1]; ++row)
        for (std::size_t column = 1; column < cells_[0]; ++column) {
            const std::size_t above = row * cells_[0] + column, below = above - cells_[0];
            if (is_out[above] || is_out[above - 1] || is_out[below] || is_out[below - 1]) continue;
            number_[row * columns + column] = nodes_.size();
            nodes_.push_back(row * columns + column);
        }
}

RegionTapers::RegionTapers(const FramedRegion& region, std::size_t count)
{
    find_nodes(region);
    if (nodes_.size() < nodes_a_taper * count)
        throw InputError(fmt::format("the region is too thin for {} tapers: {} nodes of a grid of {} x {} squares over "
                                     "it have all squares around them inside; at most {} tapers",
                                     count, nodes_.size(), cells_[0], cells_[1], nodes_.size() / nodes_a_taper));
    DrumModes modes = drum_modes(number_, cells_[0] + 1, step_, count);
    values_ = std::move(modes.values);
    eigenvalues_ = std::move(modes.eigenvalues);
}

double RegionTapers::at(std::size_t taper, const std::array<double, 2>& place) const
{
    std::array<std::size_t, 2> cell;
    std::array<double, 2> part;
    for (std::size_t k = 0; k < 2; ++k) {
        const double in_cells = std::clamp(place[k] / frame_step_[k], 0.0, static_cast<double>(cells_[k]));
        cell[k] = std::min(static_cast<std::size_t>(in_cells), cells_[k] - 1);
        part[k] = in_cells - static_cast<double>(cell[k]);
    }
    double sum = 0;
    for (std::size_t y = 0; y < 2; ++y)
        for (std::size_t x = 0; x < 2; ++x) {
            const std::size_t node = number_[(cell[1] + y) * (cells_[0] + 1) + cell[0] + x];
            if (node == no_node) continue;
            sum += values_[taper][node] * (x == 0 ? 1 - part[0] : part[0]) * (y == 0 ? 1 - part[1] : part[1]);
        }
    return sum;
}

PointSet RegionTapers::nodes() const
{
    PointSet places{2, {}};
    const std::size_t columns = cells_[0] + 1;
    for (const std::size_t node : nodes_) {
        places.coordinates.push_back(static_cast<double>(node % columns) * frame_step_[0]);
        places.coordinates.push_back(static_cast<double>(node / columns) * frame_step_[1]);
    }
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
