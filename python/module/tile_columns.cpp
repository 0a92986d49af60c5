#include "python/module/tile_columns.hpp"

#include "base/errors/errors.hpp"
#include "base/regions/region_source.hpp"
#include "base/regions/region_text.hpp"
#include "python/module/arrays.hpp"

#include <fmt/format.h>

#include <utility>

namespace py = pybind11;

namespace poissonlab {

PointColumns in_files(const PlaneRegion& region, PointColumns points)
{
    if (is_mapped(region)) region.source->map->to_file(points.positions);
    return points;
}

py::dict columns_of(PointColumns points)
{
    const auto count = static_cast<py::ssize_t>(points.ids.size());
    const auto dimension = static_cast<py::ssize_t>(points.dimension);
    py::dict columns;
    columns["position"] = array_of(std::move(points.positions), {count, dimension});
    columns["tile"] = array_of(std::move(points.tiles), {count, points.has_tiles ? dimension : 0});
    columns["index"] = array_of(std::move(points.indices));
    columns["id"] = array_of(std::move(points.ids));
    columns["level"] = array_of(std::move(points.levels));
    return columns;
}

PlaneRegion called_region(const std::string& text, bool is_planar, const std::string& crs, const std::string& overlap,
                          double buffer)
{
    const auto overlaps = polygon_overlap_names.find(overlap);
    if (!overlaps)
        throw InputError(fmt::format("in_region: overlap = {}: must be union or refuse", printable(overlap)));
    if (!(buffer >= 0 && buffer <= 1e12))
        throw InputError(fmt::format("in_region: buffer = {}: must be a number from 0 to 1e12", buffer));
    return read_region(text, {.is_planar = is_planar, .crs = crs, .overlap = *overlaps, .buffer = buffer});
}

void check_window_points(double points)
{
    constexpr double most = 1 << 27;
    if (points > most)
        throw InputError(fmt::format("window: some {:.0f} points: must be at most {:.0f}", points, most));
}

}
