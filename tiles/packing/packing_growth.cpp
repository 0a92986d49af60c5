// A packing over three colours around one over two, by annealing at a fixed temperature.
#include "base/programs/interrupt.hpp"
#include "base/random/random_words.hpp"
#include "tiles/packing/packings.hpp"

#include <array>
#include <stdexcept>

namespace poissonlab {
namespace {

/// A torus of corner colours, with how often each tile is among its windows.
class CornerTorus
{
public:
    CornerTorus(Color colors, std::vector<Color> corners)
        : colors_(colors), side_(colors * colors), corners_(std::move(corners)), count_(corners_.size(), 0)
    {
        for (Color y = 0; y < side_; ++y)
            for (Color x = 0; x < side_; ++x) ++count_[window(x, y)];
        for (const int count : count_) missing_ += count == 0;
    }

    /// Gives a corner a colour; returns by how many more tiles are missing then.
    int recolor(PackingPlace corner, Color color)
    {
        const int before = missing_;
        const std::array<Color, 2> xs{corner.x, (corner.x + side_ - 1) % side_};
        const std::array<Color, 2> ys{corner.y, (corner.y + side_ - 1) % side_};
        for (const Color y : ys)
            for (const Color x : xs) missing_ += --count_[window(x, y)] == 0;
        corners_[std::size_t{corner.y} * side_ + corner.x] = color;
        for (const Color y : ys)
            for (const Color x : xs) missing_ -= count_[window(x, y)]++ == 0;
        return missing_ - before;
    }

    Color at(PackingPlace corner) const { return corners_[std::size_t{corner.y} * side_ + corner.x]; }
    bool is_packing() const { return missing_ == 0; }
    const std::vector<Color>& corners() const { return corners_; }

private:
    TileIndex window(Color x, Color y) const
    {
        const Color east = x + 1 == side_ ? 0 : x + 1, north = y + 1 == side_ ? 0 : y + 1;
        return corner_index({at({east, north}), at({east, y}), at({x, y}), at({x, north})}, colors_);
    }

    Color colors_, side_;
    std::vector<Color> corners_;
    std::vector<int> count_;
    int missing_ = 0;
};

/// The corners that a block of q^2 x q^2 tiles leaves free on a torus of `side`.
std::vector<PackingPlace> free_corners(Color block_side, Color side)
{
    std::vector<PackingPlace> free;
    for (Color y = 0; y < side; ++y)
        for (Color x = 0; x < side; ++x)
            if (x > block_side || y > block_side) free.push_back({x, y});
    return free;
}

/// A torus with the block in its lower left and random colours elsewhere. The block's own torus closes: its corners
/// begin again in the column and row beyond it.
std::vector<Color> corners_around(const TilePacking& block, Color colors, RandomWords& words)
{
    const std::vector<Color> inner = corner_colors_of(block);
    const Color side = colors * colors, block_side = block.side();
    std::vector<Color> corners;
    for (Color y = 0; y < side; ++y)
        for (Color x = 0; x < side; ++x)
            corners.push_back(x <= block_side && y <= block_side
                                  ? inner[std::size_t{y % block_side} * block_side + x % block_side]
                                  : words.below(colors));
    return corners;
}

}

TilePacking grown_packing(const TilePacking& block, std::uint64_t seed)
{
    if (block.kind != TileKind::corner || block.colors != 2)
        throw std::logic_error("only packings of corner tiles over two colours grow");
    const Color colors = block.colors + 1;
    RandomWords words(stream_key(seed, Purpose::tile_packing, 2), 0);
    CornerTorus torus(colors, corners_around(block, colors, words));
    const std::vector<PackingPlace> free = free_corners(block.side(), colors * colors);
    // One more tile missing is accepted once in 2^3.5 times: found by trying on this problem.
    constexpr std::uint32_t accepted = 379'625'062; // 2^32 / 2^3.5
    for (std::uint64_t step = 0; !torus.is_packing(); ++step) {
        if (step % 65536 == 0) stop_if_interrupted();
        const PackingPlace corner = free[words.below(static_cast<std::uint32_t>(free.size()))];
        const Color before = torus.at(corner);
        const int more = torus.recolor(corner, (before + 1 + words.below(colors - 1)) % colors);
        bool stays = true;
        for (int i = 0; i < more; ++i) stays = stays && words.next() < accepted;
        if (!stays) torus.recolor(corner, before);
    }
    return packing_of_corner_colors(colors, torus.corners());
}

}
