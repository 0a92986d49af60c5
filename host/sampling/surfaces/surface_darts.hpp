// Dart throwing on surfaces: to a number of points, until no further one fits, or with a distance that shrinks until so
// many fit.
//
// Cline, Jeschke, White, Razdan, Wonka, Dart throwing on surfaces, EGSR 2009, for the pieces that darts fall on. Two
// points are in conflict where they are nearer than the minimum distance, straight through space, unless the normals of
// their triangles are farther apart than an angle: the two sides of a thin sheet do not see each other.
//
// Darts come in batches, whose size follows from what was accepted so far. Where few of a batch are accepted, pieces
// are refined until a good part of their area is uncovered, as that batch tells: those that one disk covers are
// dropped. A set is saturated when no piece is left. All of the surface is
// then nearer to a point than the minimum distance, but for pieces that are within LIMIT units (2^-25 of the surface's
// size at most), whose centre is covered; their area is said, and is 0 but by rare chance.
#pragma once

#include "base/random/random.hpp"
#include "host/sampling/device_method.hpp"
#include "host/sampling/surfaces/fixed_surface.hpp"
#include "host/sampling/surfaces/surface_pieces.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace poissonlab {

// Buckets of cells of space, as kernels/common/surfaces/surface.clh has them.

/// A power of two. Blocks of 64 cells are used in part only, as surfaces cross them.
inline std::size_t surface_bucket_count(std::size_t points)
{
    return std::bit_ceil(std::max<std::size_t>(64, 4 * points));
}

/// The bucket of a place, of cells `cell` wide.
inline std::uint32_t surface_bucket(const SurfacePoint& point, std::uint32_t cell, std::uint32_t mask)
{
    const auto along = [&](int k) { return static_cast<std::uint32_t>(point.place[k]) / cell + 1; };
    const std::uint32_t x = along(0), y = along(1), z = along(2);
    std::uint32_t block = ((x >> 2) * 0x8da6b343u) ^ ((y >> 2) * 0xd8163841u) ^ ((z >> 2) * 0xcb1ab31fu);
    block = (block ^ (block >> 15)) * 0x2c1b3c6du;
    block ^= block >> 12;
    return (block << 6 | (z & 3) << 4 | (y & 3) << 2 | (x & 3)) & mask;
}

/// Points in the order of their buckets, and where each bucket begins.
struct SurfaceBucketOrder
{
    std::vector<std::uint32_t> ids, starts;
};
SurfaceBucketOrder surface_bucket_order(const std::vector<SurfacePoint>& points, std::uint32_t cell,
                                        std::uint32_t mask);

struct SurfaceDartRequest
{
    std::shared_ptr<const FixedSurface> surface;
    double min_distance = 0; ///< in the mesh's units: the first one, where it shrinks
    double angle = 180;      ///< degrees between normals of points that see each other
    std::size_t points = 0;  ///< 0: to saturation
    double shrinking = 1;    ///< what the distance is multiplied by when no further point fits; 1: it stays
    StreamKey stream{};
    std::vector<SurfacePoint> start = {};     ///< the first points of the set, however near to each other
    std::vector<SurfacePoint> obstacles = {}; ///< points that keep others away and do not belong to the set
};

struct SurfaceDarts
{
    std::vector<SurfacePoint> points; ///< points of the start, then others in the order in which they were accepted
    double min_distance = 0;          ///< that new points keep from all: the last one, where it shrinks
    bool is_saturated = false;        ///< no further point fits
    double small_area = 0;            ///< of pieces within the limit that are not proven to be covered
    std::uint64_t darts = 0;          ///< that were thrown
};

/// Distances below this part of the surface's size are refused: places have too few digits for them.
inline constexpr double least_part_of_size = 1e-5;

/// Converts a distance and an angle to units of the surface's grid.
contract::surface::SurfaceRule surface_rule(const FixedSurface& surface, double min_distance, double angle);

/// An engine throws darts and covers pieces; kernels and the plain twin do the same.
class SurfaceDartEngine
{
public:
    virtual ~SurfaceDartEngine() = default;

    /// Begins anew with these points, which keep another distance now, and room for `capacity`.
    virtual void restart(const contract::surface::SurfaceRule& rule, const std::vector<SurfacePoint>& points,
                         std::size_t capacity) = 0;
    virtual void set_pieces(const std::vector<SurfacePiece>& pieces) = 0;
    virtual void set_choice(const SurfacePieceChoice& choice) = 0; ///< of these pieces, before darts are thrown

    /// Throws darts number first, first + 1, ..., and accepts at most `most` of them. Returns these, in order; they
    /// are among the points now.
    virtual std::vector<SurfacePoint> throw_darts(std::uint64_t first, std::uint32_t darts, std::size_t most) = 0;

    /// The state of each piece that was set.
    virtual std::vector<std::uint32_t> cover() = 0;
};

/// Throws the darts with an engine. `on_points` is told how many there are. Throws InputError where there are more than
/// `most` points.
SurfaceDarts throw_surface_darts(const SurfaceDartRequest& request, SurfaceDartEngine& engine, std::size_t most,
                                 const std::function<void(std::size_t points)>& on_points = {});

namespace reference {
/// Plain and sequential: what the kernels must reproduce.
std::unique_ptr<SurfaceDartEngine> surface_dart_engine(const SurfaceDartRequest& request);

/// The place of two random words on a piece.
SurfacePoint surface_dart_on(const FixedSurface& surface, const SurfacePiece& piece, std::uint32_t u, std::uint32_t v);

/// The dart of a number.
SurfacePoint surface_dart(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                          const SurfacePieceChoice& choice, const StreamKey& stream, std::uint64_t number);
}

/// Makes an engine by kernels/surfaces/surface_darts.cl: every device finds the bytes of the reference.
/// `work_group_size` 0: the default.
std::unique_ptr<SurfaceDartEngine> surface_dart_engine(const SurfaceDartRequest& request, const Device& device,
                                                       std::size_t work_group_size = 0);

/// The memory that so many points take of a device, nearly: chance decides how many pieces there are.
DeviceMemory surface_dart_memory(const FixedSurface& surface, std::size_t points);

/// Returns nearly how many points a saturated set of this distance has, by the density of plane ones.
double saturated_count(double area, double min_distance);

}
