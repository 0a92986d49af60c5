// Searches for tile packings fill a torus step by step, by tiles or by the colours of corners.
//
// D. = Lagae, Tile-Based Methods in Computer Graphics, 2007, section 5.5.3: a tile at a time, in scan order, and an
// experiment that "places colored pegs rather than tiles". Fewest choices first: Golomb and Baumert, Backtrack
// Programming, JACM 12, 1965.
#pragma once

#include "tiles/packing/tile_packing.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>

namespace poissonlab {

enum class PackingMethod
{
    tiles,  ///< in scan order
    pegs,   ///< corner tiles: colours of lattice points in scan order; a tile that is complete must be new
    fewest, ///< corner tiles: the lattice point with the fewest colours first, also by tiles that are not complete yet
    symmetric ///< packings that a shift by C places and of all colours by one maps to themselves, so that a step
              ///< decides C places: tiles, or pegs with the fewest colours first
};

/// The packings among which a search looks.
struct PackingProblem
{
    TileKind kind = TileKind::corner;
    Color colors = 2;
    PackingMethod method = PackingMethod::tiles;
    std::optional<std::uint64_t> seed = {}; ///< of the random order in which choices are tried; none: by their numbers
    bool has_first_tile = false;            ///< tile 0 is at place (0, 0): one of the C^4 translations of each packing
};

/// The largest number of colours for which packings are searched with a method.
constexpr Color most_searched_colors(PackingMethod method) { return method == PackingMethod::symmetric ? 5 : 4; }

/// A set of at most 640 choices, which are tried in the order of their numbers.
class ChoiceSet
{
public:
    void add(std::size_t number) { words_[number / 64] |= std::uint64_t{1} << number % 64; }
    void remove(std::size_t number) { words_[number / 64] &= ~(std::uint64_t{1} << number % 64); }
    bool has(std::size_t number) const
    {
        return number < 64 * words_.size() && (words_[number / 64] >> number % 64 & 1) != 0;
    }

    /// Keeps what is in both sets. The words of larger numbers than those of `count` choices are not looked at.
    void keep(const ChoiceSet& other, std::size_t count)
    {
        for (std::size_t i = 0; 64 * i < count; ++i) words_[i] &= other.words_[i];
    }

    std::size_t size() const
    {
        std::size_t size = 0;
        for (const std::uint64_t word : words_) size += static_cast<std::size_t>(std::popcount(word));
        return size;
    }

    /// Removes the first choice and returns it; `none` where there is none.
    static constexpr std::size_t none = ~std::size_t{0};
    std::size_t take_first()
    {
        for (std::size_t i = 0; i < words_.size(); ++i)
            if (words_[i] != 0) {
                const auto bit = static_cast<std::size_t>(std::countr_zero(words_[i]));
                words_[i] &= words_[i] - 1;
                return 64 * i + bit;
            }
        return none;
    }

    /// Removes all choices before one.
    void remove_before(std::size_t number)
    {
        for (std::size_t i = 0; i < number / 64; ++i) words_[i] = 0;
        words_[number / 64] &= ~std::uint64_t{0} << number % 64;
    }

private:
    std::array<std::uint64_t, 10> words_{};
};

/// A torus that is filled step by step. The same choices lead to the same state, in whatever order others were tried.
class PackingBoard
{
public:
    virtual ~PackingBoard() = default;

    /// The number of steps that fill the torus.
    virtual std::size_t steps() const = 0;

    /// Returns the choices of the next step; the torus must not be full.
    virtual ChoiceSet choices() = 0;

    /// Makes the next step: one of choices(), which was called after the steps that are made.
    virtual void put(std::size_t choice) = 0;

    /// Takes the last step back.
    virtual void take_back() = 0;

    /// The tiles of a full torus.
    virtual TilePacking packing() const = 0;
};

/// An empty torus. Throws InputError for methods that the kind has not, and for numbers of colours that are not
/// searched.
std::unique_ptr<PackingBoard> make_packing_board(const PackingProblem& problem);

/// These make the boards that place tiles and pegs.
std::unique_ptr<PackingBoard> make_tile_board(const PackingProblem& problem);
std::unique_ptr<PackingBoard> make_peg_board(const PackingProblem& problem);

}
