#include "python/module/series_module.hpp"

#include "analysis/spectra/spectrum_file.hpp"
#include "results/measures.hpp"

#include <array>
#include <utility>

namespace py = pybind11;

namespace poissonlab {
namespace {

py::array_t<double> plane_of(Spectrum& spectrum, bool variance)
{
    std::vector<double>& values = variance ? spectrum.variance : spectrum.power;
    if (values.empty()) return py::array_t<double>();
    return array_of(std::move(values),
                    std::vector<py::ssize_t>(static_cast<std::size_t>(spectrum.dimension), spectrum.size));
}

py::object or_none(const std::optional<double>& value) { return value ? py::object(py::float_(*value)) : py::none(); }

/// The values of a measure over the realizations.
py::dict description_of(const Measure& measure, const MeasuredValue& measured, int dimension)
{
    py::dict description;
    description["value"] = measured.value;
    description["error"] = or_none(measured.standard_error);
    description["each"] = array_of(measured.each);
    description["name"] = in_dimension(measure.name, dimension);
    description["unit"] = measure.unit;
    description["meaning"] = in_dimension(measure.meaning, dimension);
    return description;
}

}

py::dict columns_of(const std::vector<RadialBin>& bins)
{
    py::dict columns;
    columns["frequency"] = column_of<double>(bins, &RadialBin::frequency);
    columns["power"] = column_of<double>(bins, &RadialBin::power);
    columns["error"] = column_of<double>(bins, &RadialBin::power_error);
    columns["anisotropy_db"] = column_of<double>(bins, &RadialBin::anisotropy_db);
    columns["samples"] = column_of<std::int64_t>(bins, &RadialBin::samples);
    return columns;
}

py::dict columns_of(const std::vector<PairCorrelationBin>& bins)
{
    py::dict columns;
    columns["distance"] = column_of<double>(bins, &PairCorrelationBin::distance);
    columns["value"] = column_of<double>(bins, &PairCorrelationBin::value);
    columns["error"] = column_of<double>(bins, &PairCorrelationBin::standard_error);
    columns["pairs"] = column_of<double>(bins, &PairCorrelationBin::pairs);
    return columns;
}

py::dict columns_of(const std::vector<RegionCurveRow>& rows)
{
    constexpr std::array<const char*, region_functions> names{"pair_correlation", "k", "nearest", "empty_space", "j"};
    py::dict columns;
    columns["distance"] = column_of<double>(rows, &RegionCurveRow::distance);
    columns["k_isotropic"] = column_of<double>(rows, &RegionCurveRow::k_isotropic);
    for (std::size_t f = 0; f < region_functions; ++f) {
        const auto add = [&](const std::string& name, auto member) {
            std::vector<double> values;
            for (const RegionCurveRow& row : rows) values.push_back((row.*member)[f]);
            columns[name.c_str()] = array_of(std::move(values));
        };
        add(names[f], &RegionCurveRow::value);
        add(std::string(names[f]) + "_low", &RegionCurveRow::low);
        add(std::string(names[f]) + "_high", &RegionCurveRow::high);
    }
    return columns;
}

py::dict columns_of(const std::vector<NumberVarianceBin>& bins)
{
    py::dict columns;
    columns["radius"] = column_of<double>(bins, &NumberVarianceBin::radius);
    columns["points"] = column_of<double>(bins, &NumberVarianceBin::points);
    columns["variance"] = column_of<double>(bins, &NumberVarianceBin::variance);
    columns["error"] = column_of<double>(bins, &NumberVarianceBin::standard_error);
    return columns;
}

py::dict planes_of(std::vector<Spectrum> spectra, bool are_planes, bool variance)
{
    py::dict planes;
    if (spectra.empty()) return planes;
    const std::vector<PlanePlace> places = are_planes ? shown_planes(spectra.front().size) : std::vector<PlanePlace>{};
    for (std::size_t i = 0; i < spectra.size(); ++i)
        planes[py::str(are_planes ? plane_name(places.at(i)) : "")] = plane_of(spectra[i], variance);
    return planes;
}

py::dict measures_of(const Series& series, int dimension)
{
    py::dict all;
    for (const Measure& measure : measures())
        if (const auto measured = measure.get(series))
            all[py::str(measure.key)] = description_of(measure, *measured, dimension);
    return all;
}

py::list pictures_of(const std::vector<FigurePicture>& pictures)
{
    py::list list;
    for (const FigurePicture& picture : pictures)
        list.append(py::make_tuple(picture.title, picture.caption, picture.type, py::bytes(picture.bytes)));
    return list;
}

}
