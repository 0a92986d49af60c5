// A tile set file with the points of a monotile's tilings, kind 3: its bytes, and windows of its points by
// runtime/monotile_points.h. tiles/monotiles/monotile_file.hpp writes such files.
#pragma once

#include "runtime/monotile_points.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace poissonlab {

// These are the limits of windows in edges: the place of an origin, and the distance of a window's corners from it.

inline constexpr std::int64_t farthest_monotile_origin = std::int64_t{1} << 40;
inline constexpr std::int64_t farthest_monotile_corner = std::int64_t{1} << 20;

/// True if these are the first bytes of such a file.
bool is_monotile_points(std::string_view bytes);

/// True if a file begins so. False where it cannot be read.
bool is_monotile_points_file(const std::filesystem::path& path);

class MonotilePointsFile
{
public:
    /// Checks the checksum and all numbers that windows depend on. Throws InputError, a line that begins with `name`.
    MonotilePointsFile(std::string bytes, std::string name);

    const pmono_set& set() const { return set_; }
    const std::string& bytes() const { return *bytes_; }
    const std::string& name() const { return name_; }
    std::string tiling() const { return set_.tiling == 0 ? "hat" : "spectre"; }
    std::uint32_t levels() const { return levels_; } ///< the number of ancestors that decide a tile's points

    /// Returns the number of points per unit of area: the area of a hat is 8 sqrt(3), that of a spectre 3 + 3 sqrt(3).
    double density() const;

    double relative_radius() const; ///< of the minimum distance that the file promises

    /// Returns the points p with low <= p < high along each axis and a level below the density, seen from an origin:
    /// see pmono_in_window(), which has none where places are too far away.
    std::vector<pmono_point> in_window(std::uint32_t seed, const std::array<std::int64_t, 2>& origin,
                                       const std::array<double, 2>& low, const std::array<double, 2>& high,
                                       double density = 1) const;

    /// The length of a step of an origin along each axis, in edges.
    std::array<double, 2> step() const;

private:
    std::shared_ptr<const std::string> bytes_; ///< which the set points to
    std::string name_;
    pmono_set set_{};
    std::uint32_t levels_ = 0;
};

/// Reads a file. Throws InputError.
MonotilePointsFile read_monotile_points(const std::filesystem::path& path);

}
