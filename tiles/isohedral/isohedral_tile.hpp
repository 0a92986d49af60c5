// A tile of an isohedral type with its parameters and curves, and the tiling with it.
#pragma once

#include "tiles/isohedral/isohedral_types.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace poissonlab {

/// A polyline from (0, 0) to (1, 0); y > 0 is inside of the first tile that has it.
using PlaneCurve = std::vector<PlanePoint>;

/// A curve as an edge of a kind may have it: that of a straight edge is straight; the first half of a turned edge is
/// the curve at half its size and the rest is that after half a turn; the first half of a mirrored one is the curve
/// half as wide, and the rest its reflection.
PlaneCurve shaped_curve(const PlaneCurve& curve, EdgeShape shape);

/// A smooth random curve that leaves the straight line by about `amplitude`.
PlaneCurve random_curve(std::uint64_t seed, std::uint32_t number, double amplitude);

struct IsohedralParameters
{
    std::vector<double> deformations; ///< one for each parameter of the type, in inradii of the Laves tile; missing: 0
    std::vector<PlaneCurve> curves;   ///< one for each curve of the type; missing: straight
};

/// A place in the tiling.
struct TilePlace
{
    std::uint32_t aspect = 0;
    std::int32_t column = 0; ///< along T1
    std::int32_t row = 0;    ///< along T2

    bool operator==(const TilePlace&) const = default;
};

class IsohedralTile
{
public:
    /// Throws InputError for more or fewer parameters than the type has, numbers that are not finite, edges shorter
    /// than a thousandth, and tiles whose outline crosses itself.
    IsohedralTile(const IsohedralType& type, const IsohedralParameters& parameters);

    const std::vector<PlanePoint>& corners() const { return corners_; }
    /// The whole outline, counterclockwise, without its first point again.
    const std::vector<PlanePoint>& outline() const { return outline_; }
    const std::vector<PlaneMotion>& hops() const { return hops_; }
    /// The motions from the tile to the aspects of the unit at (0, 0).
    const std::vector<PlaneMotion>& aspects() const { return aspects_; }
    const std::array<PlanePoint, 2>& translations() const { return translations_; }

    /// The motion from the tile to a tile of the tiling.
    PlaneMotion motion(const TilePlace& place) const;

    /// The tile across an edge of a tile.
    TilePlace neighbour(const TilePlace& place, std::size_t edge) const;

    /// The tile to which the motion across an edge of the first tile takes a tile.
    TilePlace image(const TilePlace& place, std::size_t edge) const;

    /// All tiles that may meet a rectangle: those in units whose tiles may reach it.
    std::vector<TilePlace> tiles_near(const PlanePoint& low, const PlanePoint& high) const;

private:
    TilePlace place_of(const PlaneMotion& motion) const;

    const IsohedralType* type_;
    std::vector<PlanePoint> corners_;
    std::vector<PlanePoint> outline_;
    std::vector<PlaneMotion> hops_;
    std::vector<PlaneMotion> aspects_;
    std::array<PlanePoint, 2> translations_;
};

/// A tile with random parameters and curves: parameters up to `deformation` and curves of about `amplitude`, both
/// a tenth smaller again and again until the outline does not cross itself.
IsohedralTile random_tile(const IsohedralType& type, std::uint64_t seed, double deformation, double amplitude);

/// The deformation and amplitude of random tiles that people look at: types can be told apart.
inline constexpr double drawn_deformation = 0.5;
inline constexpr double drawn_amplitude = 0.3;

/// True where two parts of a closed polyline that do not follow each other meet.
bool crosses_itself(const std::vector<PlanePoint>& outline);

/// A colouring that repeats with the translations: the colour of aspect k at (column, row) is
/// p2^row(p1^column(aspects[k])) for two permutations of the colours (Kaplan's notes, section 7.4.1), or aspects[k] +
/// column * step1 + row * step2 modulo `colors`, which are cyclic shifts.
struct TileColoring
{
    std::uint32_t colors = 1;
    std::vector<std::uint32_t> aspects;
    std::array<std::uint32_t, 2> steps{};
    std::array<std::vector<std::uint32_t>, 2> permutations{}; ///< none: shifts by `steps`
    bool is_perfect = false; ///< every symmetry of the tiling maps tiles of one colour to tiles of one colour

    std::uint32_t of(const TilePlace& place) const;
};

/// True if no two neighbours across an edge have the same colour, anywhere in the tiling.
bool is_proper(const IsohedralTile& tile, const TileColoring& coloring);

/// True if every symmetry of the tiling that its type has maps tiles of one colour to tiles of one colour, and those of
/// different colours to different colours.
bool is_perfect(const IsohedralTile& tile, const TileColoring& coloring);

/// A colouring with the fewest colours in which no two neighbours across an edge have the same, perfect if one with as
/// many colours is, or with one more.
TileColoring proper_coloring(const IsohedralTile& tile);

}
