// The numbers of what kinds of distributions make: results have them, and commands print them with --json.
#pragma once

#include "host/distribution/icons.hpp"
#include "host/distribution/instances/instances.hpp"
#include "host/distribution/sky_lights.hpp"
#include "host/distribution/stipple.hpp"
#include "results/pictures/distribution_result.hpp"

#include <optional>

namespace poissonlab {

/// `map` is the environment map, if it is one; `points` are the even ones.
DistributionNumbers warp_numbers(const std::optional<LinearPicture>& map, const Density& density,
                                 const PixelPlaces& places, const SquarePoints& points);

DistributionNumbers rank_numbers(const RankSettings& settings, const Density& density, const PixelPlaces& places);

/// `points` is the number of even points.
DistributionNumbers icon_numbers(const Icons& icons, const VectorField& field, std::size_t points);

DistributionNumbers instance_numbers(std::size_t instances, const InstanceSettings& settings, double radius);

DistributionNumbers mark_numbers(const InkPicture& picture, const StippleSettings& settings, const Stippling& stippling,
                                 const TonesOfMarks& tones);

}
