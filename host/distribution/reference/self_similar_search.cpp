// The plain C++ twin of kernels/self_similar.cl: all pairs of balanced starts, as D 4.7.2.2 has it.
#include "host/distribution/self_similar_search.hpp"

#include <bit>

namespace poissonlab::reference {

std::vector<FoundStarts> search_self_similar(std::uint32_t points, double least_radius)
{
    const std::vector<std::uint32_t> words = balanced_words(points);
    std::vector<SelfSimilarStarts> found;
    for (const std::uint32_t x : words) {
        bool is_first_of_its_orbit = true;
        for (const SelfSimilarPoint& point : self_similar_points({x, x}, points))
            is_first_of_its_orbit = is_first_of_its_orbit && point[0] >= x;
        if (!is_first_of_its_orbit) continue;
        for (const std::uint32_t y : words) {
            if (4 * static_cast<std::uint32_t>(std::popcount(x & y)) != points) continue;
            if (self_similar_radius(squared_min_distance({x, y}, points), points) >= least_radius)
                found.push_back({x, y});
        }
    }
    return sorted_starts(std::move(found), points, least_radius);
}

}
