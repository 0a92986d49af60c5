// The traits of a sampler's sets beside their points are one value, so that a method that makes its sets from another's
// hands on all of it. A trait more is a member here, the method that sets it, and who asks for it.
#pragma once

#include "results/records/archive.hpp"
#include "results/records/sample_records.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct SetTraits
{
    /// Realizations differ in size by the nature of the method (saturation), rather than by mistake.
    bool sizes_vary = false;

    /// Sets are windows of the plane: what lies beside the right border is not what lies at the left one.
    bool is_window = false;

    /// The first points of a set are a set of their own, however many they are.
    bool is_progressive = false;

    /// The number of tiles along each axis of which sets are made; 0: they are not made of tiles.
    std::uint32_t tiles_along_axis = 0;

    /// The number of tile sets that realizations take in turn, realization k set k % tile_sets.
    std::uint32_t tile_sets = 1;

    /// The tile set of methods that tile.
    std::optional<TileSetRecord> tile_set = {};

    /// Makes the bytes of the Poisson disk (sphere) tile set's binary file, docs/tile-set-file.md, where sets are
    /// tilings with one: others can use it. Empty elsewhere; to be called while the sampler lives.
    std::function<std::string()> tile_set_file = {};

    /// The iterations of the last set; empty for methods without any.
    std::vector<IterationRecord> iterations = {};

    /// The relative radius that the last set is proven to have at least, where that is known without looking at it.
    std::optional<double> proven_relative_radius = {};

    /// Seconds spent on what all sets have in common, such as a tile set, without building kernels.
    double preparation_seconds = 0;

    /// The seconds that the last set took where it was made side by side with others: its share of their time, without
    /// building kernels. Nothing: those of its sample().
    std::optional<double> shared_seconds = {};

    /// All but times and files is stored with a set.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(sizes_vary, is_window, is_progressive, tiles_along_axis, tile_sets, tile_set, iterations,
                proven_relative_radius);
    }
};

}
