// The tables [[scheme]] of a config become these checked settings: pictures, counts and tables of tilings and tile
// sets.
#pragma once

#include "host/settings/tilings/tiling_request.hpp"
#include "tiles/aperiodic/corner_constructions.hpp"
#include "tiles/isohedral/split_tile.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// kind = "corner-problem": what lies diagonally to a Wang tile and to a corner tile.
struct CornerProblemSettings
{
    Color colors = 2;
};

/// kind = "scanline": the scanline algorithm at work.
struct ScanlineStepsSettings
{
    TileKind tiles = TileKind::wang; ///< or corner
    Color colors = 2;
    bool is_compact = true;
};

/// kind = "direct": the colours of a lattice, and the tiles that they become.
struct DirectTilingSettings
{
    TilingRequest request;
    TileWindow window;
};

/// kind = "noise": Perlin's noise with the hash functions of tilings.
struct NoiseSettings
{
    std::uint32_t pixels = 384;
    std::uint32_t cells = 12; ///< of the lattice along each side of the picture
};

/// kind = "tiling-costs": hash evaluations and times a tile.
struct TilingCostSettings
{
    Color colors = 4;
    std::uint32_t tiles = 1 << 17; ///< of each measurement
};

/// kind = "construction": the lattices of Wang tiles and of the corner tiles that are made of them.
struct ConstructionSettings
{
    std::string set = "ammann"; ///< of Wang tiles: or "kari", "culik"
    CornerConstruction construction = CornerConstruction::diagonal;
    std::uint64_t width = 4, height = 3; ///< Wang tiles
};

/// kind = "aperiodic-tables": the printed tables beside the computed ones, and periods.
struct AperiodicTableSettings
{
    std::size_t width = 6; ///< the widest cylinder of the search
};

/// kind = "diffraction": how much tilings repeat.
struct DiffractionSettings
{
    std::vector<TilingRequest> tilings; ///< at least one
    std::uint64_t size = 512;           ///< tiles along each axis
    Color color = 0;
};

/// kind = "isohedral": a tiling of a type with parameters, curves and a colouring.
struct IsohedralSettings
{
    std::optional<int> type; ///< none: 16, or with a goal all that shapes can tell
    std::string goal;        ///< a region's file or description, which tiles are to look like; empty: none
    IsohedralParameters parameters;
    bool is_random = false;
    std::optional<TileColoring> coloring; ///< none: the fewest colours
    std::optional<TileSplit> split;
    double columns = 10, rows = 10; ///< of the window, in sides of a square as large as the tile
};

/// A tiling by polygons that the program brings, or one of a user.
struct PolygonTilingChoice
{
    std::string word;
    std::filesystem::path file; ///< empty: that of the word
};

/// The style in which polygons are drawn.
struct PolygonStyle
{
    std::string colors = "tiles";                     ///< or "directions"
    std::string edges = "straight";                   ///< or "puzzle"
    std::map<char, PlaneCurve> curves = {};           ///< by small letters of edges; for others `edges` holds
    std::optional<std::array<double, 4>> shifts = {}; ///< length and degrees of p and of q, for outlines that have them
    bool has_arcs = false;
    bool has_letters = false;
};

/// kind = "substitution": a tiling by substitution.
struct SubstitutionSettings
{
    PolygonTilingChoice tiling{"penrose-kite-dart", {}};
    std::string start; ///< empty: the first tile
    int depth = 5;
    std::vector<std::int64_t> address;           ///< of the tile in the middle of the window
    std::optional<std::array<double, 2>> place;  ///< in the middle of the window, instead of an address
    std::optional<std::array<double, 2>> window; ///< none: all tiles
    PolygonStyle style;
};

/// kind = "periodic": a periodic tiling by polygons.
struct PeriodicSettings
{
    PolygonTilingChoice tiling{"3.4.6.4", {}};
    std::array<double, 2> window{16, 12};
    bool shows_unit = true;
    PolygonStyle style;
};

/// kind = "bricks": pairs of bricks by the binary digits of pi.
struct BrickSettings
{
    std::uint32_t digits = 441;
};

/// kind = "surface": corner tiles on the faces of a polycube.
struct SurfaceSettings
{
    std::vector<std::array<int, 3>> cubes; ///< different ones, at least one
    Color colors = 3;
};

}
