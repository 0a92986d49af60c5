// The exemplar of a table [[texture]]: a picture's file, or a pattern.
#pragma once

#include "host/kinds/distribution_place.hpp"
#include "host/settings/distributions/texture_config.hpp"
#include "host/texture/exemplar_pictures.hpp"

namespace poissonlab {

ExemplarPictures texture_exemplar(const TextureSettings& settings, std::uint64_t seed, const DistributionPlace& place);

}
