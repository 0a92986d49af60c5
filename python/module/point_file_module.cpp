// Point files for Python: those that `poissonlab analyze` reads and the program writes.
#include "base/errors/errors.hpp"
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

/// One range for all axes, or one for each.
using Ranges = std::optional<std::vector<std::array<double, 2>>>;

std::optional<PointDomain> domain_of(const Ranges& given)
{
    if (!given) return {};
    std::vector<CoordinateRange> ranges;
    for (const auto& [low, high] : *given) ranges.push_back({low, high});
    if (ranges.size() == 1) return PointDomain(ranges.front());
    if (ranges.size() == 2 || ranges.size() == 3) return PointDomain(ranges);
    throw InputError("domain: must be (low, high), or such a range for each axis");
}

std::vector<py::array_t<double>> read_sets(const std::filesystem::path& file, const Ranges& given)
{
    std::optional<PointDomain> domain = domain_of(given);
    const bool is_given = domain.has_value();
    std::vector<py::array_t<double>> arrays;
    std::string warning;
    const auto told = [&](const std::string& sentence) { warning = sentence; };
    std::vector<PointSet> sets = without_lock(
        [&] { return is_given ? read_points_in_box(file, domain, told) : read_points(file, domain, told); });
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
