// The commands of tiles for sets of aperiodic monotiles: `tiles verify`, and the windows of `tiles points`.
#pragma once

#include "app/commands/tiles/tile_points_work.hpp"
#include "tiles/poisson/monotile_points_file.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab {

/// Proves the distances of a file and prints what was proven. Throws InputError.
void verify_monotile(const std::filesystem::path& file, bool as_json);

/// The points of a rectangle, in strips from south to north: each strip in the order of the tiles' divisions.
/// Coordinates are counted from the lowest corner of the window, in units of edges.
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
    double min_distance() const { return pmono_min_distance(&file_.set()); }

private:
    const TilesPointsOptions& options_;
    MonotilePointsFile file_;
    std::array<std::int64_t, 4> window_; ///< the lowest corner, and the size
    std::array<double, 2> size_;
    WindowDensity density_;
    double strip_ = 1; ///< the height of a strip
    std::uint32_t pieces_ = 1;
    std::vector<pmono_point> found_;
    std::vector<double> counted_;
};

}
