#include "tiles/aperiodic/tiling_search.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "base/random/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace poissonlab {
namespace {

using Word = std::uint64_t;

constexpr std::size_t wrong_choices = 200; // of a trial, for each row of the rectangle

/// Sets of tiles, a bit each: for every tile those that fit to its east, west, south and north.
class FitMasks
{
public:
    explicit FitMasks(const WangList& list) : words_((list.tiles.size() + 63) / 64)
    {
        const std::size_t n = list.tiles.size();
        for (auto& side : masks_) side.resize(n * words_);
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b) {
                if (list.tiles[a].east == list.tiles[b].west) set(0, a, b), set(1, b, a);
                if (list.tiles[a].south == list.tiles[b].north) set(2, a, b), set(3, b, a);
            }
    }

    std::size_t words() const { return words_; }
    const Word* of(std::size_t side, std::size_t tile) const { return masks_[side].data() + tile * words_; }

private:
    void set(std::size_t side, std::size_t tile, std::size_t other)
    {
        masks_[side][tile * words_ + other / 64] |= Word{1} << other % 64;
    }

    std::size_t words_;
    std::array<std::vector<Word>, 4> masks_;
};

class Search
{
public:
    Search(const WangList& list, const SearchedRectangle& rectangle)
        : tiles_(list.tiles.size()), width_(rectangle.width), height_(rectangle.height), seed_(rectangle.seed),
          masks_(list), words_(masks_.words()), merged_(words_)
    {}

    enum class End
    {
        found,
        impossible,
        given_up
    };

    End run(std::uint32_t trial)
    {
        key_ = stream_key(seed_, Purpose::tiling_search, trial);
        domains_.assign(width_ * height_ * words_, 0);
        for (std::size_t cell = 0; cell < width_ * height_; ++cell)
            for (std::size_t tile = 0; tile < tiles_; ++tile) domain(cell)[tile / 64] |= Word{1} << tile % 64;
        changes_.clear();
        choices_.clear();
        for (std::size_t cell = 0; cell < width_ * height_; ++cell) waiting_.push_back(cell);
        if (!propagate()) return End::impossible;
        return choose_all();
    }

    std::vector<ListPlace> result() const
    {
        std::vector<ListPlace> places;
        for (std::size_t cell = 0; cell < width_ * height_; ++cell) places.push_back(first_of(cell));
        return places;
    }

private:
    struct Change
    {
        std::size_t word;
        Word before;
    };
    struct Choice
    {
        std::size_t cell;
        ListPlace tile;
        std::size_t changes; ///< made before it
    };

    Word* domain(std::size_t cell) { return domains_.data() + cell * words_; }
    const Word* domain(std::size_t cell) const { return domains_.data() + cell * words_; }

    std::size_t count(std::size_t cell) const
    {
        std::size_t sum = 0;
        for (std::size_t w = 0; w < words_; ++w) sum += static_cast<std::size_t>(std::popcount(domain(cell)[w]));
        return sum;
    }

    ListPlace first_of(std::size_t cell) const
    {
        for (std::size_t w = 0; w < words_; ++w)
            if (domain(cell)[w] != 0)
                return static_cast<ListPlace>(64 * w + static_cast<std::size_t>(std::countr_zero(domain(cell)[w])));
        return 0;
    }

    /// One of the cell's tiles, by chance.
    ListPlace any_of(std::size_t cell)
    {
        const auto words = philox({draws_++, 0, 0, 0}, key_);
        auto skip = static_cast<std::size_t>(std::uint64_t{words[0]} * count(cell) >> 32);
        for (std::size_t tile = 0; tile < tiles_; ++tile)
            if ((domain(cell)[tile / 64] >> tile % 64 & 1) != 0 && skip-- == 0) return static_cast<ListPlace>(tile);
        return first_of(cell);
    }

    void change(std::size_t cell, std::size_t w, Word value)
    {
        changes_.push_back({cell * words_ + w, domain(cell)[w]});
        domain(cell)[w] = value;
    }

    /// Leaves in a cell what fits beside some tile of a neighbour. False where nothing is left.
    bool restrict_cell(std::size_t cell, std::size_t neighbour, std::size_t side)
    {
        std::ranges::fill(merged_, Word{0});
        for (std::size_t w = 0; w < words_; ++w)
            for (Word rest = domain(neighbour)[w]; rest != 0; rest &= rest - 1) {
                const auto tile = 64 * w + static_cast<std::size_t>(std::countr_zero(rest));
                for (std::size_t i = 0; i < words_; ++i) merged_[i] |= masks_.of(side, tile)[i];
            }
        bool is_changed = false, is_empty = true;
        for (std::size_t w = 0; w < words_; ++w) {
            const Word left = domain(cell)[w] & merged_[w];
            if (left != domain(cell)[w]) {
                change(cell, w, left);
                is_changed = true;
            }
            is_empty &= left == 0;
        }
        if (is_changed) waiting_.push_back(cell);
        return !is_empty;
    }

    bool propagate()
    {
        while (!waiting_.empty()) {
            const std::size_t cell = waiting_.back();
            waiting_.pop_back();
            const std::size_t x = cell % width_, y = cell / width_;
            const bool fits = (x + 1 == width_ || restrict_cell(cell + 1, cell, 0)) &&
                              (x == 0 || restrict_cell(cell - 1, cell, 1)) &&
                              (y + 1 == height_ || restrict_cell(cell + width_, cell, 2)) &&
                              (y == 0 || restrict_cell(cell - width_, cell, 3));
            if (fits) continue;
            waiting_.clear();
            return false;
        }
        return true;
    }

    void undo(std::size_t changes)
    {
        while (changes_.size() > changes) {
            domains_[changes_.back().word] = changes_.back().before;
            changes_.pop_back();
        }
    }

    void keep_only(std::size_t cell, ListPlace tile)
    {
        for (std::size_t w = 0; w < words_; ++w) {
            const Word only = tile / 64 == w ? Word{1} << tile % 64 : 0;
            if (domain(cell)[w] != only) change(cell, w, only);
        }
        waiting_.push_back(cell);
    }

    /// Takes back the last choice, whose tile is then out, and those before it as far as nothing else is left. False
    /// where no choice remains.
    bool go_back()
    {
        while (!choices_.empty()) {
            const Choice last = choices_.back();
            choices_.pop_back();
            undo(last.changes);
            change(last.cell, last.tile / 64, domain(last.cell)[last.tile / 64] & ~(Word{1} << last.tile % 64));
            if (count(last.cell) == 0) continue;
            waiting_.push_back(last.cell);
            if (propagate()) return true;
        }
        return false;
    }

    /// Cells are decided row after row from the north-west.
    End choose_all()
    {
        std::size_t wrong = 0;
        for (std::size_t cell = 0; cell < width_ * height_;) {
            if (count(cell) == 1) {
                ++cell;
                continue;
            }
            const ListPlace tile = any_of(cell);
            choices_.push_back({cell, tile, changes_.size()});
            keep_only(cell, tile);
            if (propagate()) continue;
            if (wrong % 64 == 0) stop_if_interrupted();
            if (!go_back()) return End::impossible;
            if (++wrong > wrong_choices * height_) return End::given_up;
            cell = choices_.empty() ? 0 : choices_.back().cell;
        }
        return End::found;
    }

    std::size_t tiles_, width_, height_;
    std::uint64_t seed_;
    FitMasks masks_;
    std::size_t words_;
    StreamKey key_{};
    std::uint32_t draws_ = 0;
    std::vector<Word> domains_; ///< of each cell, the tiles that may be there
    std::vector<Word> merged_;
    std::vector<Change> changes_;
    std::vector<Choice> choices_;
    std::vector<std::size_t> waiting_; ///< cells whose neighbours have to be looked at
};

}

std::optional<std::vector<ListPlace>> search_tiling(const WangList& list, const SearchedRectangle& rectangle,
                                                    bool* proven, const std::function<void(std::size_t trial)>& on_step)
{
    if (list.tiles.empty() || list.tiles.size() > max_searched_tiles)
        throw InputError(
            fmt::format("{} tiles: sets of 1 to {} can be searched", list.tiles.size(), max_searched_tiles));
    if (rectangle.width < 1 || rectangle.height < 1 || rectangle.width > max_searched_cells / rectangle.height)
        throw InputError(fmt::format("{} x {} tiles: at most {} can be searched", rectangle.width, rectangle.height,
                                     max_searched_cells));
    Search search(list, rectangle);
    for (std::uint32_t trial = 0; trial < rectangle.trials; ++trial) {
        if (on_step) on_step(trial);
        const Search::End end = search.run(trial);
        if (proven != nullptr) *proven = end == Search::End::impossible;
        if (end == Search::End::found) return search.result();
        if (end == Search::End::impossible) break;
    }
    return std::nullopt;
}

}
