// All that the points of `tiles points` are made from: the tile set, the window, torus or region, and the density.
#pragma once

#include "app/commands/tiles/window_points.hpp"
#include "app/commands/work_options.hpp"
#include "base/points/placed_file.hpp"
#include "base/regions/region_reading.hpp"
#include "base/regions/region_source.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct TilesPointsOptions
{
    std::filesystem::path file;       ///< the tile set
    std::vector<std::int64_t> window; ///< X Y W H; 3D: X Y Z W H D
    std::uint32_t torus = 0;          ///< tiles along each axis; 0: a window of the plane
    std::string region;               ///< instead of both: see read_region()
    RegionReading reading;            ///< of the region
    std::string overlap;              ///< the word for its overlaps; empty: the default
    double min_distance = 0;          ///< in the region's units; 0: as `points` wants it
    std::uint64_t points = 0;         ///< of the region; 0: as many as there are
    std::uint32_t seed = 1;
    std::string density = "1"; ///< a number, the name of a picture, or a formula
    std::string density_from = "light";
    std::filesystem::path out;
    bool as_json = false;
    WorkOptions work;
};

/// Checks the options that belong to a region of a set of this dimension. Throws InputError, a line that begins with
/// the command.
void check_region_options(const TilesPointsOptions& options, int dimension);

/// Returns the line of a file that says how it was made. `coordinates` are words on what they are.
std::string comment_of(const TilesPointsOptions& options, const std::string& coordinates);

/// Reads the region of --region. Throws InputError, a line that begins with the command.
PlaneRegion read_points_region(const TilesPointsOptions& options);

/// Reads the tile set and checks the options. With --points it looks for the width of tiles.
class TilePointsWork
{
public:
    /// The options must outlive this. Throws InputError, a line that begins with the command.
    explicit TilePointsWork(const TilesPointsOptions& options);

    /// The sentences on what was made of the region's file.
    const std::vector<std::string>& notes() const { return notes_of(plane_); }

    /// Returns the region as its file has it, or nullptr where there is none.
    const PlaneRegion* plane() const { return tiled_ ? &plane_ : nullptr; }

    const TiledRegion* region() const { return tiled_.get(); } ///< nullptr: there is none

    bool has_classes() const { return !tiles_.parameters.classes.is_empty(); }

    /// The minimum distance of points in the region, in its units.
    double min_distance() const;

    std::filesystem::path out;           ///< the file, as its writer needs it
    PointFileHead head{.unit = "tiles"}; ///< without the number of points
    std::optional<WindowPoints> points;

private:
    void set_up_block();
    void set_up_region();
    void lay_tiles(double width);
    void set_density(const DensityArea& area);
    void open_stream(const TileBlock& block);

    const TilesPointsOptions& options_;
    PoissonTileSet tiles_;
    std::optional<WindowDensity> density_;
    PlaneRegion plane_; ///< the region as it was read
    std::shared_ptr<const FixedRegion> region_;
    std::shared_ptr<const TiledRegion> tiled_;
    UnitStream stream_;
};

}
