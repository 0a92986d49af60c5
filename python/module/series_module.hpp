// A series with its curves for Python, wherever it comes from: sets in memory, or an output folder.
#pragma once

#include "analysis/measures/number_variance.hpp"
#include "analysis/measures/pair_correlation.hpp"
#include "analysis/regions/region_curve_row.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "base/geometry/point_set.hpp"
#include "python/module/arrays.hpp"
#include "reports/site/series_figure.hpp"
#include "results/series.hpp"

#include <pybind11/stl.h>

#include <vector>

namespace poissonlab {

/// The names, columns and planes by which Python sees these, without copies where that is possible.
pybind11::dict columns_of(const std::vector<RadialBin>& bins);
pybind11::dict columns_of(const std::vector<PairCorrelationBin>& bins);
pybind11::dict columns_of(const std::vector<NumberVarianceBin>& bins);
pybind11::dict columns_of(const std::vector<RegionCurveRow>& rows);

/// The spectra by their planes: "" for all of a spectrum, shape (size, size) or, in 3D, (size, size, size).
pybind11::dict planes_of(std::vector<Spectrum> spectra, bool are_planes, bool variance);

/// All measures of a series by their keys.
pybind11::dict measures_of(const Series& series, int dimension);

/// The pictures of a figure.
pybind11::list pictures_of(const std::vector<FigurePicture>& pictures);

/// Binds a class with the functions series(), dimension(), radial(), pairs(), number_variance(), region(), spectra(),
/// are_planes(), sets() and figure().
template <typename Source, typename Class>
void bind_series(Class& type)
{
    namespace py = pybind11;
    type.def_property_readonly("name", [](const Source& s) { return s.series().name; })
        .def_property_readonly("label", [](const Source& s) { return s.series().label; })
        .def_property_readonly("dimension", &Source::dimension)
        .def_property_readonly("points", [](const Source& s) { return s.series().points; })
        .def_property_readonly("realizations", [](const Source& s) { return s.series().realizations; })
        .def("radial", [](const Source& s) { return columns_of(without_lock([&] { return s.radial(); })); })
        .def("pairs", [](const Source& s) { return columns_of(without_lock([&] { return s.pairs(); })); })
        .def("number_variance",
             [](const Source& s) { return columns_of(without_lock([&] { return s.number_variance(); })); })
        .def("region", [](const Source& s) { return columns_of(without_lock([&] { return s.region(); })); })
        .def("spectra",
             [](const Source& s, bool variance) {
                 return planes_of(without_lock([&] { return s.spectra(); }), s.are_planes(), variance);
             })
        .def("measures", [](const Source& s) { return measures_of(s.series(), s.dimension()); })
        .def("sets",
             [](const Source& s) {
                 py::list list;
                 for (PointSet& set : without_lock([&] { return s.sets(); })) list.append(array_of(std::move(set)));
                 return list;
             })
        .def("figure", [](const Source& s) { return pictures_of(without_lock([&] { return s.figure(); })); });
}

}
