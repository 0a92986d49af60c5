// Hats and spectres for Python: what runtime/monotile_points.h does, for arrays, and the proof of the minimum distance.
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "host/settings/tilings/polygon_tiling_file.hpp"
#include "host/tile_points/monotile_region.hpp"
#include "host/tile_points/tiled_region.hpp"
#include "python/module/arrays.hpp"
#include "python/module/module_parts.hpp"
#include "python/module/tile_columns.hpp"
#include "tiles/monotiles/monotile_file.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace py = pybind11;

namespace poissonlab {
namespace {

using EdgePlace = std::array<double, 2>;
using EdgeOrigin = std::array<std::int64_t, 2>;

void check_origin(const EdgeOrigin& origin)
{
    for (const std::int64_t number : origin)
        if (number < -farthest_monotile_origin || number > farthest_monotile_origin)
            throw InputError(fmt::format("origin = {}: must be from -2^40 to 2^40", number));
}

class OpenMonotileSet
{
public:
    explicit OpenMonotileSet(const std::filesystem::path& file)
        : file_(without_lock([&] { return read_monotile_points(file); }))
    {}

    py::dict parameters() const
    {
        py::dict parameters;
        parameters["kind"] = file_.tiling();
        parameters["dimension"] = 2;
        parameters["colors"] = 1;
        parameters["tiles"] = 1;
        parameters["points_per_tile"] = file_.set().points_per_tile;
        parameters["density"] = file_.density();
        parameters["unit"] = "edges";
        parameters["relative_radius"] = file_.relative_radius();
        parameters["min_distance"] = pmono_min_distance(&file_.set());
        parameters["exponent"] = pmono_exponent(&file_.set());
        parameters["ranked"] = true;
        parameters["class_points"] = py::list();
        return parameters;
    }

    py::dict window(const EdgePlace& low, const EdgePlace& high, std::uint32_t seed, double density,
                    const EdgeOrigin& origin) const
    {
        check_origin(origin);
        double points = file_.density();
        for (std::size_t axis = 0; axis < 2; ++axis) {
            check_place("window", low[axis]);
            check_place("window", high[axis]);
            if (!(low[axis] < high[axis])) throw InputError("window: its sizes must be above 0");
            points *= high[axis] - low[axis];
        }
        check_window_points(points);
        return columns_of(without_lock([&] { return columns(file_.in_window(seed, origin, low, high, density)); }));
    }

    /// The points in a region, in its units. Of `points` and `min_distance`, one is 0.
    py::dict in_region(const std::string& text, bool is_planar, const std::string& crs, const std::string& overlap,
                       double buffer, double min_distance, std::uint64_t points, std::uint32_t seed,
                       double density) const
    {
        return columns_of(without_lock([&] {
            const PlaneRegion plane = called_region(text, is_planar, crs, overlap, buffer);
            const auto region = std::make_shared<const FixedRegion>(plane);
            const RegionBox& box = region->box();
            const auto points_with = [&](double edge) {
                check_window_points(file_.density() * (box.width() / edge) * (box.height() / edge));
                return MonotileRegion(file_, region, edge).all_points(seed, density);
            };
            if (points == 0) return in_files(plane, columns(points_with(edge_for(min_distance, file_, box))));
            const double guess = std::sqrt(region->area() * file_.density() / static_cast<double>(points));
            const double edge =
                tile_width_for_points(points, guess, [&](double tried) { return points_with(tried).size(); });
            return in_files(plane, columns(points_with(edge)));
        }));
    }

    /// The nearest points of positions, and their distances.
    py::dict nearest(const AnyArray& positions, std::uint32_t seed, const EdgeOrigin& origin) const
    {
        if (positions.ndim() != 2 || positions.shape(1) != 2)
            throw InputError("nearest: positions must have the shape (positions, 2)");
        check_origin(origin);
        const auto count = static_cast<std::size_t>(positions.shape(0));
        const double* const at = positions.data();
        for (std::size_t i = 0; i < 2 * count; ++i) check_place("nearest", at[i]);
        std::vector<double> distances;
        PointColumns points(2, false);
        without_lock([&] {
            for (std::size_t i = 0; i < count; ++i) {
                if (i % 4096 == 0) stop_if_interrupted();
                const auto [point, distance] = nearest_point({at[2 * i], at[2 * i + 1]}, seed, origin);
                points.add(point);
                distances.push_back(distance);
            }
        });
        py::dict found = columns_of(std::move(points));
        found["distance"] = array_of(std::move(distances));
        return found;
    }

    py::dict verify() const
    {
        const double distance = without_lock(
            [&] { return proven_monotile_table(file_, built_in_tiling(file_.tiling())).distances.back().length(); });
        py::dict proven;
        proven["min_distance"] = distance;
        proven["squared_min_distance"] = file_.set().squared_min_distance;
        proven["relative_radius"] = file_.relative_radius();
        proven["largest_empty_radius"] = std::numeric_limits<double>::quiet_NaN();
        proven["tiles"] = 1;
        proven["points_per_tile"] = file_.set().points_per_tile;
        proven["class_distances"] = array_of(std::vector<double>{}, {0, 0});
        return proven;
    }

private:
    static PointColumns columns(const std::vector<pmono_point>& found)
    {
        PointColumns points(2, false);
        for (const pmono_point& point : found) points.add(point);
        return points;
    }

    /// Looks in larger and larger squares, until the nearest point is not farther than a square reaches.
    std::pair<pmono_point, double> nearest_point(const EdgePlace& from, std::uint32_t seed,
                                                 const EdgeOrigin& origin) const
    {
        for (double reach = 1 / std::sqrt(file_.density());; reach *= 2) {
            std::pair<pmono_point, double> nearest{{}, std::numeric_limits<double>::infinity()};
            for (const pmono_point& point : file_.in_window(seed, origin, {from[0] - reach, from[1] - reach},
                                                            {from[0] + reach, from[1] + reach})) {
                const double distance = std::hypot(point.position[0] - from[0], point.position[1] - from[1]);
                if (distance < nearest.second) nearest = {point, distance};
            }
            if (nearest.second < reach) return nearest;
            if (reach > farthest_search) throw InputError("nearest: no point is near: is the file damaged?");
        }
    }

    /// Windows are at most so far from their origin, and look a little farther.
    static void check_place(const char* function, double value)
    {
        constexpr double most = farthest_monotile_corner - 2 * farthest_search;
        if (!(value >= -most && value <= most))
            throw InputError(
                fmt::format("{0}: {1}: must be a number from -{2:.0f} to {2:.0f}, in edges", function, value, most));
    }

    static constexpr double farthest_search = 64;
    MonotilePointsFile file_;
};

}

void add_monotile_sets(py::module_& module)
{
    module.def("is_monotile_set", &is_monotile_points_file, py::arg("file"));
    py::class_<OpenMonotileSet>(module, "MonotileSet", "The points of hats or spectres.")
        .def(py::init<const std::filesystem::path&>(), py::arg("file"))
        .def("parameters", &OpenMonotileSet::parameters)
        .def("window", &OpenMonotileSet::window, py::arg("low"), py::arg("high"), py::arg("seed"), py::arg("density"),
             py::arg("origin"))
        .def("in_region", &OpenMonotileSet::in_region, py::arg("region"), py::arg("is_planar"), py::arg("crs"),
             py::arg("overlap"), py::arg("buffer"), py::arg("min_distance"), py::arg("points"), py::arg("seed"),
             py::arg("density"))
        .def("nearest", &OpenMonotileSet::nearest, py::arg("positions"), py::arg("seed"), py::arg("origin"))
        .def("verify", &OpenMonotileSet::verify);
}

}
