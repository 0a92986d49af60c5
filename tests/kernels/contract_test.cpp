// Structs that kernels are told by value have the same layout on the device, and constants the same values.
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

namespace poissonlab {
namespace {

using testing::ElementsAreArray;

/// The values of expressions of OpenCL C, after a file and with the constants that it needs.
std::vector<std::uint32_t> on_device(const std::string& file, const std::vector<std::string>& expressions)
{
    std::string text = kernel_source(file) + "kernel void tell(global uint* values) {";
    for (std::size_t i = 0; i < expressions.size(); ++i)
        text += " values[" + std::to_string(i) + "] = " + expressions[i] + ";";
    Device device = Device::open();
    auto values = device.buffer<std::uint32_t>(expressions.size());
    device.kernel_from_text(text + " }", file, "tell", "-D DIMENSION=3 -D REACH=2 -D BRICKS=1 -D REGION=2")
        .run(1, 1, values);
    return values.read(0, expressions.size());
}

#define LAYOUT_OF(type, last) sizeof(type), offsetof(type, last)

std::vector<std::string> layout_of(const std::string& type, const std::string& last)
{
    return {"sizeof(struct " + type + ")", "__builtin_offsetof(struct " + type + ", " + last + ")"};
}

TEST(Contract, OfClassDarts)
{
    using namespace contract::class_darts;
    const std::size_t batch[] = {LAYOUT_OF(SlotBatch, key_y)};
    EXPECT_THAT(on_device("kernels/common/darts/class_darts.h", layout_of("SlotBatch", "key_y")),
                ElementsAreArray(batch));
    const std::size_t pair[] = {LAYOUT_OF(ClassPair, reach)};
    EXPECT_THAT(on_device("kernels/common/darts/class_darts.h", layout_of("ClassPair", "reach")),
                ElementsAreArray(pair));
    const std::size_t cells[] = {LAYOUT_OF(ClassCells, spread)};
    EXPECT_THAT(on_device("kernels/common/darts/class_darts.h", layout_of("ClassCells", "spread")),
                ElementsAreArray(cells));
    const std::size_t covered[] = {LAYOUT_OF(CoveredCells, count)};
    EXPECT_THAT(on_device("kernels/common/darts/class_darts.h", layout_of("CoveredCells", "count")),
                ElementsAreArray(covered));
    const std::size_t slot[] = {LAYOUT_OF(ClassSlot, target)};
    EXPECT_THAT(on_device("kernels/common/darts/class_darts.h", layout_of("ClassSlot", "target")),
                ElementsAreArray(slot));
}

TEST(Contract, OfLloydSets)
{
    const std::size_t sets[] = {LAYOUT_OF(contract::lloyd_sets::Sets, moves)};
    EXPECT_THAT(on_device("kernels/common/lloyd_sets.h", layout_of("Sets", "moves")), ElementsAreArray(sets));
}

TEST(Contract, OfSurfaces)
{
    using namespace contract::surface;
    const std::string file = "kernels/common/surfaces/surface.h";
    const std::size_t triangle[] = {LAYOUT_OF(Triangle, normal)};
    EXPECT_THAT(on_device(file, layout_of("Triangle", "normal")), ElementsAreArray(triangle));
    const std::size_t piece[] = {LAYOUT_OF(Piece, shares)};
    EXPECT_THAT(on_device(file, layout_of("Piece", "shares")), ElementsAreArray(piece));
    const std::size_t point[] = {LAYOUT_OF(SurfacePoint, next)};
    EXPECT_THAT(on_device(file, layout_of("SurfacePoint", "next")), ElementsAreArray(point));
    const std::size_t rule[] = {LAYOUT_OF(SurfaceRule, first)};
    EXPECT_THAT(on_device(file, layout_of("SurfaceRule", "first")), ElementsAreArray(rule));
    const std::size_t batch[] = {LAYOUT_OF(SurfaceBatch, bucket_mask)};
    EXPECT_THAT(on_device(file, layout_of("SurfaceBatch", "bucket_mask")), ElementsAreArray(batch));
    using contract::surface_elimination::Elimination;
    const std::size_t elimination[] = {LAYOUT_OF(Elimination, points)};
    EXPECT_THAT(on_device("kernels/common/surfaces/surface_elimination.h", layout_of("Elimination", "points")),
                ElementsAreArray(elimination));
    using namespace contract::class_surface;
    const std::string of_classes = "kernels/common/surfaces/class_surface.h";
    const std::size_t open[] = {LAYOUT_OF(OpenPieces, spread)};
    EXPECT_THAT(on_device(of_classes, layout_of("OpenPieces", "spread")), ElementsAreArray(open));
    const std::size_t slot[] = {LAYOUT_OF(SurfaceSlot, target)};
    EXPECT_THAT(on_device(of_classes, layout_of("SurfaceSlot", "target")), ElementsAreArray(slot));
    const std::size_t slots[] = {LAYOUT_OF(SurfaceSlots, key_y)};
    EXPECT_THAT(on_device(of_classes, layout_of("SurfaceSlots", "key_y")), ElementsAreArray(slots));
}

TEST(Contract, OfDartThrowing)
{
    using namespace contract::dart_throwing;
    const std::size_t layout[] = {LAYOUT_OF(Batch, staged_capacity)};
    EXPECT_THAT(on_device("kernels/common/darts/dart_throwing.h", layout_of("Batch", "staged_capacity")),
                ElementsAreArray(layout));
    const std::size_t slabs[] = {LAYOUT_OF(Slabs, is_rest)};
    EXPECT_THAT(on_device("kernels/common/darts/dart_throwing.h", layout_of("Slabs", "is_rest")),
                ElementsAreArray(slabs));
    const std::size_t constants[] = {DART_WORDS(3),    POINT_WORDS(3), PARENT_WORDS(3, 1),
                                     MASK_WORDS(3, 2), RIVAL_WORDS,    COUNTERS};
    EXPECT_THAT(on_device("kernels/common/darts/dart_throwing.h",
                          {"DART_WORDS", "POINT_WORDS", "PARENT_WORDS", "MASK_WORDS", "RIVAL_WORDS", "COUNTERS"}),
                ElementsAreArray(constants));
}

TEST(Contract, OfGradientDomain)
{
    const std::size_t layout[] = {LAYOUT_OF(contract::gradient_domain::GradientDomainSizes, relaxation)};
    EXPECT_THAT(on_device("kernels/common/fields/gradient_domain.h", layout_of("GradientDomainSizes", "relaxation")),
                ElementsAreArray(layout));
}

TEST(Contract, OfTextureMap)
{
    const std::size_t view[] = {LAYOUT_OF(contract::texture_map::TextureView, filter)};
    EXPECT_THAT(on_device("kernels/common/fields/texture_map.h", layout_of("TextureView", "filter")),
                ElementsAreArray(view));
    const std::size_t levels[] = {LAYOUT_OF(contract::texture_map::TextureLevels, offsets)};
    EXPECT_THAT(on_device("kernels/common/fields/texture_map.h", layout_of("TextureLevels", "offsets")),
                ElementsAreArray(levels));
}

TEST(Contract, OfEndlessTexture)
{
    const std::size_t plane[] = {LAYOUT_OF(contract::endless_texture::EndlessPlane, axes)};
    EXPECT_THAT(on_device("kernels/common/fields/endless_texture.h", layout_of("EndlessPlane", "axes")),
                ElementsAreArray(plane));
    const std::size_t window[] = {LAYOUT_OF(contract::endless_texture::EndlessWindow, height)};
    EXPECT_THAT(on_device("kernels/common/fields/endless_texture.h", layout_of("EndlessWindow", "height")),
                ElementsAreArray(window));
}

TEST(Contract, OfEndlessMap)
{
    const std::size_t levels[] = {LAYOUT_OF(contract::endless_map::ExemplarLevels, offsets)};
    EXPECT_THAT(on_device("kernels/common/fields/endless_map.h", layout_of("ExemplarLevels", "offsets")),
                ElementsAreArray(levels));
}

TEST(Contract, OfRelaxationDartThrowing)
{
    const std::size_t layout[] = {LAYOUT_OF(contract::relaxation_dart_throwing::Settling, unused)};
    const std::string file = "kernels/common/darts/relaxation_dart_throwing.h";
    EXPECT_THAT(on_device(file, layout_of("Settling", "unused")), ElementsAreArray(layout));
    const std::size_t squares[] = {LAYOUT_OF(contract::relaxation_dart_throwing::DartSquares, block_bits)};
    EXPECT_THAT(on_device(file, layout_of("DartSquares", "block_bits")), ElementsAreArray(squares));
    const std::size_t point_words[] = {contract::relaxation_dart_throwing::POINT_WORDS(3, 2)};
    EXPECT_THAT(on_device(file, {"POINT_WORDS"}), ElementsAreArray(point_words));
}

TEST(Contract, OfTileFilling)
{
    using namespace contract::tile_filling;
    const std::string file = "kernels/common/tiles/tile_filling.h";
    const std::size_t darts[] = {LAYOUT_OF(Darts, attempts)};
    EXPECT_THAT(on_device(file, layout_of("Darts", "attempts")), ElementsAreArray(darts));
    const std::size_t relaxation[] = {LAYOUT_OF(Relaxation, max_moving)};
    EXPECT_THAT(on_device(file, layout_of("Relaxation", "max_moving")), ElementsAreArray(relaxation));
    const std::size_t repulsion[] = {LAYOUT_OF(Repulsion, monomials)};
    EXPECT_THAT(on_device(file, layout_of("Repulsion", "monomials")), ElementsAreArray(repulsion));
}

TEST(Contract, OfTilePoints)
{
    const std::size_t run[] = {LAYOUT_OF(contract::tile_points::Run, shift)};
    EXPECT_THAT(on_device("kernels/common/tiles/tile_points.h", layout_of("Run", "shift")), ElementsAreArray(run));
    const std::size_t window[] = {LAYOUT_OF(contract::tile_points::Window, bottom)};
    EXPECT_THAT(on_device("kernels/common/tiles/tile_points.h", layout_of("Window", "bottom")),
                ElementsAreArray(window));
}

TEST(Contract, OfVoronoiDarts)
{
    using namespace contract::voronoi_darts;
    const std::string file = "kernels/common/darts/voronoi_darts.h";
    const std::size_t torus[] = {LAYOUT_OF(Torus, near_offsets)};
    EXPECT_THAT(on_device(file, layout_of("Torus", "near_offsets")), ElementsAreArray(torus));
    const std::size_t batch[] = {LAYOUT_OF(Batch, key_y)};
    EXPECT_THAT(on_device(file, layout_of("Batch", "key_y")), ElementsAreArray(batch));
    const std::size_t offset[] = {LAYOUT_OF(Offset, squared_gap)};
    EXPECT_THAT(on_device(file, layout_of("Offset", "squared_gap")), ElementsAreArray(offset));
}

TEST(Contract, OfSectorDarts)
{
    using namespace contract::sector_darts;
    const std::string file = "kernels/common/sectors/sector_darts.h";
    const std::size_t rules[] = {LAYOUT_OF(SectorRules, steps)};
    EXPECT_THAT(on_device(file, layout_of("SectorRules", "steps")), ElementsAreArray(rules));
    const std::size_t set[] = {LAYOUT_OF(GrowingSet, free_sector)};
    EXPECT_THAT(on_device(file, layout_of("GrowingSet", "free_sector")), ElementsAreArray(set));
    const std::size_t kept[] = {LAYOUT_OF(KeptSector, next)};
    EXPECT_THAT(on_device(file, layout_of("KeptSector", "next")), ElementsAreArray(kept));
}

TEST(Contract, OfEarlyTiles)
{
    const std::size_t shift[] = {LAYOUT_OF(contract::averaged_tiles::CentroidShift, is_known)};
    EXPECT_THAT(on_device("kernels/common/tile_sampling/averaged_tiles.h", layout_of("CentroidShift", "is_known")),
                ElementsAreArray(shift));
    const std::string file = "kernels/common/tile_sampling/recursive_tiles.h";
    const std::size_t tile[] = {LAYOUT_OF(contract::recursive_tiles::RankedTile, begin)};
    EXPECT_THAT(on_device(file, layout_of("RankedTile", "begin")), ElementsAreArray(tile));
    const std::size_t level[] = {LAYOUT_OF(contract::recursive_tiles::RankedLevel, is_uniform)};
    EXPECT_THAT(on_device(file, layout_of("RankedLevel", "is_uniform")), ElementsAreArray(level));
}

TEST(Contract, OfGaussianBlueNoise)
{
    using contract::gaussian_blue_noise::Gaussians;
    const std::size_t layout[] = {LAYOUT_OF(Gaussians, unused)};
    EXPECT_THAT(on_device("kernels/common/optimized/gaussian_blue_noise.h", layout_of("Gaussians", "unused")),
                ElementsAreArray(layout));
    using contract::gaussian_blue_noise::DensityCell;
    const std::size_t cell[] = {LAYOUT_OF(DensityCell, is_empty)};
    EXPECT_THAT(on_device("kernels/common/optimized/gaussian_blue_noise.h", layout_of("DensityCell", "is_empty")),
                ElementsAreArray(cell));
}

TEST(Contract, OfSampleElimination)
{
    using namespace contract::sample_elimination;
    const std::string file = "kernels/common/optimized/sample_elimination.h";
    const std::size_t elimination[] = {LAYOUT_OF(Elimination, stride)};
    EXPECT_THAT(on_device(file, layout_of("Elimination", "stride")), ElementsAreArray(elimination));
    const std::size_t counts[] = {LAYOUT_OF(EliminationCounts, of_round)};
    EXPECT_THAT(on_device(file, layout_of("EliminationCounts", "of_round")), ElementsAreArray(counts));
}

TEST(Contract, OfDistributions)
{
    const std::size_t warping[] = {LAYOUT_OF(contract::warp::Warping, height)};
    EXPECT_THAT(on_device("kernels/common/fields/warp.h", layout_of("Warping", "height")), ElementsAreArray(warping));
    const std::size_t search[] = {LAYOUT_OF(contract::self_similar::StartSearch, capacity)};
    EXPECT_THAT(on_device("kernels/common/tiles/self_similar.h", layout_of("StartSearch", "capacity")),
                ElementsAreArray(search));
    const std::size_t instance_scene[] = {LAYOUT_OF(contract::instances::InstanceScene, models)};
    EXPECT_THAT(on_device("kernels/common/fields/instances.h", layout_of("InstanceScene", "models")),
                ElementsAreArray(instance_scene));
    const std::size_t instance_tiles[] = {LAYOUT_OF(contract::instances::InstanceTiles, below)};
    EXPECT_THAT(on_device("kernels/common/fields/instances.h", layout_of("InstanceTiles", "below")),
                ElementsAreArray(instance_tiles));
    const std::size_t placed[] = {LAYOUT_OF(contract::instances::PlacedInstance, unused)};
    EXPECT_THAT(on_device("kernels/common/fields/instances.h", layout_of("PlacedInstance", "unused")),
                ElementsAreArray(placed));
    const std::size_t tiles[] = {LAYOUT_OF(contract::objects::ObjectTiles, above)};
    EXPECT_THAT(on_device("kernels/objects.cl", layout_of("ObjectTiles", "above")), ElementsAreArray(tiles));
    const std::size_t scene[] = {LAYOUT_OF(contract::objects::ObjectScene, palette)};
    EXPECT_THAT(on_device("kernels/objects.cl", layout_of("ObjectScene", "palette")), ElementsAreArray(scene));
}

}
}
