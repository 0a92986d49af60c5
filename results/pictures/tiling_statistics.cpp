#include "results/pictures/tiling_statistics.hpp"

#include <algorithm>

namespace poissonlab {

std::string autocorrelation_file(const ColorStatistics& colors)
{
    std::string name = colors.name;
    std::ranges::replace(name, ' ', '-');
    return name + "-autocorrelation.exr";
}

}
