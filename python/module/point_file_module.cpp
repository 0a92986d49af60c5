// Point files for Python: those that `poissonlab analyze` reads and the program writes.
#include "base/points/point_file.hpp"
#include "python/module/arrays.hpp"
#include "python/module/module_parts.hpp"
#include "python/module/work.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <optional>
#include <utility>

namespace py = pybind11;

namespace poissonlab {
namespace {

using Range = std::optional<std::array<double, 2>>;

std::vector<py::array_t<double>> read_sets(const std::filesystem::path& file, const Range& domain)
{
    std::optional<CoordinateRange> range;
    if (domain) range = CoordinateRange{(*domain)[0], (*domain)[1]};
    std::vector<py::array_t<double>> arrays;
    std::string warning;
    std::vector<PointSet> sets = without_lock(
        [&] { return read_points(file, range, [&](const std::string& sentence) { warning = sentence; }); });
    if (!warning.empty()) py::module_::import("warnings").attr("warn")(warning, py::arg("stacklevel") = 2);
    for (PointSet& set : sets) arrays.push_back(array_of(std::move(set)));
    return arrays;
}

void write_set(const std::filesystem::path& file, const AnyArray& points, const std::string& comment)
{
    const PointSet set = point_set_of(points, "write_points");
    without_lock([&] { write_points(file, set, comment); });
}

}

void add_point_files(py::module_& module)
{
    module.def("read_points", read_sets, py::arg("file"), py::arg("domain"),
               "The sets of a file, each (points, dimension).");
    module.def("write_points", write_set, py::arg("file"), py::arg("points"), py::arg("comment"));
}

}
