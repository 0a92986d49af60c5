// Point files for Python: those that `poissonlab analyze` reads and the program writes.
#include "base/points/point_file.hpp"
#include "python/module/arrays.hpp"
#include "python/module/module_parts.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// A domain that is given may have sides that differ; one that the file declares must be a square.
std::vector<PointSet> read_sets_of(const std::filesystem::path& file, const PointReading& how)
{
    PointDomain domain;
    return how.domain ? read_points_in_box(file, how, domain) : read_points(file, how);
}

/// The sets of all files. `depth`: how many calls of Python are between the caller and this.
std::vector<py::array_t<double>> read_sets(const std::vector<std::filesystem::path>& files, const Ranges& given,
                                           const std::optional<int>& particles, bool has_region, int depth)
{
    PointReading how{.domain = domain_of(given), .particles = particles, .options = argument_words};
    if (!has_region) how.options.region = "";
    std::vector<std::string> told;
    how.told = [&](const std::string& sentence) { told.push_back(sentence); };
    std::vector<PointSet> sets;
    without_lock([&] {
        for (const auto& file : without_further_parts(files, how.told))
            for (PointSet& set : read_sets_of(file, how)) sets.push_back(std::move(set));
    });
    for (const std::string& sentence : told)
        py::module_::import("warnings").attr("warn")(sentence, py::arg("stacklevel") = depth);
    std::vector<py::array_t<double>> arrays;
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
    module.def("read_points", read_sets, py::arg("files"), py::arg("domain"), py::arg("particles"),
               py::arg("has_region"), py::arg("depth"), "The sets of files, each (points, dimension).");
    module.def("write_points", write_set, py::arg("file"), py::arg("points"), py::arg("comment"));
}

}
