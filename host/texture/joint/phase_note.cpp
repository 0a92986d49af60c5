#include "host/texture/joint/phase_note.hpp"

#include "tiles/texture/texture_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

/// Within so many pixels along an axis there are `needed` places, one after another, of each phase of all waves.
int room_for_phases(const std::vector<RegularWave>& waves, std::size_t needed)
{
    double longest = 0;
    for (const RegularWave& wave : waves) longest = std::max(longest, 1 / std::max(std::abs(wave.x), std::abs(wave.y)));
    return static_cast<int>(std::ceil(longest * static_cast<double>(needed)));
}

/// The largest smaller tiles that waves fit and of which a picture has enough windows; 0 where there are none.
int largest_size(const PngPixels& exemplar, const std::vector<RegularWave>& waves, int size, std::size_t needed)
{
    const int room = std::min(exemplar.width, exemplar.height) - room_for_phases(waves, needed);
    for (int smaller = std::min(size - 2, room / 2 * 2); smaller >= least_tile_pixels; smaller -= 2)
        if (std::ranges::all_of(waves, [&](const RegularWave& wave) { return fits_tiles(wave, smaller); }))
            return smaller;
    return 0;
}

}

std::string phase_note(const PngPixels& exemplar, const std::vector<RegularWave>& waves, int size, std::size_t needed)
{
    std::string periods = fmt::format("{:.1f}", waves.front().period());
    if (waves.size() > 1) periods += fmt::format(" and {:.1f}", waves.back().period());
    const int side = size + room_for_phases(waves, needed), smaller = largest_size(exemplar, waves, size, needed);
    return fmt::format(
        "the picture repeats every {} pixels, but too little of its {} x {} is beside a tile of {} for {} "
        "windows that lie alike in that: joints do not run through; they do with a picture of {} x {}{}",
        periods, exemplar.width, exemplar.height, size, needed, side, side,
        smaller > 0 ? fmt::format(", or with --size {}", smaller) : "");
}

}
