#include "tiles/aperiodic/cylinder_search.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace poissonlab {
namespace {

struct WordHash
{
    std::size_t operator()(WordNumber word) const
    {
        constexpr std::uint64_t odd = 0x9e3779b97f4a7c15; // 2^64 over the golden ratio
        const std::uint64_t mixed =
            (static_cast<std::uint64_t>(word) ^ static_cast<std::uint64_t>(word >> 64) * odd) * odd;
        return mixed ^ mixed >> 32;
    }
};

/// The number of a word that begins at one of its places and goes around.
WordNumber number_of_word(const std::vector<Color>& word, std::size_t first, Color colors)
{
    WordNumber number = 0;
    const auto append = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = end; i-- > begin;) number = number * colors + word[i];
    };
    append(0, first);
    append(first, word.size());
    return number;
}

/// The index at which the smallest rotation of a word begins. Two places are compared at a time; the one that is larger
/// at the k-th colour is out, and so are the k places after it (Shiloach, Fast canonization of circular strings, 1981).
std::size_t smallest_rotation(const std::vector<Color>& word)
{
    const std::size_t n = word.size();
    const auto wrapped = [&](std::size_t place) { return place < n ? place : place - n; };
    std::size_t i = 0, j = 1, k = 0;
    while (i < n && j < n && k < n) {
        const Color a = word[wrapped(i + k)];
        const Color b = word[wrapped(j + k)];
        if (a == b) {
            ++k;
            continue;
        }
        (a > b ? i : j) += k + 1;
        if (i == j) ++j;
        k = 0;
    }
    return std::min(i, j);
}

/// The rows of a graph while they are found.
class RowCollector
{
public:
    RowCollector(const WangList& list, std::size_t width) : list_(list), width_(width), word_(width)
    {
        const double bits = std::log2(list.colors.horizontal + 1.0) * static_cast<double>(width);
        if (bits > 128)
            throw InputError(fmt::format("words of {} colours, {} long, are too many", list.colors.horizontal, width));
    }

    void add(const std::vector<ListPlace>& row)
    {
        if (graph_.rows() == max_graph_rows)
            throw InputError(fmt::format("there are more than {} rows of {} tiles", max_graph_rows, width_));
        if (graph_.rows() % 4096 == 0) stop_if_interrupted();
        graph_.north.push_back(word(row, &WangTile::north));
        graph_.south.push_back(word(row, &WangTile::south));
    }

    RowGraph graph() { return std::move(graph_); }

private:
    std::uint32_t word(const std::vector<ListPlace>& row, Color WangTile::*edge)
    {
        for (std::size_t i = 0; i < width_; ++i) word_[i] = list_.tiles[row[i]].*edge;
        const Color colors = list_.colors.horizontal;
        const WordNumber number = number_of_word(word_, smallest_rotation(word_), colors);
        const auto [found, is_new] = places_.try_emplace(number, static_cast<std::uint32_t>(graph_.words.size()));
        if (is_new) graph_.words.push_back(number);
        return found->second;
    }

    const WangList& list_;
    std::size_t width_;
    std::vector<Color> word_;
    std::unordered_map<WordNumber, std::uint32_t, WordHash> places_;
    RowGraph graph_;
};

/// Finds each closed row once among its rotations, as the smallest one: a necklace. What can become one is made from
/// west to east (Fredricksen, Kessler and Maiorana; Ruskey, Savage and Wang, Generating necklaces, 1992): no tile is
/// smaller than the one `period` before it.
class NecklaceFinder
{
public:
    NecklaceFinder(const WangList& list, std::size_t width) : list_(list), find_(list), width_(width) {}

    void find(RowCollector& rows)
    {
        for (ListPlace first = 0; first < list_.tiles.size(); ++first) {
            const Color west = list_.tiles[first].west;
            if (reach_.empty() || reach_to_ != west) find_reach(west);
            row_ = {first};
            extend(rows, 1);
        }
    }

private:
    /// Finds the vertical colours from which rows of each number of tiles lead to `end`.
    void find_reach(Color end)
    {
        reach_to_ = end;
        reach_.assign(width_, std::vector<bool>(list_.colors.vertical));
        reach_[0][end] = true;
        for (std::size_t tiles = 1; tiles < width_; ++tiles)
            for (const WangTile& tile : list_.tiles)
                if (reach_[tiles - 1][tile.east]) reach_[tiles][tile.west] = true;
    }

    void extend(RowCollector& rows, std::size_t period)
    {
        const Color east = list_.tiles[row_.back()].east;
        if (!reach_[width_ - row_.size()][east]) return;
        if (row_.size() == width_) {
            if (width_ % period == 0) rows.add(row_);
            return;
        }
        const ListPlace smallest = row_[row_.size() - period];
        const auto places = find_.with_west(east);
        for (auto place = std::ranges::lower_bound(places, smallest); place != places.end(); ++place) {
            row_.push_back(*place);
            extend(rows, *place == smallest ? period : row_.size());
            row_.pop_back();
        }
    }

    const WangList& list_;
    TilesByColor find_;
    std::size_t width_;
    Color reach_to_ = 0;
    std::vector<std::vector<bool>> reach_;
    std::vector<ListPlace> row_;
};

}

std::vector<Color> colors_of_word(WordNumber word, std::size_t width, Color colors)
{
    std::vector<Color> result(width);
    for (Color& color : result) {
        color = static_cast<Color>(word % colors);
        word /= colors;
    }
    return result;
}

RowGraph closed_rows(const WangList& list, std::size_t width)
{
    RowCollector rows(list, width);
    NecklaceFinder(list, width).find(rows);
    return rows.graph();
}

}
