// The further role of samplers whose sets are tilings with one Poisson disk (sphere) tile set: others can use that set.
#pragma once

#include <string>

namespace poissonlab {

class TileSetOwner
{
public:
    virtual ~TileSetOwner() = default;

    /// The bytes of the tile set's binary file, see docs/tile-set-file.md.
    virtual std::string tile_set_file() const = 0;
};

}
