// Small sets of noise to be mapped, and views of them whose filtering is known.
#pragma once

#include "host/texture/mapping/texture_map.hpp"
#include "host/texture/texture_build.hpp"
#include "tests/host/texture/random_picture.hpp"

namespace poissonlab::test {

inline constexpr std::uint32_t mapped_seed = 5; ///< of tilings
inline constexpr int mapped_tile_pixels = 16;

/// A complete set.
inline TextureSet mapped_noise(TextureKind kind, Color colors, int channels, int ring, int stages = 3)
{
    TextureRequest request;
    request.kind = kind;
    request.colors = {colors, colors};
    request.size = mapped_tile_pixels;
    request.ring = ring;
    request.stages = stages;
    request.attempts = 2;
    request.candidates = 1;
    return build_texture(request, random_picture(90, 80, channels, 3),
                         [](const std::string&, std::size_t, std::size_t) {})
        .set;
}

/// Looks straight down: pixels are `texels` apart along both axes, the first column's middle `start` texels into the
/// tile, and so would be that of the row below the last one.
inline TextureView plan_view(double texels, double start, int size, TextureFilter filter)
{
    TextureView view{};
    const double step = texels / mapped_tile_pixels;
    view.u[0] = start / mapped_tile_pixels - step / 2;
    view.u[1] = step;
    view.v[0] = start / mapped_tile_pixels + step / 2 + size * step;
    view.v[2] = -step;
    view.w[0] = 1;
    view.width = view.height = size;
    view.samples = 1;
    view.filter = static_cast<int>(filter);
    return view;
}

}
