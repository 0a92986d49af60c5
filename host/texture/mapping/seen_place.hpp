// This finds where a sample of a view sees the plane, and how far its footprint reaches there: the plain twin of
// kernels/common/fields/plane_view.clh, for all plain maps.
#pragma once

#include "base/programs/interrupt.hpp"
#include "kernels/common/fields/texture_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

/// Sums of up to three channels.
using Light = std::array<float, 3>;

/// A place of the plane in tiles east and north of the view's, and the look-ups side by side that its footprint takes.
struct SeenPlace
{
    double u = 0, v = 0;
    double along_u = 0, along_v = 0; ///< the footprint's longer side, in tiles
    double texels = 0;               ///< along it, of level 0, for each look-up
    int probes = 1;                  ///< look-ups; of filters without levels 1
};

/// Returns the place of the plane that a sample sees, whose tiles have `size` texels; nothing above the horizon and
/// beyond FARTHEST.
inline std::optional<SeenPlace> seen_place(const contract::texture_map::TextureView& view, int size, double column,
                                           double row)
{
    using namespace contract::texture_map;
    const auto at = [&](const double(&function)[3]) { return function[0] + function[1] * column + function[2] * row; };
    const double w = at(view.w);
    if (!(w > HORIZON)) return std::nullopt;
    SeenPlace seen{at(view.u) / w, at(view.v) / w};
    if (!(std::abs(seen.u) < FARTHEST && std::abs(seen.v) < FARTHEST)) return std::nullopt;
    if (view.filter < FILTER_MIPMAP) return seen;
    std::array<double, 2> along_u{}, along_v{}, texels{};
    for (std::size_t k = 0; k < 2; ++k) {
        along_u[k] = (view.u[k + 1] - seen.u * view.w[k + 1]) / w;
        along_v[k] = (view.v[k + 1] - seen.v * view.w[k + 1]) / w;
        texels[k] = std::sqrt(along_u[k] * along_u[k] + along_v[k] * along_v[k]) * size;
    }
    const std::size_t longer = texels[0] > texels[1] ? 0 : 1;
    if (view.filter == FILTER_ANISOTROPIC)
        while (seen.probes < MAX_PROBES && seen.probes * texels[1 - longer] < texels[longer] &&
               seen.probes < texels[longer])
            ++seen.probes;
    seen.along_u = along_u[longer];
    seen.along_v = along_v[longer];
    seen.texels = texels[longer] / seen.probes;
    return seen;
}

/// Returns the place of a look-up of the footprint, east and north: side by side along its longer side, which near the
/// horizon may go beyond what is seen, but then counts as its end.
inline std::array<double, 2> probe_place(const SeenPlace& seen, int probe)
{
    using contract::texture_map::FARTHEST;
    const double part = (probe + 0.5) / seen.probes - 0.5;
    return {std::clamp(seen.u + part * seen.along_u, -FARTHEST, FARTHEST),
            std::clamp(seen.v + part * seen.along_v, -FARTHEST, FARTHEST)};
}

/// Two levels, and the part of the upper one.
struct LevelPair
{
    int lower = 0;
    float upper = 0;
};

/// The levels between which the look-up for a footprint of so many texels is, the lower one at most `most`: between two
/// powers of two the part of the upper one grows linearly.
inline LevelPair levels_of_footprint(double footprint, int most)
{
    int level = 0;
    double texels = 1;
    for (; footprint >= 2 * texels && level < most; texels *= 2) ++level;
    return {level, static_cast<float>(std::clamp(footprint / texels - 1, 0.0, 1.0))};
}

/// The picture of a view: `add_sample(column, row, sum)` adds the light of a sample. Throws Interrupted.
template <typename AddSample>
std::vector<float> plain_picture(const contract::texture_map::TextureView& view, int channels, AddSample add_sample)
{
    std::vector<float> pixels;
    for (int row = 0; row < view.height; ++row) {
        stop_if_interrupted();
        for (int column = 0; column < view.width; ++column) {
            Light sum{};
            for (int j = 0; j < view.samples; ++j)
                for (int i = 0; i < view.samples; ++i)
                    add_sample(static_cast<double>(column) * view.samples + i + 0.5,
                               static_cast<double>(row) * view.samples + j + 0.5, sum);
            for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
                pixels.push_back(static_cast<float>(static_cast<double>(sum[c]) / (view.samples * view.samples)));
        }
    }
    return pixels;
}

}
