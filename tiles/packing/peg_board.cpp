#include "base/random/random_words.hpp"
#include "tiles/packing/packing_board.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace poissonlab {
namespace {

/// A lattice point as a corner of a tile.
struct Corner
{
    std::size_t tile = 0;
    unsigned number = 0; ///< south-west, south-east, north-west, north-east
    Color shift = 0;     ///< of its colour, east of the columns that are searched
};

/// Colours of lattice points, and how often each pattern of colours is in the corners of tiles. A pattern says the
/// colours of one to four of the corners of a tile: one of k corners is in C^(4 - k) tiles of the complete set, and may
/// be in no more of the torus. With four corners this says that a tile is there once; with three, that a tile is left
/// for a hole. A pattern is a number of four digits: a colour and one, or zero. Those of symmetric packings are counted
/// up to a shift of their colours.
class PegBoard : public PackingBoard
{
public:
    explicit PegBoard(const PackingProblem& problem)
        : colors_(problem.colors), looks_ahead_(problem.method != PackingMethod::pegs),
          side_(std::size_t{colors_} * colors_), width_(problem.method == PackingMethod::symmetric ? colors_ : side_),
          color_(side_ * width_, none), next_(side_ * width_), corners_(side_ * width_), order_(side_ * width_),
          sum_(side_ * width_), value_(side_ * width_)
    {
        for (unsigned corner = 1; corner < 4; ++corner) digit_[corner] = digit_[corner - 1] * (colors_ + 1);
        name_corners();
        name_patterns();
        RandomWords words(stream_key(problem.seed.value_or(0), Purpose::tile_packing, 2), 0);
        for (std::vector<Color>& order : order_) {
            order.resize(colors_);
            std::iota(order.begin(), order.end(), Color{0});
            for (Color left = problem.seed ? colors_ : 0; left > 1; --left)
                std::swap(order[left - 1], order[words.below(left)]);
        }
        if (problem.has_first_tile)
            for (const std::size_t peg : {std::size_t{0}, std::size_t{1}, width_, width_ + 1}) place(peg, 0);
        given_ = placed_.size();
    }

    std::size_t steps() const override { return color_.size() - given_; }

    ChoiceSet choices() override
    {
        const std::size_t peg = looks_ahead_ ? peg_with_fewest_colors() : first_free_peg();
        next_[placed_.size()] = peg;
        ChoiceSet choices;
        for (Color number = 0; number < colors_; ++number) {
            if (!allows(peg, order_[peg][number])) continue;
            if (place(peg, order_[peg][number])) choices.add(number);
            remove_last();
        }
        return choices;
    }

    void put(std::size_t choice) override
    {
        const std::size_t peg = next_[placed_.size()];
        place(peg, order_[peg][choice]);
    }

    void take_back() override { remove_last(); }

    TilePacking packing() const override
    {
        std::vector<Color> corners;
        for (std::size_t y = 0; y < side_; ++y)
            for (std::size_t x = 0; x < side_; ++x)
                corners.push_back((color_[y * width_ + x % width_] + static_cast<Color>(x / width_)) % colors_);
        return packing_of_corner_colors(colors_, corners);
    }

private:
    static constexpr Color none = ~Color{0};

    void name_corners()
    {
        for (std::size_t y = 0; y < side_; ++y)
            for (std::size_t x = 0; x < width_; ++x)
                for (unsigned number = 0; number < 4; ++number) {
                    const std::size_t east = x + number % 2, north = (y + number / 2) % side_;
                    const Color shift = width_ < side_ && east == width_ ? 1 : 0;
                    corners_[north * width_ + east % width_][number] = {y * width_ + x, number, shift};
                }
    }

    /// Finds the class and the largest number of each pattern.
    void name_patterns()
    {
        const std::size_t patterns = digit_[3] * (colors_ + 1);
        count_.resize(patterns);
        for (std::size_t pattern = 0; pattern < patterns; ++pattern) {
            std::size_t same = 0;
            Color first = 0;
            std::uint32_t most = colors_ * colors_ * colors_ * colors_;
            for (unsigned corner = 0; corner < 4; ++corner) {
                const auto digit = static_cast<Color>(pattern / digit_[corner] % (colors_ + 1));
                if (digit == 0) continue;
                if (first == 0) first = width_ < side_ ? digit : 1;
                same += digit_[corner] * ((digit + colors_ - first) % colors_ + 1);
                most /= colors_;
            }
            class_.push_back(same);
            most_.push_back(most);
        }
    }

    std::size_t value(const Corner& corner, Color color) const
    {
        return digit_[corner.number] * ((color + corner.shift) % colors_ + 1);
    }

    /// Calls function(class of a pattern) for all patterns that have a peg as a corner, once for each tile.
    template <class Function>
    void for_each_pattern_of(std::size_t peg, const Function& function) const
    {
        for (const Corner& corner : corners_[peg]) {
            const std::array<std::size_t, 4>& values = value_[corner.tile];
            const std::size_t all = sum_[corner.tile];
            if (most_[all] == 1) function(class_[all]);
            if (!looks_ahead_) continue;
            std::array<std::size_t, 8> sums{values[corner.number]};
            std::size_t count = 1;
            for (unsigned other = 0; other < 4; ++other)
                if (other != corner.number && values[other] != 0)
                    for (std::size_t i = count; i-- > 0;) sums[count++] = sums[i] + values[other];
            for (std::size_t i = 0; i < count; ++i)
                if (most_[sums[i]] != 1) function(class_[sums[i]]);
        }
    }

    /// False if a pattern is now there too often.
    bool place(std::size_t peg, Color color)
    {
        color_[peg] = color;
        placed_.push_back(peg);
        for (const Corner& corner : corners_[peg]) {
            const std::size_t value = this->value(corner, color);
            value_[corner.tile][corner.number] = value;
            sum_[corner.tile] += value;
        }
        bool fits = true;
        for_each_pattern_of(peg, [&](std::size_t pattern) { fits &= ++count_[pattern] <= most_[pattern]; });
        return fits;
    }

    void remove_last()
    {
        const std::size_t peg = placed_.back();
        for_each_pattern_of(peg, [&](std::size_t pattern) { --count_[pattern]; });
        for (const Corner& corner : corners_[peg])
            sum_[corner.tile] -= std::exchange(value_[corner.tile][corner.number], std::size_t{0});
        color_[peg] = none;
        placed_.pop_back();
    }

    /// False if a tile around a lattice point could not be there with this colour.
    bool allows(std::size_t peg, Color color) const
    {
        return std::ranges::all_of(corners_[peg], [&](const Corner& corner) {
            const std::size_t pattern = class_[sum_[corner.tile] + value(corner, color)];
            return count_[pattern] < most_[pattern];
        });
    }

    std::size_t first_free_peg() const
    {
        return static_cast<std::size_t>(std::ranges::find(color_, none) - color_.begin());
    }

    /// The first in scan order of those beside others; the first free one, if there are none.
    std::size_t peg_with_fewest_colors() const
    {
        std::size_t best = color_.size(), fewest = colors_ + std::size_t{1};
        for (std::size_t peg = 0; peg < color_.size() && fewest > 1; ++peg) {
            const auto is_known = [&](const Corner& corner) { return sum_[corner.tile] != 0; };
            if (color_[peg] != none || std::ranges::none_of(corners_[peg], is_known)) continue;
            std::size_t left = 0;
            for (Color color = 0; color < colors_; ++color) left += allows(peg, color);
            if (left < fewest) best = peg, fewest = left;
        }
        return best == color_.size() ? first_free_peg() : best;
    }

    Color colors_;
    bool looks_ahead_;
    std::size_t side_;
    std::size_t width_;        ///< of the columns that are searched
    std::vector<Color> color_; ///< of each lattice point, rows from south to north
    std::vector<std::size_t> placed_;
    std::vector<std::size_t> next_;              ///< the lattice point of each step on the way
    std::vector<std::array<Corner, 4>> corners_; ///< of the four tiles around each lattice point
    std::vector<std::vector<Color>> order_;      ///< in which colours are tried
    std::size_t given_ = 0;
    std::array<std::size_t, 4> digit_{1};
    std::vector<std::size_t> sum_;                  ///< the pattern of the corners that each tile has
    std::vector<std::array<std::size_t, 4>> value_; ///< of each corner in it
    std::vector<std::size_t> class_;                ///< the pattern that stands for each
    std::vector<std::uint32_t> most_;               ///< tiles with the pattern
    std::vector<std::uint32_t> count_;              ///< tiles of the torus, by the pattern that stands for theirs
};

}

std::unique_ptr<PackingBoard> make_peg_board(const PackingProblem& problem)
{
    return std::make_unique<PegBoard>(problem);
}

}
