// Levels of an exemplar of any size, and what endless textures need of each: means of colours, and tables back.
#pragma once

#include "kernels/common/fields/endless_map.h"

#include <cstddef>
#include <vector>

namespace poissonlab {

struct LevelValues
{
    contract::endless_map::ExemplarLevels levels{};
    int channels = 1;
    std::vector<float> values; ///< channels of texels, levels one after the other

    std::size_t begin(int level) const { return levels.offsets[level]; }
    std::size_t end(int level) const { return level == levels.top ? values.size() : levels.offsets[level + 1]; }
    /// The first value of a texel.
    std::size_t texel(int level, int x, int y) const;
};

/// All levels up to the mean of all, of the values of level 0. A level has half as many texels along an axis as the one
/// below, rounded up, which divide the exemplar evenly: all have the same area, whatever its size.
LevelValues level_values(int width, int height, int channels, std::vector<float> values);

/// Numbers from 0 to 255 by the root of light: a table of the contract.
std::vector<float> encoded_numbers();

/// The light of numbers from 0 to 255, and then half the second derivatives of light there.
std::vector<float> light_of_numbers();

/// Three means of encoded light at each level, 0 of channels that there are not.
std::vector<float> encoded_means(const LevelValues& light);

/// The tables back at each level of a Gaussian exemplar, for each coordinate means over what the level averages away,
/// and then their variances.
std::vector<float> level_tables(const LevelValues& numbers, const std::vector<float>& inverse);

}
