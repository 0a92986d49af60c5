// The cost of sets by their size, as measured once and stored with the program: docs/gallery/sizes.csv.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace poissonlab {

/// The cost of one set of so many points.
struct SizeCost
{
    std::size_t points = 0;
    double seconds = 0;   ///< of all processor cores together
    double gigabytes = 0; ///< the most that the process had
};

/// The costs of a method with some choice of its parameters.
struct SizedMethod
{
    std::string sampler;
    std::string keys; ///< as in a config; empty: defaults
    int dimension = 2;
    std::vector<SizeCost> costs; ///< from small to large; larger sets were not made

    /// The exponent of time between the last two sizes: 1 is linear. NaN where there are fewer.
    double exponent() const;
};

/// All methods that were measured.
const std::vector<SizedMethod>& measured_sizes();

/// A table in Markdown, of all methods or of one sampler's; empty where there is none.
std::string size_table(const std::string& sampler = "");

}
