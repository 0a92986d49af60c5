#include "base/errors/errors.hpp"
#include "base/random/random.hpp"
#include "tiles/packing/packing_board.hpp"
#include "tiles/tilings/permutation_hash.hpp"

#include <fmt/format.h>

#include <numeric>

namespace poissonlab {
namespace {

/// The tile with all colours moved on by one.
TileIndex shifted_tile(TileKind kind, TileIndex tile, Color colors)
{
    const auto next = [colors](Color color) { return (color + 1) % colors; };
    if (kind == TileKind::wang) {
        const WangTile t = wang_tile(tile, {colors, colors});
        return wang_index({next(t.north), next(t.east), next(t.south), next(t.west)}, {colors, colors});
    }
    const CornerTile t = corner_tile(tile, colors);
    return corner_index({next(t.north_east), next(t.south_east), next(t.south_west), next(t.north_west)}, colors);
}

/// Tiles in scan order: those that fit to the neighbours that are there, round the torus too. A symmetric packing is
/// searched on its first C columns, whose eastern neighbours are themselves, shifted.
class TileBoard : public PackingBoard
{
public:
    explicit TileBoard(const PackingProblem& problem)
        : problem_(problem), side_(problem.colors * problem.colors),
          width_(problem.method == PackingMethod::symmetric ? problem.colors : side_), tiles_(side_ * side_),
          order_(tiles_), shifted_(tiles_), fitting_(tiles_)
    {
        std::iota(order_.begin(), order_.end(), TileIndex{0});
        if (problem.seed)
            order_ = random_permutation(static_cast<std::uint32_t>(tiles_),
                                        stream_key(*problem.seed, Purpose::tile_packing, 1), 0);
        std::vector<std::size_t> number(tiles_);
        for (std::size_t a = 0; a < tiles_; ++a) number[order_[a]] = a;
        const auto [kind, colors] = std::pair(problem.kind, problem.colors);
        for (std::size_t a = 0; a < tiles_; ++a) {
            unused_.add(a);
            shifted_[a] = is_symmetric() ? number[shifted_tile(kind, order_[a], colors)] : a;
            for (std::size_t b = 0; b < tiles_; ++b) {
                if (fits_east(kind, colors, order_[a], order_[b])) fitting_[a].east.add(b), fitting_[b].west.add(a);
                if (fits_north(kind, colors, order_[a], order_[b])) fitting_[a].north.add(b), fitting_[b].south.add(a);
            }
        }
        if (problem.has_first_tile) put(number[0]);
        given_ = places_.size();
    }

    std::size_t steps() const override { return side_ * width_ - given_; }

    ChoiceSet choices() override
    {
        const std::size_t place = places_.size(), x = place % width_, y = place / width_;
        ChoiceSet choices = unused_;
        if (x > 0) choices.keep(fitting_[places_[place - 1]].east, tiles_);
        if (y > 0) choices.keep(fitting_[places_[place - width_]].north, tiles_);
        if (x + 1 == width_) choices.keep(fitting_[shifted_[places_[place - x]]].west, tiles_);
        if (y + 1 == side_) choices.keep(fitting_[places_[x]].south, tiles_);
        return choices;
    }

    void put(std::size_t choice) override
    {
        places_.push_back(choice);
        for_each_image(choice, [&](std::size_t tile) { unused_.remove(tile); });
    }

    void take_back() override
    {
        for_each_image(places_.back(), [&](std::size_t tile) { unused_.add(tile); });
        places_.pop_back();
    }

    TilePacking packing() const override
    {
        TilePacking packing{problem_.kind, problem_.colors, std::vector<TileIndex>(tiles_)};
        for (std::size_t place = 0; place < places_.size(); ++place) {
            std::size_t at = place / width_ * side_ + place % width_;
            for_each_image(places_[place], [&](std::size_t tile) {
                packing.tiles[at] = order_[tile];
                at += width_;
            });
        }
        return packing;
    }

private:
    /// The tiles that fit on each side of a tile.
    struct Fitting
    {
        ChoiceSet east, north, west, south;
    };

    bool is_symmetric() const { return width_ != side_; }

    /// The tile and, in a symmetric packing, those that are C, 2 C, ... places to the east.
    template <class Function>
    void for_each_image(std::size_t tile, const Function& function) const
    {
        for (std::size_t image = 0; image < side_ / width_; ++image, tile = shifted_[tile]) function(tile);
    }

    PackingProblem problem_;
    std::size_t side_;
    std::size_t width_; ///< of the columns that are searched
    std::size_t tiles_;
    std::vector<TileIndex> order_;     ///< by number: the order in which they are tried
    std::vector<std::size_t> shifted_; ///< the number of the tile with the next colours
    std::vector<Fitting> fitting_;
    std::vector<std::size_t> places_; ///< the number of the tile at each place that is filled
    std::size_t given_ = 0;
    ChoiceSet unused_;
};

}

std::unique_ptr<PackingBoard> make_tile_board(const PackingProblem& problem)
{
    return std::make_unique<TileBoard>(problem);
}

std::unique_ptr<PackingBoard> make_packing_board(const PackingProblem& problem)
{
    const Color most = most_searched_colors(problem.method);
    if (problem.colors < 2 || problem.colors > most)
        throw invalid_value({}, "colors", fmt::format("{}", problem.colors),
                            fmt::format("must be an integer from 2 to {} for a search", most));
    const bool is_of_corners = problem.kind == TileKind::corner;
    if (problem.method == PackingMethod::tiles || (problem.method == PackingMethod::symmetric && !is_of_corners))
        return make_tile_board(problem);
    if (!is_of_corners) throw InputError("pegs are for corner tiles");
    return make_peg_board(problem);
}

}
