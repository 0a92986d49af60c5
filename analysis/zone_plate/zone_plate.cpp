#include "analysis/zone_plate/zone_plate.hpp"

#include <tbb/parallel_for.h>

#include <stdexcept>

namespace poissonlab {

SquareImage zone_plate_image(const PointSet& points)
{
    if (points.dimension != 2) throw std::invalid_argument("the zone plate is sampled by 2D sets");
    std::vector<double> values(points.size());
    tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t k) {
        values[k] = zone_plate(plate_side * points[k][0], plate_side * points[k][1]);
    });
    return reconstruct(points, values, one_sample_a_pixel(points.size()));
}

}
