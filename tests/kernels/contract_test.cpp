// Structs that kernels are told by value have the same layout on the device as on the host, and constants the same
// values.
#include "host/device/device.hpp"
#include "host/device/kernel_source.hpp"
#include "kernels/common/darts/class_darts.h"
#include "kernels/common/darts/dart_throwing.h"
#include "kernels/common/darts/relaxation_dart_throwing.h"
#include "kernels/common/darts/voronoi_darts.h"
#include "kernels/common/fields/endless_map.h"
#include "kernels/common/fields/endless_texture.h"
#include "kernels/common/fields/gradient_domain.h"
#include "kernels/common/fields/instances.h"
#include "kernels/common/fields/texture_map.h"
#include "kernels/common/fields/warp.h"
#include "kernels/common/lloyd_sets.h"
#include "kernels/common/optimized/gaussian_blue_noise.h"
#include "kernels/common/optimized/sample_elimination.h"
#include "kernels/common/sectors/sector_darts.h"
#include "kernels/common/surfaces/class_surface.h"
#include "kernels/common/surfaces/surface.h"
#include "kernels/common/surfaces/surface_elimination.h"
#include "kernels/common/tile_sampling/averaged_tiles.h"
#include "kernels/common/tile_sampling/recursive_tiles.h"
#include "kernels/common/tiles/self_similar.h"
#include "kernels/common/tiles/tile_filling.h"
#include "kernels/common/tiles/tile_points.h"
#include "tiles/objects/object_lookup.hpp"

#include "kernels/common/fields/object_looks.h"

#include <gmock/gmock.h>

#include <cstddef>
#include <map>
#include <string>

namespace poissonlab {
namespace {

/// An expression of OpenCL C in a file below kernels/, and what it is on the host.
struct Shared
{
    std::string file, expression;
    std::size_t value;
};

/// A struct has two rows: its size, and where its last member is.
#define LAYOUT(file, place, type, last)                                                                                \
    {file, "sizeof(struct " #type ")", sizeof(contract::place::type)},                                                 \
    {                                                                                                                  \
        file, "__builtin_offsetof(struct " #type ", " #last ")", offsetof(contract::place::type, last)                 \
    }
// clang-format off
const std::vector<Shared> all_shared = {
    LAYOUT("common/darts/class_darts.h", class_darts, SlotBatch, key_y),
    LAYOUT("common/darts/class_darts.h", class_darts, ClassPair, reach),
    LAYOUT("common/darts/class_darts.h", class_darts, ClassCells, spread),
    LAYOUT("common/darts/class_darts.h", class_darts, CoveredCells, count),
    LAYOUT("common/darts/class_darts.h", class_darts, ClassSlot, target),
    LAYOUT("common/lloyd_sets.h", lloyd_sets, Sets, moves),
    LAYOUT("common/surfaces/surface.h", surface, Triangle, normal),
    LAYOUT("common/surfaces/surface.h", surface, Piece, shares),
    LAYOUT("common/surfaces/surface.h", surface, SurfacePoint, next),
    LAYOUT("common/surfaces/surface.h", surface, SurfaceRule, first),
    LAYOUT("common/surfaces/surface.h", surface, SurfaceBatch, bucket_mask),
    LAYOUT("common/surfaces/surface_elimination.h", surface_elimination, Elimination, points),
    LAYOUT("common/surfaces/class_surface.h", class_surface, OpenPieces, spread),
    LAYOUT("common/surfaces/class_surface.h", class_surface, SurfaceSlot, target),
    LAYOUT("common/surfaces/class_surface.h", class_surface, SurfaceSlots, key_y),
    LAYOUT("common/darts/dart_throwing.h", dart_throwing, Batch, staged_capacity),
    LAYOUT("common/darts/dart_throwing.h", dart_throwing, Slabs, is_rest),
    LAYOUT("common/fields/gradient_domain.h", gradient_domain, GradientDomainSizes, relaxation),
    LAYOUT("common/fields/texture_map.h", texture_map, TextureView, filter),
    LAYOUT("common/fields/texture_map.h", texture_map, TextureLevels, offsets),
    LAYOUT("common/fields/endless_texture.h", endless_texture, EndlessPlane, axes),
    LAYOUT("common/fields/endless_texture.h", endless_texture, EndlessWindow, height),
    LAYOUT("common/fields/endless_map.h", endless_map, ExemplarLevels, offsets),
    LAYOUT("common/darts/relaxation_dart_throwing.h", relaxation_dart_throwing, Settling, unused),
    LAYOUT("common/darts/relaxation_dart_throwing.h", relaxation_dart_throwing, DartSquares, block_bits),
    LAYOUT("common/tiles/tile_filling.h", tile_filling, Darts, attempts),
    LAYOUT("common/tiles/tile_filling.h", tile_filling, Relaxation, max_moving),
    LAYOUT("common/tiles/tile_filling.h", tile_filling, Repulsion, monomials),
    LAYOUT("common/tiles/tile_points.h", tile_points, Run, shift),
    LAYOUT("common/tiles/tile_points.h", tile_points, Window, bottom),
    LAYOUT("common/darts/voronoi_darts.h", voronoi_darts, Torus, near_offsets),
    LAYOUT("common/darts/voronoi_darts.h", voronoi_darts, Batch, key_y),
    LAYOUT("common/darts/voronoi_darts.h", voronoi_darts, Offset, squared_gap),
    LAYOUT("common/sectors/sector_darts.h", sector_darts, SectorRules, steps),
    LAYOUT("common/sectors/sector_darts.h", sector_darts, GrowingSet, free_sector),
    LAYOUT("common/sectors/sector_darts.h", sector_darts, KeptSector, next),
    LAYOUT("common/tile_sampling/averaged_tiles.h", averaged_tiles, CentroidShift, is_known),
    LAYOUT("common/tile_sampling/recursive_tiles.h", recursive_tiles, RankedTile, begin),
    LAYOUT("common/tile_sampling/recursive_tiles.h", recursive_tiles, RankedLevel, is_uniform),
    LAYOUT("common/optimized/gaussian_blue_noise.h", gaussian_blue_noise, Gaussians, unused),
    LAYOUT("common/optimized/gaussian_blue_noise.h", gaussian_blue_noise, DensityCell, is_empty),
    LAYOUT("common/optimized/sample_elimination.h", sample_elimination, Elimination, stride),
    LAYOUT("common/optimized/sample_elimination.h", sample_elimination, EliminationCounts, of_round),
    LAYOUT("common/fields/warp.h", warp, Warping, height),
    LAYOUT("common/tiles/self_similar.h", self_similar, StartSearch, capacity),
    LAYOUT("common/fields/instances.h", instances, InstanceScene, models),
    LAYOUT("common/fields/instances.h", instances, InstanceTiles, below),
    LAYOUT("common/fields/instances.h", instances, PlacedInstance, unused),
    LAYOUT("objects.cl", objects, ObjectTiles, above),
    LAYOUT("objects.cl", objects, ObjectScene, palette),
    {"common/darts/dart_throwing.h", "DART_WORDS", contract::dart_throwing::DART_WORDS(3)},
    {"common/darts/dart_throwing.h", "POINT_WORDS", contract::dart_throwing::POINT_WORDS(3)},
    {"common/darts/dart_throwing.h", "PARENT_WORDS", contract::dart_throwing::PARENT_WORDS(3, 1)},
    {"common/darts/dart_throwing.h", "MASK_WORDS", contract::dart_throwing::MASK_WORDS(3, 2)},
    {"common/darts/dart_throwing.h", "RIVAL_WORDS", contract::dart_throwing::RIVAL_WORDS},
    {"common/darts/dart_throwing.h", "COUNTERS", contract::dart_throwing::COUNTERS},
    {"common/darts/relaxation_dart_throwing.h", "POINT_WORDS", contract::relaxation_dart_throwing::POINT_WORDS(3, 2)},
};
// clang-format on
#undef LAYOUT

/// The values of expressions after a file, with the constants that it needs.
std::vector<std::uint32_t> on_device(Device& device, const std::string& file, const std::vector<const Shared*>& all)
{
    std::string text = kernel_source("kernels/" + file) + "kernel void tell(global uint* values) {";
    for (std::size_t i = 0; i < all.size(); ++i)
        text += " values[" + std::to_string(i) + "] = " + all[i]->expression + ";";
    auto values = device.buffer<std::uint32_t>(all.size());
    device.kernel_from_text(text + " }", "kernels/" + file, "tell", "-D DIMENSION=3 -D REACH=2 -D BRICKS=1 -D REGION=2")
        .run(1, 1, values);
    return values.read(0, all.size());
}

TEST(Contract, HoldsOnTheDevice)
{
    std::map<std::string, std::vector<const Shared*>> files; // a kernel each: names of different files may be equal
    for (const Shared& shared : all_shared) files[shared.file].push_back(&shared);
    Device device = Device::open();
    for (const auto& [file, all] : files) {
        const std::vector<std::uint32_t> values = on_device(device, file, all);
        for (std::size_t i = 0; i < all.size(); ++i)
            EXPECT_EQ(values[i], all[i]->value) << file << ": " << all[i]->expression;
    }
}

}
}
