#include "tiles/packing/packing_search.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "tiles/tilings/random_permutation.hpp"

#include <array>
#include <bit>

namespace poissonlab {
namespace {

constexpr std::size_t set_words = 4;

/// A set of at most 256 tiles, numbered in the order in which they are tried.
struct TileBits
{
    std::array<std::uint64_t, set_words> words{};

    void add(std::size_t number) { words[number / 64] |= std::uint64_t{1} << number % 64; }
    void remove(std::size_t number) { words[number / 64] &= ~(std::uint64_t{1} << number % 64); }
    TileBits& operator&=(const TileBits& other)
    {
        for (std::size_t i = 0; i < set_words; ++i) words[i] &= other.words[i];
        return *this;
    }
};

/// Backtracking in scan order: what fits to the neighbours that are there, round the torus too.
class PackingSearch
{
public:
    PackingSearch(TileKind kind, Color colors, std::vector<TileIndex> order)
        : side_(colors * colors), order_(std::move(order)), fitting_(order_.size()),
          places_(order_.size()), packing_{kind, colors, std::vector<TileIndex>(order_.size())}
    {
        for (std::size_t a = 0; a < order_.size(); ++a) {
            unused_.add(a);
            for (std::size_t b = 0; b < order_.size(); ++b) {
                if (fits_east(kind, colors, order_[a], order_[b])) fitting_[a].east.add(b), fitting_[b].west.add(a);
                if (fits_north(kind, colors, order_[a], order_[b])) fitting_[a].north.add(b), fitting_[b].south.add(a);
            }
        }
    }

    /// False once the sink has had enough.
    bool search(const PackingSink& sink, std::size_t place = 0)
    {
        if (place == order_.size()) return sink(packing_);
        if (++steps_ % 65536 == 0) stop_if_interrupted();
        const TileBits candidates = candidates_at(place);
        for (std::size_t i = 0; i < set_words; ++i)
            for (std::uint64_t left = candidates.words[i]; left != 0; left &= left - 1) {
                const auto number = 64 * i + static_cast<std::size_t>(std::countr_zero(left));
                places_[place] = number;
                packing_.tiles[place] = order_[number];
                unused_.remove(number);
                const bool goes_on = search(sink, place + 1);
                unused_.add(number);
                if (!goes_on) return false;
            }
        return true;
    }

private:
    /// The tiles that fit on each side of a tile.
    struct Fitting
    {
        TileBits east, north, west, south;
    };

    TileBits candidates_at(std::size_t place) const
    {
        const std::size_t x = place % side_, y = place / side_;
        TileBits tiles = unused_;
        if (x > 0) tiles &= fitting_[places_[place - 1]].east;
        if (y > 0) tiles &= fitting_[places_[place - side_]].north;
        if (x + 1 == side_) tiles &= fitting_[places_[place - x]].west;
        if (y + 1 == side_) tiles &= fitting_[places_[x]].south;
        return tiles;
    }

    std::size_t side_;
    std::vector<TileIndex> order_;
    std::vector<Fitting> fitting_;    ///< by number
    std::vector<std::size_t> places_; ///< the number of the tile at each place
    TilePacking packing_;
    TileBits unused_;
    std::uint64_t steps_ = 0;
};

}

void search_packings(TileKind kind, Color colors, const std::vector<TileIndex>& order, const PackingSink& sink)
{
    if (colors < 2 || colors > most_searched_colors)
        throw InputError("colors = " + std::to_string(colors) + ": must be an integer from 2 to " +
                         std::to_string(most_searched_colors) + " for a search");
    std::vector<TileIndex> tiles = order;
    if (tiles.empty())
        for (TileIndex tile = 0; tile < colors * colors * colors * colors; ++tile) tiles.push_back(tile);
    PackingSearch(kind, colors, std::move(tiles)).search(sink);
}

TilePacking random_packing(TileKind kind, Color colors, std::uint64_t seed)
{
    TilePacking found;
    const std::vector<TileIndex> order =
        random_permutation(colors * colors * colors * colors, stream_key(seed, Purpose::tile_packing, 1), 0);
    search_packings(kind, colors, order, [&](const TilePacking& packing) {
        found = packing;
        return false;
    });
    return found;
}

}
