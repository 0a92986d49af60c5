#include "tiles/poisson/monotile_points_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <fstream>

namespace poissonlab {
namespace {

constexpr std::string_view monotile_start("PTILES\r\n\4\0\0\0", 12);
constexpr std::size_t checksum_at = 120, levels_at = 36, first_unused = 84;
constexpr std::uint32_t most_ancestors = 2;

}

bool is_monotile_points(std::string_view bytes) { return bytes.starts_with(monotile_start); }

bool is_monotile_points_file(const std::filesystem::path& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    std::string start(monotile_start.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    return file.read(start.data(), static_cast<std::streamsize>(start.size())) && is_monotile_points(start);
}

MonotilePointsFile::MonotilePointsFile(std::string bytes, std::string name)
    : bytes_(std::make_shared<const std::string>(std::move(bytes))), name_(std::move(name))
{
    const auto refused = [&](const std::string& what) { return InputError(what).moved_to({name_}); };
    if (const char* problem = pmono_open(&set_, bytes_->data(), bytes_->size()))
        throw refused(fmt::format("is damaged: {}", problem));
    const auto stored = load<std::uint64_t>(std::string_view(*bytes_).substr(checksum_at), std::endian::little);
    const std::uint64_t found = tile_file_checksum(*bytes_);
    if (found != stored)
        throw refused(fmt::format("is damaged: its checksum is {:016x}, must be {:016x}", found, stored));
    levels_ = load<std::uint32_t>(std::string_view(*bytes_).substr(levels_at), std::endian::little);
    if (levels_ > most_ancestors)
        throw refused(fmt::format("ancestors = {}: must be at most {}", levels_, most_ancestors));
    if (const double largest = max_min_distance(1, 2) * 65536, squared = largest * largest / density();
        static_cast<double>(set_.squared_min_distance) > squared)
        throw refused(
            fmt::format("guaranteed squared minimum distance {}: must be at most {:.0f} with {} points per tile",
                        set_.squared_min_distance, std::floor(squared), set_.points_per_tile));
    if (bytes_->substr(first_unused, checksum_at - first_unused).find_first_not_of('\0') != std::string::npos)
        throw refused(fmt::format("reserved bytes {} to {}: must be 0", first_unused, checksum_at - 1));
}

double MonotilePointsFile::density() const
{
    const double root = std::sqrt(3.0);
    return set_.points_per_tile / (set_.tiling == 0 ? 8 * root : 3 + 3 * root);
}

double MonotilePointsFile::relative_radius() const
{
    return pmono_min_distance(&set_) * std::sqrt(density()) / max_min_distance(1, 2);
}

std::vector<pmono_point> MonotilePointsFile::in_window(std::uint32_t seed, const std::array<std::int64_t, 2>& origin,
                                                       const std::array<double, 2>& low,
                                                       const std::array<double, 2>& high, double density) const
{
    const auto find = [&](std::vector<pmono_point>& points) {
        return pmono_in_window(&set_, seed, origin.data(), low.data(), high.data(), points.data(), points.size(),
                               density);
    };
    std::vector<pmono_point> points;
    points.resize(find(points));
    find(points);
    return points;
}

std::array<double, 2> MonotilePointsFile::step() const { return {1, set_.tiling == 0 ? std::sqrt(3.0) : 1}; }

MonotilePointsFile read_monotile_points(const std::filesystem::path& path)
{
    return {read_whole_file(path), path.string()};
}

}
