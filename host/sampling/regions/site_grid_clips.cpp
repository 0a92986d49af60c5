// The edges that end a region around the cells of a SiteGrid: the cells of sites are cut a little beyond them.
#include "host/sampling/regions/site_grid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Cells with more edges around them get no clips: looking for them would take too long.
constexpr std::size_t most_edges_for_clips = 32;
constexpr std::size_t most_entries_for_clips = 4096; ///< of edges in cells
constexpr std::uint32_t most_rows_for_clips = 256;

/// Two edges count as parallel when the cosine of the angle between them is larger than this.
constexpr double alike_edges = 0.7;

/// Rounding moves corners by less than this, in positions.
constexpr double clip_slack = 4;

}

std::span<const std::uint32_t> SiteGrid::clips_around(const TorusPoint<2>& position) const
{
    if (grid_.is_listed == 0) return {};
    using contract::region_lloyd::MAX_CLIPS;
    const std::size_t cell = number_of_cell(position[1] >> grid_.shift, position[0] >> grid_.shift);
    const auto clips = std::span(clips_).subspan(cell * MAX_CLIPS, MAX_CLIPS);
    return clips.first(static_cast<std::size_t>(
        std::ranges::find(clips, std::uint32_t{contract::region_lloyd::NO_CLIP}) - clips.begin()));
}

void SiteGrid::find_clips()
{
    clip_reach_ = grid_.half_box;
    clips_.assign(clip_words(), contract::region_lloyd::NO_CLIP);
    tbb::parallel_for(std::uint32_t{0}, grid_.rows, [&](std::uint32_t row) {
        for (std::size_t cell = number_of_cell(row, 0); cell < number_of_cell(row, grid_.columns); ++cell)
            find_clips_of(row, cell);
    });
}

/// Finds the clips of a cell. Edges are left out that point in about the direction of an earlier one.
void SiteGrid::find_clips_of(std::uint32_t row, std::size_t cell)
{
    const double width = 1u << grid_.shift, x = column_of(cell, row) * width, y = row * width;
    const std::array<double, 2> low{x - clip_reach_, y - clip_reach_};
    const std::array<double, 2> high{x + width + clip_reach_, y + width + clip_reach_};
    const auto cell_along = [&](double position, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(std::floor(position / width), 0.0, count - 1.0));
    };
    const std::uint32_t first_row = cell_along(low[1], grid_.rows), last_row = cell_along(high[1], grid_.rows);
    if (last_row - first_row > most_rows_for_clips) return;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t r = first_row; r <= last_row && numbers.size() <= most_entries_for_clips; ++r) {
        const std::size_t first = number_of_cell(r, cell_along(low[0], grid_.columns));
        const std::size_t end = number_of_cell(r, cell_along(high[0], grid_.columns) + 1);
        numbers.insert(numbers.end(), edge_numbers_.begin() + edge_starts_[first],
                       edge_numbers_.begin() + edge_starts_[end]);
    }
    if (numbers.size() > most_entries_for_clips) return;
    std::ranges::sort(numbers);
    numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
    if (numbers.size() > most_edges_for_clips) return;
    std::vector<FixedEdge> edges;
    for (const std::uint32_t number : numbers) edges.push_back(edges_[number]);
    std::uint32_t* next = &clips_[cell * contract::region_lloyd::MAX_CLIPS];
    std::vector<std::array<double, 2>> directions;
    for (std::size_t i = 0; i < edges.size() && directions.size() < contract::region_lloyd::MAX_CLIPS; ++i) {
        const FixedEdge& e = edges[i];
        const double dx = double{1} * e[2] - e[0], dy = double{1} * e[3] - e[1], length = std::hypot(dx, dy);
        const std::array direction{dx / length, dy / length};
        const auto is_alike = [&](const auto& d) { return d[0] * direction[0] + d[1] * direction[1] > alike_edges; };
        if (std::ranges::any_of(directions, is_alike) || !ends_region(e, edges, low, high)) continue;
        directions.push_back(direction);
        *next++ = numbers[i];
    }
}

/// Is the part of the region in the box on the left of the edge's line, or only a little beyond it? It is enough to
/// test the corners of the box and the ends of the edges' parts in it.
bool SiteGrid::ends_region(const FixedEdge& edge, std::span<const FixedEdge> edges, const std::array<double, 2>& low,
                           const std::array<double, 2>& high) const
{
    const double dx = double{1} * edge[2] - edge[0], dy = double{1} * edge[3] - edge[1];
    const double most = (contract::region_lloyd::CLIP_PART * (1u << grid_.shift) - clip_slack) * std::hypot(dx, dy);
    const auto is_beyond = [&](double x, double y) { return dy * (x - edge[0]) - dx * (y - edge[1]) > most; };
    for (const FixedEdge& e : edges) {
        const std::array<double, 2> from{double{1} * e[0], double{1} * e[1]};
        const std::array<double, 2> along{double{1} * e[2] - e[0], double{1} * e[3] - e[1]};
        double first = 0, last = 1;
        for (std::size_t k = 0; k < 2; ++k) {
            if (along[k] == 0) {
                if (from[k] < low[k] || from[k] > high[k]) last = -1;
                continue;
            }
            const double a = (low[k] - from[k]) / along[k], b = (high[k] - from[k]) / along[k];
            first = std::max(first, std::min(a, b));
            last = std::min(last, std::max(a, b));
        }
        if (first > last) continue;
        for (const double t : {first, last})
            if (is_beyond(from[0] + t * along[0], from[1] + t * along[1])) return false;
    }
    for (const double x : {low[0], high[0]})
        for (const double y : {low[1], high[1]}) {
            const double at_x = x + grid_.low_x, at_y = y + grid_.low_y;
            if (!is_beyond(x, y) || at_x < 0 || at_y < 0 || at_x >= 0x1p31 || at_y >= 0x1p31) continue;
            if (region_.contains({static_cast<std::uint32_t>(at_x), static_cast<std::uint32_t>(at_y)})) return false;
        }
    return true;
}

}
