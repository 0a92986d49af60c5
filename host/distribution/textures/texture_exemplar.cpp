#include "host/distribution/textures/texture_exemplar.hpp"

#include "host/distribution/even_points.hpp"
#include "host/texture/synthetic_exemplar.hpp"

namespace poissonlab {

ExemplarPictures texture_exemplar(const TextureSettings& settings, std::uint64_t seed, const DistributionPlace& place)
{
    ExemplarPictures pictures;
    if (settings.pattern.empty()) {
        pictures = read_exemplar_pictures(settings.exemplar, settings.marked_exemplar, settings.also);
    } else {
        SquarePoints places;
        if (settings.pattern == "pebbles")
            places = even_points(default_even_method(), pebble_count(settings.pattern_size), 1, 1, seed, place);
        pictures.exemplar = synthetic_exemplar(settings.pattern, settings.pattern_size, seed, places);
    }
    if (settings.is_straightened) straighten(pictures, settings.request.size);
    if (!settings.endless) flatten(pictures, settings.request.size, settings.is_flattened);
    return pictures;
}

}
