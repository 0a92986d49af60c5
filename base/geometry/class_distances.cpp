#include "base/geometry/class_distances.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace poissonlab {

ClassDistances wei_distances(const std::vector<double>& distances, int dimension)
{
    ClassDistances matrix(distances.size());
    std::vector<std::size_t> order(distances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return distances[i]; });
    double density = 0;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        for (; end < order.size() && distances[order[end]] == distances[order[begin]]; ++end)
            density += 1 / std::pow(distances[order[end]], dimension);
        const double between = 1 / std::pow(density, 1.0 / dimension);
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t j = 0; j < i; ++j) matrix.set(order[i], order[j], between);
    }
    for (std::size_t i = 0; i < distances.size(); ++i) matrix.set(i, i, distances[i]);
    return matrix;
}

}
