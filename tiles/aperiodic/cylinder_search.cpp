#include "tiles/aperiodic/cylinder_search.hpp"

#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::uint32_t no_row = std::numeric_limits<std::uint32_t>::max();

/// The short cycle that is shown is searched from no more words than this: any cycle is a period.
constexpr std::size_t most_cycle_starts = 1024;

/// The rows below each word.
struct RowsBelow
{
    std::vector<std::size_t> begins; ///< of each word's rows, and the end
    std::vector<std::uint32_t> rows;

    explicit RowsBelow(const RowGraph& graph) : begins(graph.words.size() + 1), rows(graph.rows())
    {
        for (const std::uint32_t word : graph.north) ++begins[word + 1];
        std::partial_sum(begins.begin(), begins.end(), begins.begin());
        std::vector<std::size_t> ends(begins);
        for (std::uint32_t row = 0; row < rows.size(); ++row) rows[ends[graph.north[row]]++] = row;
    }

    std::span<const std::uint32_t> of(std::uint32_t word) const
    {
        return std::span(rows).subspan(begins[word], begins[word + 1] - begins[word]);
    }
};

/// The heights of stacks above each word, and how many rows above each word are left in stacks without a top: none,
/// where there is no cycle.
struct Stacks
{
    std::vector<std::size_t> heights;
    std::vector<std::size_t> left;
};

Stacks stacks_of(const RowGraph& graph, const RowsBelow& below)
{
    Stacks stacks{std::vector<std::size_t>(graph.words.size()), std::vector<std::size_t>(graph.words.size())};
    for (const std::uint32_t word : graph.south) ++stacks.left[word];
    std::vector<std::uint32_t> tops;
    for (std::uint32_t word = 0; word < graph.words.size(); ++word)
        if (stacks.left[word] == 0) tops.push_back(word);
    while (!tops.empty()) {
        const std::uint32_t word = tops.back();
        tops.pop_back();
        for (const std::uint32_t row : below.of(word)) {
            const std::uint32_t next = graph.south[row];
            stacks.heights[next] = std::max(stacks.heights[next], stacks.heights[word] + 1);
            if (--stacks.left[next] == 0) tops.push_back(next);
        }
    }
    return stacks;
}

/// The rows of the shortest cycle through a word, if it has fewer than `fewer`.
std::vector<std::uint32_t> cycle_through(const RowGraph& graph, const RowsBelow& below, std::uint32_t start,
                                         std::size_t fewer)
{
    std::vector<std::uint32_t> row_to(graph.words.size(), no_row);
    std::vector<std::uint32_t> words{start};
    for (std::size_t length = 1; length < fewer && !words.empty(); ++length) {
        std::vector<std::uint32_t> next_words;
        for (const std::uint32_t word : words)
            for (const std::uint32_t row : below.of(word)) {
                const std::uint32_t next = graph.south[row];
                if (row_to[next] != no_row) continue;
                row_to[next] = row;
                if (next != start) {
                    next_words.push_back(next);
                    continue;
                }
                std::vector<std::uint32_t> cycle{row};
                while (graph.north[cycle.back()] != start) cycle.push_back(row_to[graph.north[cycle.back()]]);
                std::ranges::reverse(cycle);
                return cycle;
            }
        words = std::move(next_words);
    }
    return {};
}

std::vector<std::uint32_t> short_cycle(const RowGraph& graph, const RowsBelow& below, const Stacks& stacks)
{
    std::vector<std::uint32_t> shortest;
    std::size_t starts = 0;
    for (std::uint32_t word = 0; word < graph.words.size(); ++word) {
        if (stacks.left[word] == 0) continue;
        if (!shortest.empty() && ++starts > most_cycle_starts) break;
        stop_if_interrupted();
        auto cycle = cycle_through(graph, below, word, shortest.empty() ? graph.words.size() + 1 : shortest.size());
        if (!cycle.empty()) shortest = std::move(cycle);
    }
    return shortest;
}

/// Finds a closed row between two words, the lower one of which may be rotated.
class RowBetween
{
public:
    RowBetween(const WangList& list, std::size_t width) : list_(list), find_(list), width_(width) {}

    /// `is_wanted` is given the word on the south of a row.
    std::vector<ListPlace> below(const std::vector<Color>& north,
                                 const std::function<bool(const std::vector<Color>&)>& is_wanted)
    {
        row_.clear();
        for (const ListPlace place : find_.with_north(north[0])) {
            row_ = {place};
            if (extend(north, is_wanted)) return row_;
        }
        return {};
    }

    std::vector<Color> south(const std::vector<ListPlace>& row) const
    {
        std::vector<Color> word;
        for (const ListPlace place : row) word.push_back(list_.tiles[place].south);
        return word;
    }

private:
    bool extend(const std::vector<Color>& north, const std::function<bool(const std::vector<Color>&)>& is_wanted)
    {
        const Color east = list_.tiles[row_.back()].east;
        if (row_.size() == width_) return east == list_.tiles[row_[0]].west && is_wanted(south(row_));
        for (const ListPlace place : find_.with_north_and_west(north[row_.size()], east)) {
            row_.push_back(place);
            if (extend(north, is_wanted)) return true;
            row_.pop_back();
        }
        return false;
    }

    const WangList& list_;
    TilesByColor find_;
    std::size_t width_;
    std::vector<ListPlace> row_;
};

/// True where b is a, begun at another place.
bool is_rotation(const std::vector<Color>& a, const std::vector<Color>& b, std::size_t places)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        if (b[(i + places) % a.size()] != a[i]) return false;
    return true;
}

/// The number of places to the east at which a word begins again in another one; its length where it does not.
std::size_t rotation_of(const std::vector<Color>& a, const std::vector<Color>& b)
{
    std::size_t places = 0;
    while (places < a.size() && !is_rotation(a, b, places)) ++places;
    return places;
}

/// The rows of a cycle of words, each rotated to fit below the one before. `list` has the rows along its horizontal
/// axis; the result lies along `axis`.
PeriodicTiling tiling_of(const WangList& list, const RowGraph& graph, const std::vector<std::uint32_t>& cycle,
                         std::size_t width, CylinderAxis axis)
{
    const auto word = [&](std::uint32_t place) {
        return colors_of_word(graph.words[place], width, list.colors.horizontal);
    };
    RowBetween find(list, width);
    const std::vector<Color> top = word(graph.north[cycle.front()]);
    std::vector<Color> north = top;
    std::vector<std::vector<ListPlace>> rows;
    for (const std::uint32_t edge : cycle) {
        const std::vector<Color> south = word(graph.south[edge]);
        rows.push_back(find.below(north, [&](const auto& found) { return rotation_of(south, found) < width; }));
        north = find.south(rows.back());
    }
    PeriodicTiling tiling{axis, width, rows.size(), rotation_of(top, north), {}};
    const bool is_horizontal = axis == CylinderAxis::horizontal;
    if (!is_horizontal) std::swap(tiling.width, tiling.height);
    for (std::size_t y = 0; y < tiling.height; ++y)
        for (std::size_t x = 0; x < tiling.width; ++x) tiling.tiles.push_back(is_horizontal ? rows[y][x] : rows[x][y]);
    return tiling;
}

}

Cylinder longest_cylinder(const WangList& list, std::size_t circumference, CylinderAxis axis)
{
    const WangList turned = axis == CylinderAxis::horizontal ? list : transposed(list);
    const RowGraph graph = closed_rows(turned, circumference);
    const RowsBelow below(graph);
    const Stacks stacks = stacks_of(graph, below);
    if (std::ranges::any_of(stacks.left, [](std::size_t rows) { return rows > 0; }))
        return {0, tiling_of(turned, graph, short_cycle(graph, below, stacks), circumference, axis)};
    return {stacks.heights.empty() ? 0 : std::ranges::max(stacks.heights)};
}

namespace {

/// Adds the height of the next circumference of an axis, or the first period. Says whether heights go on.
bool add_height(const WangList& list, std::size_t circumference, CylinderAxis axis, PeriodSearch& search)
{
    Cylinder cylinder = longest_cylinder(list, circumference, axis);
    if (!cylinder.period) {
        (axis == CylinderAxis::horizontal ? search.horizontal_heights : search.vertical_heights)
            .push_back(cylinder.height);
        return true;
    }
    if (!search.period) search.period = std::move(cylinder.period);
    return false;
}

}

PeriodSearch search_periods(const WangList& list, std::size_t widest,
                            const std::function<void(const PeriodSearch& search)>& on_step)
{
    PeriodSearch search;
    bool rows_go_on = true, columns_go_on = true;
    for (std::size_t circumference = 1; circumference <= widest && (rows_go_on || columns_go_on); ++circumference) {
        if (rows_go_on) rows_go_on = add_height(list, circumference, CylinderAxis::horizontal, search);
        if (columns_go_on) columns_go_on = add_height(list, circumference, CylinderAxis::vertical, search);
        if (on_step) on_step(search);
    }
    return search;
}

}
