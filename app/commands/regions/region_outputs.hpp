// The files of the commands that make points in regions, and what they say of the points.
#pragma once

#include "app/commands/kind_options.hpp"
#include "host/distribution/regions/region_darts.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// --out, point files and pictures, and --distances.
struct RegionOutputs
{
    OutputFiles files{{{".svg", ".png"}, true}};
    std::string distances;

    std::vector<Option> options();

    /// Throws InputError for names that cannot be written, and for --distances of points whose distance does not vary.
    void check(const std::string& command, bool varies) const;

    /// `comment` goes into point files. Files have the coordinates of the region's file; only .dxf and .usda, for
    /// programs that draw, have metres of the plane that longitude and latitude were mapped to.
    void write(const RegionDarts& darts, const std::string& comment) const;
};

/// The options of a command that makes points in a region.
struct RegionOptions : KindOptions
{
    using KindOptions::KindOptions;

    /// Writes what was made and says what it is.
    void finish(const RegionDarts& made) const;

    RegionOutputs outs;
};

}
