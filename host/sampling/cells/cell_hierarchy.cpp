#include "host/sampling/cells/cell_hierarchy.hpp"

#include <cmath>
#include <numbers>

namespace poissonlab {

namespace {

/// Cells along an axis: the diagonal of a cell, sqrt(dimension) / size, must not exceed the minimum distance.
double cells_along_axis(double min_distance, int dimension)
{
    return std::ceil(std::sqrt(static_cast<double>(dimension)) / min_distance * (1.0 + 1e-12));
}

}

double level_0_cells(double min_distance, int dimension)
{
    return std::pow(cells_along_axis(min_distance, dimension), dimension);
}

CellHierarchy cell_hierarchy(double min_distance, int dimension)
{
    CellHierarchy h;
    h.size = static_cast<std::uint32_t>(cells_along_axis(min_distance, dimension));
    __extension__ using Wide = unsigned __int128;
    h.step = static_cast<std::uint64_t>(((Wide{1} << 64) + h.size - 1) / h.size);
    while ((static_cast<std::uint64_t>(h.size) << (h.last_level + 1)) <= (std::uint64_t{1} << 32)) ++h.last_level;
    h.reach = static_cast<int>(std::ceil(min_distance * h.size * (1.0 + 1e-6)));
    return h;
}

std::vector<std::uint32_t> poisson_thresholds(double mean)
{
    // exp(-mean) as 1 / (sum of mean^k / k!)
    double power = 1.0;
    double exponential = 1.0;
    for (int k = 1; k < 60; ++k) {
        power *= mean / k;
        exponential += power;
    }
    std::vector<std::uint32_t> thresholds;
    double probability = 1.0 / exponential;
    double cumulative = probability;
    for (int k = 1; cumulative * 0x1p32 < 0x1p32 - 1.0; ++k) {
        thresholds.push_back(static_cast<std::uint32_t>(cumulative * 0x1p32));
        probability *= mean / k;
        cumulative += probability;
    }
    return thresholds;
}

std::uint64_t packing_bound(double min_distance, int dimension)
{
    const double bound = dimension == 2 ? 2.0 / (std::numbers::sqrt3 * min_distance * min_distance)
                                        : std::numbers::sqrt2 / (min_distance * min_distance * min_distance);
    return static_cast<std::uint64_t>(bound * (1.0 + 1e-9)) + 1;
}

}
