// Dart throwing on surfaces with classes of points: each class and all together are even.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010, section 3, on the pieces of triangles of Cline, Jeschke, White,
// Razdan, Wonka, Dart throwing on surfaces, EGSR 2009. Points come one after the other, each of the class that is least
// filled: darts of that class are thrown until one is far enough from all points, by a distance for each pair of
// classes, straight through space, unless the normals of their triangles are farther apart than an angle. A class is
// full when no further point of it fits, which is proven as for one kind (surface_darts.hpp): then the others go on.
//
// The darts of a slot, the place of one point, fall on pieces of triangles that may have room for its class: all of the
// surface at first, and, each time that TRIES darts of a slot failed, halves of what no single point covers. Classes
// may have densities: then pieces have weights, areas times the density, and are in an order in which neighbours are
// near each other, and the darts of slots aim at places that are evenly spread over the weights, as in regions of the
// plane (host/sampling/classes/class_darts.hpp).
#pragma once

#include "base/geometry/class_distances.hpp"
#include "host/sampling/surfaces/surface_darts.hpp"
#include "kernels/common/surfaces/class_surface.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace poissonlab {

/// A number of at least 0 at places on a surface.
using SurfaceWeight = std::function<double(const SurfacePoint& place)>;

struct ClassSurfaceRequest
{
    std::shared_ptr<const FixedSurface> surface;
    ClassDistances distances;          ///< in the mesh's units
    double angle = 180;                ///< degrees between normals of points that see each other
    std::vector<double> shares{};      ///< see FillOrder
    std::vector<std::size_t> points{}; ///< of each class, where it stops; empty: at saturation
    double factor = 1;                 ///< all distances are multiplied by it where a class with an end is full
    StreamKey stream{};
    std::vector<SurfaceWeight> densities{}; ///< of each class, in any unit; empty: points fall by area
};

struct ClassSurfaceDarts
{
    std::vector<SurfacePoint> points;   ///< in the order in which they came
    std::vector<std::uint32_t> classes; ///< of each point
    std::vector<bool> is_full;          ///< of each class: no further point of it fits, proven
    double scale = 1;                   ///< what all distances have been multiplied by
    double small_area = 0; ///< of pieces within the limit that are not proven to be covered, see surface_darts.hpp

    std::vector<std::size_t> counts() const; ///< points of each class
    std::vector<SurfacePoint> of_class(std::uint32_t wanted) const;
};

// Pieces that follow a density: all of the surface is divided into some 10^5, and each has the mean of the density at
// three places in it, which is exact for quadratic functions.

struct WeightedPieces
{
    std::vector<SurfacePiece> pieces; ///< those whose weight is not 0
    std::vector<double> weights;      ///< of each: its area times the density in it, over the largest of all
    double fullness = 1;              ///< the mean density over the largest one
};

/// Pieces no larger than 2^-16 of the surface, in an order in which neighbours are near each other (Morton's).
std::vector<SurfacePiece> small_pieces(const FixedSurface& surface);

WeightedPieces weighted_pieces(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                               const SurfaceWeight& density);

/// Pieces that may have room for a class, and the table by which darts find theirs.
struct ClassPieces
{
    std::vector<SurfacePiece> pieces;
    SurfacePieceChoice choice;
    std::uint32_t spread = 0; ///< see OpenPieces
};

/// When points of two classes are in conflict, and where the cells of the second one are: a row for each class.
using ClassSurfaceRules = std::vector<contract::surface::SurfaceRule>;

/// The rules of these distances, and of buckets for so many points of each class.
ClassSurfaceRules class_surface_rules(const FixedSurface& surface, const ClassDistances& distances, double angle,
                                      const std::vector<std::size_t>& points);

/// Slots that are settled together, at most.
inline constexpr std::size_t most_surface_slots = 65'536;

/// An engine fills slots and covers pieces; kernels and the plain twin do the same.
class ClassSurfaceEngine
{
public:
    virtual ~ClassSurfaceEngine() = default;

    /// Begins anew with these points, which keep other distances now, and room for `capacity`.
    virtual void restart(const ClassSurfaceRules& rules, const ClassSurfaceDarts& darts, std::size_t capacity) = 0;

    /// The pieces of class `own` are others than before. `all` stays until the engine goes.
    virtual void set_pieces(const std::vector<ClassPieces>& all, std::size_t own) = 0;

    /// The points of the first slots, in order, up to a slot all of whose darts failed.
    struct Settled
    {
        std::vector<SurfacePoint> points;
        std::size_t redrawn = 0; ///< slots whose first dart met another one of the batch
    };

    /// Fills slots number first, first + 1, ... `skipped` darts of the first one failed before.
    virtual Settled settle(const std::vector<contract::class_surface::SurfaceSlot>& slots, std::size_t first,
                           std::uint32_t skipped) = 0;

    /// The state (PieceState) of each piece of a class.
    virtual std::vector<std::uint32_t> cover(std::uint32_t own) = 0;
};

/// Throws the darts with an engine. `on_points` is told how many there are. Throws InputError where a density is 0
/// everywhere, or a distance too small for the mesh.
ClassSurfaceDarts throw_class_surface_darts(const ClassSurfaceRequest& request, ClassSurfaceEngine& engine,
                                            const std::function<void(std::size_t points)>& on_points = {});

namespace reference {
/// Dart number `number` of the slot that would make point number `at`. `open` has the pieces of the slot's class.
SurfacePoint class_surface_dart(const FixedSurface& surface, const ClassPieces& open,
                                const contract::class_surface::SurfaceSlot& slot, std::uint32_t at,
                                std::uint32_t number, const StreamKey& stream);

/// Plain and sequential: what the kernels must reproduce.
std::unique_ptr<ClassSurfaceEngine> class_surface_engine(const ClassSurfaceRequest& request);
}

/// Makes an engine by kernels/surfaces/class_surface_darts.cl: every device finds the bytes of the reference.
/// `work_group_size` 0: the default.
std::unique_ptr<ClassSurfaceEngine> class_surface_engine(const ClassSurfaceRequest& request, const Device& device,
                                                         std::size_t work_group_size = 0);

/// The memory that so many points of so many classes take of a device, nearly: chance decides how many pieces there
/// are.
DeviceMemory class_surface_memory(const FixedSurface& surface, std::size_t points, std::size_t classes);

}
