#include "host/texture/advice/picture_scales.hpp"

#include "tiles/texture/square_means.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace poissonlab {

LightMap without_slow_light(const LightMap& light, int reach)
{
    const SquareMeans means(light.values, light.width);
    LightMap map = light;
    tbb::parallel_for(0, map.height, [&](int y) {
        const int top = std::max(0, y - reach), bottom = std::min(map.height, y + reach + 1);
        for (int x = 0; x < map.width; ++x)
            map.values[map.index(x, y)] -=
                means.mean(std::max(0, x - reach), top, std::min(map.width, x + reach + 1), bottom);
    });
    return map;
}

std::optional<double> side_at_share(const LightMap& light, double share)
{
    const SquareMeans means(light.values, light.width);
    const double pixels = means.variance(1);
    return pixels > 0 ? means.side_of_variance(share * pixels) : std::nullopt;
}

}
