// Which windows of a regular exemplar may lie where, so that its courses go on from window to window: joints of bricks
// run through a tiling where all windows lie alike in them.
//
// That needs tiles over whose side every wave has a whole number of periods. Crests of the exemplar then meet crests
// of what is there, or what is there is not of the exemplar; near-regular textures after Liu, Lin and Hays
// (Near-regular Texture Analysis and Manipulation, 2004) are put together of whole cells of their lattice for the same
// reason.
#pragma once

#include "host/texture/regular/regular_waves.hpp"
#include "host/texture/window_choice.hpp"

#include <vector>

namespace poissonlab {

class PhaseRule
{
public:
    /// Everything may lie everywhere.
    PhaseRule() = default;

    /// The waves fit tiles of T x T pixels. Borders of tiles lie where the exemplar's two sides have least to do
    /// with each other, between two courses: what crosses them would have to go on in many tiles.
    PhaseRule(const PngPixels& exemplar, const std::vector<RegularWave>& waves, int size);

    bool is_empty() const { return waves_.empty(); }

    /// True if a window may lie with its middle at (x, y), pixels from a tile's corner to the east and south: crests
    /// are at most a pixel, and as many more as `slack`, from where they should be.
    bool holds(const ExemplarWindow& window, double x, double y, double slack = 0) const;

    /// The nearest window within the exemplar that may lie so, or the window itself if none may.
    ExemplarWindow nearest(const ExemplarWindow& window, const PngPixels& exemplar, double x, double y) const;

private:
    struct Phase
    {
        RegularWave wave;              ///< of the exemplar
        double tile_x = 0, tile_y = 0; ///< periods a pixel in tiles, whole ones over T
        double start = 0;              ///< periods, at a tile's corner
    };
    std::vector<Phase> waves_;
};

/// The regular waves of an exemplar that fit tiles of a size.
std::vector<RegularWave> fitting_waves(const PngPixels& exemplar, int size);

/// These are what waves alone make of numbers of the exemplar: means of all that have the same place in a period. In a
/// tiling whose windows lie alike this is what all tiles have at a place; without waves, the mean of all.
class PhaseMeans
{
public:
    PhaseMeans(const PngPixels& exemplar, std::vector<RegularWave> waves);

    double at(int x, int y, int channel) const { return means_[bin(x, y, channel)]; }

private:
    std::size_t bin(int x, int y, int channel) const;

    std::vector<RegularWave> waves_;
    std::size_t channels_;
    std::vector<double> means_;
};

}
