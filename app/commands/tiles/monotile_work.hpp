// The commands of tiles for sets of aperiodic monotiles: `tiles verify`, `tiles page`, and the windows and regions of
// `tiles points`.
#pragma once

#include "app/commands/tiles/tile_points_work.hpp"
#include "host/tile_points/monotile_region.hpp"
#include "tiles/poisson/monotile_points_file.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// Proves the distances of a file and prints what was proven. Throws InputError.
void verify_monotile(const std::filesystem::path& file, bool as_json);

/// Returns the page of `tiles page`. `name` is that of the file. Throws InputError.
std::string monotile_page(const std::string& bytes, const std::string& name);

/// The points of a window, in strips from south to north, counted from its lowest corner in units of edges; or those of
/// a region, in its units. Each strip is in the order of the tiles' divisions.
class MonotileWindow final : public PiecedPoints
{
public:
    /// The options must outlive this. Throws InputError, a line that begins with the command.
    explicit MonotileWindow(const TilesPointsOptions& options);

    std::uint32_t pieces() const override { return pieces_; }
    bool has_known_counts() const override { return false; }
    std::uint64_t least_points() const override { return 0; }
    std::uint64_t count(std::uint32_t piece) override;
    void make(std::uint32_t piece, std::vector<double>& coordinates, std::vector<std::uint32_t>* classes) override;

    std::filesystem::path out;           ///< the file, as its writer needs it
    PointFileHead head{.unit = "edges"}; ///< without the number of points

    double min_distance() const; ///< in units of the file's coordinates

    /// Returns the length of an edge in the region's units; nothing where there is no region.
    std::optional<double> edge() const;

    /// Returns the region as its file has it, or nullptr where there is none.
    const PlaneRegion* plane() const { return laid_ ? &plane_ : nullptr; }

    /// Returns the sentences on what was made of the region's file.
    const std::vector<std::string>& notes() const { return notes_of(plane_); }

private:
    void set_up_window();
    void set_up_region();
    std::vector<pmono_point> points_of(std::uint32_t piece) const;
    std::vector<double> kept_points(std::uint32_t piece) const;

    const TilesPointsOptions& options_;
    MonotilePointsFile file_;
    std::array<std::int64_t, 4> window_{}; ///< the lowest corner, and the size
    PlaneRegion plane_;                    ///< the region as it was read
    std::optional<MonotileRegion> laid_;   ///< it with tiles
    std::optional<WindowDensity> density_;
    double strip_ = 1; ///< the height of a strip
    std::uint32_t pieces_ = 1;
};

}
