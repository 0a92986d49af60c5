#include "results/stored_points.hpp"

#include "base/points/point_file.hpp"

namespace poissonlab {

std::vector<PointSet> read_stored_points(const Series& series, const std::filesystem::path& file)
{
    return series.region ? read_own_points(file, any_coordinates) : read_own_points(file);
}

}
