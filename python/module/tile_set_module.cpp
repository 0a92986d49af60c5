// Poisson disk tile sets for Python: what runtime/poisson_tiles.h does, for arrays, and the proof of the minimum
// distance.
#include "base/errors/errors.hpp"
#include "host/tile_points/tiled_region.hpp"
#include "python/module/arrays.hpp"
#include "python/module/module_parts.hpp"
#include "python/module/tile_columns.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace py = pybind11;

namespace poissonlab {
namespace {

using Corner = std::array<double, 3>;

class OpenTileSet
{
public:
    explicit OpenTileSet(const std::filesystem::path& file)
        : file_(file.string()), set_(without_lock([&] { return read_tile_set(file); }))
    {}

    py::dict parameters() const
    {
        const PoissonTileParameters& p = set_.parameters;
        py::dict parameters;
        parameters["kind"] = kind_name(p);
        parameters["dimension"] = p.dimension;
        parameters["colors"] = p.colors;
        parameters["tiles"] = p.tiles;
        parameters["points_per_tile"] = p.points_per_tile;
        parameters["density"] = static_cast<double>(p.points_per_tile);
        parameters["unit"] = "tiles";
        parameters["relative_radius"] = p.relative_radius;
        parameters["min_distance"] = std::sqrt(static_cast<double>(set_.squared_min_distance)) / 65536;
        parameters["exponent"] = 2 * (p.equal_moments + 1);
        parameters["ranked"] = p.ranked;
        parameters["class_points"] = p.classes.points;
        return parameters;
    }

    py::dict window(const Corner& low, const Corner& high, std::uint32_t seed, double density) const
    {
        check_window(low, high);
        return columns_of(without_lock([&] {
            const ptiles_tiling tiling = runtime_tiling(set_, {seed, 0});
            const std::uint64_t count = ptiles_in_window(&tiling, low.data(), high.data(), nullptr, 0, density);
            std::vector<ptiles_point> found(count);
            ptiles_in_window(&tiling, low.data(), high.data(), found.data(), count, density);
            PointColumns points(set_.parameters.dimension);
            for (const ptiles_point& point : found) points.add(point);
            return points;
        }));
    }

    /// The points in a region, in its units. Of `points` and `min_distance`, one is 0.
    py::dict in_region(const std::string& text, bool is_planar, const std::string& crs, const std::string& overlap,
                       double buffer, double min_distance, std::uint64_t points, std::uint32_t seed,
                       double density) const
    {
        if (set_.parameters.dimension != 2) throw InputError("in_region: these are tiles in space");
        return columns_of(without_lock([&] {
            const PlaneRegion plane = called_region(text, is_planar, crs, overlap, buffer);
            const auto region = std::make_shared<const FixedRegion>(plane);
            const ptiles_tiling tiling = runtime_tiling(set_, {seed, 0});
            const RegionBox& box = region->box();
            const double sure = tile_width_for(points > 0 ? 1 : min_distance, set_, box);
            const double tiles = static_cast<double>(points) / set_.parameters.points_per_tile;
            if (points == 0) return in_files(plane, points_in(region, tiling, sure, density));
            const auto count = [&](double tried) { return points_in(region, tiling, tried, density).ids.size(); };
            return in_files(plane, points_in(region, tiling,
                                             tile_width_for_points(points, std::sqrt(region->area() / tiles), count),
                                             density));
        }));
    }

    /// The nearest points of positions, and their distances.
    py::dict nearest(const AnyArray& positions, std::uint32_t seed) const
    {
        const int dimension = set_.parameters.dimension;
        if (positions.ndim() != 2 || positions.shape(1) != dimension)
            throw InputError(fmt::format("nearest: positions must have the shape (positions, {})", dimension));
        const auto count = static_cast<std::size_t>(positions.shape(0));
        const double* const at = positions.data();
        for (std::size_t i = 0; i < count * static_cast<std::size_t>(dimension); ++i) check_place("nearest", at[i]);
        std::vector<double> distances(count);
        PointColumns points(dimension);
        without_lock([&] {
            const ptiles_tiling tiling = runtime_tiling(set_, {seed, 0});
            for (std::size_t i = 0; i < count; ++i) {
                if (i % 65536 == 0) stop_if_interrupted();
                ptiles_point point;
                distances[i] = std::sqrt(ptiles_nearest(&tiling, at + i * static_cast<std::size_t>(dimension), &point));
                points.add(point);
            }
        });
        py::dict columns = columns_of(std::move(points));
        columns["distance"] = array_of(std::move(distances));
        return columns;
    }

    py::dict verify() const
    {
        const TileCertificate c = without_lock([&] {
            try {
                const TileCertificate certificate = certify(set_);
                check_promises(set_.parameters, set_.squared_min_distance, certificate);
                check_class_promises(set_.parameters.classes, set_.class_squared_distances, certificate.classes);
                return certificate;
            } catch (const InputError& error) {
                throw error.moved_to({file_});
            }
        });
        py::dict proven;
        proven["min_distance"] = std::sqrt(static_cast<double>(c.squared_min_distance)) / tile_units;
        proven["squared_min_distance"] = c.squared_min_distance;
        proven["relative_radius"] = c.relative_radius;
        proven["largest_empty_radius"] = c.largest_empty_radius;
        proven["tiles"] = c.tiles;
        proven["points_per_tile"] = c.points_per_tile;
        const std::size_t classes = set_.parameters.classes.count();
        std::vector<double> distances;
        for (std::size_t i = 0; i < classes; ++i)
            for (std::size_t j = 0; j < classes; ++j)
                distances.push_back(std::sqrt(static_cast<double>(c.classes[class_pair(i, j)].squared_min_distance)) /
                                    tile_units);
        const auto side = static_cast<py::ssize_t>(classes);
        proven["class_distances"] = array_of(std::move(distances), {side, side});
        return proven;
    }

private:
    PointColumns points_in(const std::shared_ptr<const FixedRegion>& region, const ptiles_tiling& tiling, double width,
                           double density) const
    {
        const TileBlock block = TiledRegion(region, width).block();
        Corner low{}, high{};
        for (std::size_t axis = 0; axis < 2; ++axis) {
            low[axis] = block.lowest[axis];
            high[axis] = low[axis] + block.size[axis];
        }
        check_window(low, high);
        const std::uint64_t count = ptiles_in_window(&tiling, low.data(), high.data(), nullptr, 0, density);
        std::vector<ptiles_point> found(count);
        ptiles_in_window(&tiling, low.data(), high.data(), found.data(), count, density);
        PointColumns points(2);
        for (ptiles_point& point : found) {
            const std::array place{point.position[0] * width, point.position[1] * width};
            if (!region->contains_place(place)) continue;
            std::ranges::copy(place, point.position);
            points.add(point);
        }
        return points;
    }

    /// Tiles are at places of 32 bits, and look at those beside them.
    static void check_place(const char* function, double value)
    {
        constexpr double most = 2147483600;
        if (!(value >= -most && value <= most))
            throw InputError(
                fmt::format("{0}: {1}: must be a number from -{2:.0f} to {2:.0f}, in tiles", function, value, most));
    }

    void check_window(const Corner& low, const Corner& high) const
    {
        double points = set_.parameters.points_per_tile;
        for (std::size_t axis = 0; axis < static_cast<std::size_t>(set_.parameters.dimension); ++axis) {
            check_place("window", low[axis]);
            check_place("window", high[axis]);
            if (!(low[axis] < high[axis])) throw InputError("window: its sizes must be above 0");
            points *= high[axis] - low[axis];
        }
        check_window_points(points);
    }

    std::string file_;
    PoissonTileSet set_;
};

}

void add_tile_sets(py::module_& module)
{
    py::class_<OpenTileSet>(module, "TileSet", "A Poisson disk tile set.")
        .def(py::init<const std::filesystem::path&>(), py::arg("file"))
        .def("parameters", &OpenTileSet::parameters)
        .def("window", &OpenTileSet::window, py::arg("low"), py::arg("high"), py::arg("seed"), py::arg("density"))
        .def("in_region", &OpenTileSet::in_region, py::arg("region"), py::arg("is_planar"), py::arg("crs"),
             py::arg("overlap"), py::arg("buffer"), py::arg("min_distance"), py::arg("points"), py::arg("seed"),
             py::arg("density"))
        .def("nearest", &OpenTileSet::nearest, py::arg("positions"), py::arg("seed"))
        .def("verify", &OpenTileSet::verify);
}

}
