// The sampler "polyominoes": tori that are tiled with polyominoes, a point in each, moved by a table.
//
// Ostromoukhov, Sampling with polyominoes, 2007. The torus is tiled at random and divided: no window is cut out of a
// larger tiling, and each realization is another tiling. All points but those above a threshold are left out, so that
// sets have the number of points that is asked for. See tiles/polyominoes/polyomino_table.hpp for what is our own.
#pragma once

#include "host/device/needed_buffers.hpp"
#include "host/sampling/sampler.hpp"
#include "host/tile_sampling/built_once.hpp"
#include "results/records/sample_records.hpp"
#include "tiles/polyominoes/polyomino_points.hpp"
#include "tiles/polyominoes/polyomino_table.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

// Tables of polyominoes that were built before: building takes seconds, reading a file milliseconds.

/// The name of a table's file: there is one for each polyomino and version of the code.
std::string polyomino_table_name(Polyomino shape);

/// The table from `folder`, or built and put there: see built_once(). An empty folder: always built. `on_step` is told
/// of waiting and of the steps of building; what it throws ends that.
BuiltOnce<PolyominoTable> cached_polyomino_table(Polyomino shape, const std::filesystem::path& folder,
                                                 const std::function<void(const std::string& what)>& on_step = {});

// Points of polyominoes on a device, by kernels/polyominoes.cl: those of polyomino_points(), bit for bit.

/// Makes sets of one size. The table's row for it is copied to the device once.
class PolyominoGenerator
{
public:
    /// `work_group_size` 0: the default.
    PolyominoGenerator(Device device, Polyomino shape, std::size_t work_group_size = 0);

    /// The memory that a generator takes for sets of so many points on a torus of so many cells along each axis. The
    /// number of classes of neighbourhoods is known: 58 for P, 188 for G.
    static DeviceMemory memory(Polyomino shape, std::uint32_t side, std::size_t points);

    /// Exactly `points` points, fewer than 2^32.
    PointSet points(const PolyominoTorus& torus, std::size_t points);

private:
    struct Sizes
    {
        std::size_t roots, tiles, children, classes, row, points;
    };

    struct Buffers
    {
        Buffer<std::uint32_t> order, next;
        Buffer<std::array<std::int32_t, 4>> tiles, children;
        Buffer<Correction> corrections;
        Buffer<std::array<std::uint64_t, 2>> points;

        NeededBuffers needed(const Sizes& sizes);
    };

    Device device_;
    std::size_t work_group_size_;
    Buffers buffers_;
    Kernel place_points_;
};

/// Variants: "P", pentominoes that are divided into 4, "G", hexominoes that are divided into 81.
SamplerSpec polyomino_sampler();

}
