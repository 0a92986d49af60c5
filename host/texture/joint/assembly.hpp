// An assembly says what every pixel of a set of tiles shows, what its seams cost, and how far its tilings are from the
// exemplar.
//
// A seam between neighbours p and q that show windows A and B costs |A(p) - B(p)| + |A(q) - B(q)|, and 1, as Kwatra and
// others have it (Graphcut textures, 2003): a distance of windows that obeys the triangle inequality. It counts once
// for each tile that has the pair, and in parts of the exemplar's mean step in its direction: where joints of bricks
// run from north to south, a break between two rows is seen, and one between two columns is not. Slopes are left out:
// windows nearly always differ in them, so that cuts become short and colours meet that differ more.
//
// Two sums over all tiles are weighed against seams. Repetition is the power of the mean of all tiles without the
// exemplar's mean, by phase where it is regular: what a tiling has too much at whole multiples of 1/T. Contrast is the
// square of what the variance of all pixels lacks or exceeds: windows without much in them fit everywhere, and nothing
// else would keep a set from taking them.
#pragma once

#include "host/texture/joint/phase_rule.hpp"
#include "host/texture/joint/set_cover.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// Says on which side of the first of two neighbours the second one lies.
enum class Neighbour : std::uint8_t
{
    east,
    south,
};

/// A pixel that is to show another source.
struct ChangedPixel
{
    std::size_t pixel = 0; ///< in the cover
    SourcePixel source;
    int tile_x = 0; ///< its place in the tiles that show it
    int tile_y = 0;
    int tiles = 0; ///< that show it

    bool operator==(const ChangedPixel&) const = default;
};

class Assembly
{
public:
    static constexpr int seam_unit = 8;

    /// The weight of sums against seams. With a repetition of 1, a pixel that is one standard deviation from the mean
    /// in all tiles costs as much as a step of that height in each; so it does with a contrast of 2 if nothing else
    /// varies.
    struct Weights
    {
        double repetition = 0.5;
        double contrast = 2;
    };

    /// Exemplar and cover must live longer. `waves` are those that fit the tiles.
    Assembly(const PngPixels& exemplar, const SetCover& cover, const Weights& weights,
             const std::vector<RegularWave>& waves = {});

    const SetCover& cover() const { return cover_; }
    const PngPixels& exemplar() const { return exemplar_; }

    SourcePixel source(std::size_t pixel) const { return sources_[pixel]; }

    /// Lets a pixel show a source; sums over tiles are right after count_tiles().
    void show(std::size_t pixel, SourcePixel source) { sources_[pixel] = source; }

    /// The cost of a pair of neighbours in one tile, in parts of a level: seam_unit of them are one where the
    /// exemplar's steps are alike in both directions.
    std::int64_t seam_cost(SourcePixel first, SourcePixel second, Neighbour neighbour) const;

    /// The sum over channels of the differences of two pixels of the exemplar.
    int levels(SourcePixel a, SourcePixel b) const { return distance(a.x, a.y, b.x, b.y); }

    /// The cost of a pair whose two windows differ by so many levels over both pixels.
    std::int64_t cost_of_levels(int levels, Neighbour neighbour) const
    {
        return seam_unit + step_weights_[neighbour == Neighbour::east ? 0 : 1] * levels;
    }

    /// All seams of all tiles, with those across their eastern and southern borders.
    std::int64_t seams() const;

    /// Sums over all tiles of a channel's difference from the exemplar's mean, by the place in a tile.
    const std::vector<std::int64_t>& sums() const { return sums_; }
    /// The sum over all pixels of all tiles of squares of such differences.
    std::int64_t squares() const { return squares_; }

    /// Adds up the sums from what is shown.
    void count_tiles();

    /// The cost that the sums lose if pixels change. The pixels are of one site.
    double sums_gain(const std::vector<ChangedPixel>& pixels) const;

    /// The cost that it adds to sums, to first order in all but the sums at its place, that a pixel changes together
    /// with those of other tiles: so many lie over each other there, in all.
    double change_cost(const ChangedPixel& pixel, int layers) const;

    /// Changes pixels, and the sums with them.
    void change(const std::vector<ChangedPixel>& pixels);

    /// Seams and sums.
    double cost() const;

private:
    std::size_t sum_at(int x, int y) const
    {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(cover_.size()) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(exemplar_.channels);
    }

    /// The difference of a channel from the exemplar's mean.
    int deviation(SourcePixel source, int channel) const
    {
        const std::size_t at = exemplar_.at(source.x, source.y, channel);
        return exemplar_.values[at] - means_[at];
    }

    void weigh_directions();
    /// The sum over channels of differences between two pixels of the exemplar, or of its rim, by columns and rows.
    int distance(int ax, int ay, int bx, int by) const;
    double contrast_cost(std::int64_t squares) const;

    const PngPixels& exemplar_;
    const SetCover& cover_;
    PngPixels rimmed_;                  ///< the exemplar, and its rim once more around it
    std::array<int, 2> step_weights_{}; ///< the cost of a level towards east and south
    std::vector<std::uint8_t> means_;   ///< for each of the exemplar's numbers
    double repetition_ = 0;             ///< the cost of a square of a sum
    double contrast_ = 0;               ///< the cost of a square of what squares_ differs by
    double natural_squares_ = 0;        ///< what squares_ would be with the exemplar's variance
    std::vector<SourcePixel> sources_;
    std::vector<std::int64_t> sums_;
    std::int64_t squares_ = 0;
};

// Pixels that a move changes, in little room: many moves are looked for before one is made.

/// Changed pixels beside each other in a row of a tile, whose sources are beside each other as well.
struct ChangedRun
{
    ChangedPixel first;
    int length = 0;
};

std::vector<ChangedRun> runs_of(const std::vector<ChangedPixel>& pixels);

/// The pixels again, in their order.
std::vector<ChangedPixel> pixels_of(const std::vector<ChangedRun>& runs);

}
