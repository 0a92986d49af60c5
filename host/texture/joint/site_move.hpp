// Expansion moves at a place of a set: a window of the exemplar is laid over all tiles that show the place, and cut
// into them at once, so that what they share stays the same in all of them.
#pragma once

#include "host/texture/joint/assembly.hpp"
#include "host/texture/joint/expansion_move.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace poissonlab {

/// A square of pixels around the middle of a site, and what lies over it: (x, y) is its north-western pixel.
struct SiteBox
{
    int x = 0;
    int y = 0;
    int side = 0;
};

/// The place of a window over a site: the exemplar's pixel over the middle of the site.
struct Overlay
{
    int x = 0;
    int y = 0;
};

/// The outcome of a move.
struct SiteChange
{
    std::vector<ChangedPixel> pixels;
    std::int64_t seam_gain = 0; ///< by how much seams become cheaper
    double gain = 0;            ///< the same with sums over tiles, as the move foresees
};

/// The pixels of a box that may change, and their neighbours. Boxes of sites whose tiles are shared, corners and edges,
/// must reach less than T/2 - 1 from the middle in the directions in which tiles lie side by side.
class SiteMove
{
public:
    SiteMove(const Assembly& assembly, const Site& site, const SiteBox& box);

    /// The mean over all tiles of what is shown in the box, in the channels of a picture of the exemplar's size.
    PngPixels canvas(const PngPixels& picture) const;

    /// The cheapest move; no pixels where nothing is cheaper. `is_taken`, of places in the box, says which pixels take
    /// the window in any case.
    SiteChange best(const Overlay& overlay, const std::function<bool(int x, int y)>& is_taken = {}) const;

    /// Windows that pixels of the box show, each once, by their overlays.
    std::vector<Overlay> shown() const;

private:
    struct Pixel
    {
        std::size_t number = 0; ///< in the cover
        int x = 0;              ///< in the site
        int y = 0;
        int tile_x = 0; ///< in its tiles
        int tile_y = 0;
        int tiles = 0; ///< how many of the site show it
    };
    struct Pair
    {
        std::size_t first = 0, second = 0;               ///< in the cover
        int first_in_pixels = -1, second_in_pixels = -1; ///< -1: it stays as it is
        Neighbour neighbour = Neighbour::east;
        int tiles = 0;
    };

    /// The choices of a pixel in a move, and what it shows if it takes the window.
    struct Option
    {
        int node = -1; ///< in the move; -1: no choice
        bool is_taken = false;
        SourcePixel kept, taken;
        int levels = 0; ///< that these two differ by

        SourcePixel shown() const { return is_taken ? taken : kept; }
    };

    /// Places in pixels_ of pixels of the cover.
    using PixelPlaces = std::unordered_map<std::size_t, int>;

    PixelPlaces add_pixels();
    void add_pairs(const PixelPlaces& places);
    bool may_change(std::size_t pixel, int x, int y) const;
    int layers() const;
    std::vector<Option> options(const Overlay& overlay, const std::function<bool(int x, int y)>& is_taken) const;
    static ChangedPixel changed(const Pixel& pixel, SourcePixel source);
    Option option_of(const std::vector<Option>& all, int place, std::size_t pixel) const;
    PairChoice costs(const Pair& pair, const Option& first, const Option& second) const;
    void add_pair(ExpansionMove& move, const Pair& pair, const std::vector<Option>& all) const;
    std::int64_t seam_gain(const std::vector<Option>& all) const;

    const Assembly& assembly_;
    const Site& site_;
    SiteBox box_;
    std::vector<Pixel> pixels_;
    std::vector<Pair> pairs_;
    int layers_ = 1; ///< tiles that lie over each other
};

// The search for the places where the seams of a site are dearest.

/// North-western pixels of boxes.
using BoxPlaces = std::set<std::pair<int, int>>;

/// The box of a site whose seams cost most, over all its tiles, but for those that are left out; nothing where none has
/// seams. Boxes lie around corners and edges, an eighth of T apart along them, and anywhere in tiles.
std::optional<SiteBox> dearest_box(const Assembly& assembly, const Site& site, int side, const BoxPlaces& left_out);

}
