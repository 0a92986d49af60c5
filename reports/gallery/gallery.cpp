#include "reports/gallery/gallery.hpp"

#include "analysis/measures/peak_anisotropy.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/statistics/jackknife.hpp"
#include "base/text/csv_fields.hpp"
#include "reports/gallery/table_reader.hpp"
#include "results/measures.hpp"
#include "results/periodograms.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>

namespace poissonlab {
namespace {

constexpr std::string_view methods_file = "methods.csv";
constexpr std::string_view measures_file = "measures.csv";
constexpr std::string_view curves_file = "curves.csv";

constexpr std::string_view methods_header =
    "name,dimension,points,realizations,min_distance,sampler,seed,program,parameters,label";
constexpr std::string_view measures_header = "name,measure,value,standard_error";
constexpr std::string_view curves_header = "name,frequency,power,power_error,anisotropy_db";

/// Methods that most papers show, and the best of their kind.
constexpr std::array<std::string_view, 15> chosen_methods = {
    "random",
    "jittered",
    "dart-throwing-rho-0.75",
    "lloyd-i-100",
    "sample-elimination",
    "farthest-point",
    "gaussian-blue-noise",
    "target-spectrum",
    "equal-areas",
    "random-3d",
    "jittered-3d",
    "dart-throwing-rho-0.70-3d",
    "lloyd-i-100-3d",
    "sample-elimination-3d",
    "gaussian-blue-noise-3d",
};

/// Times and memory are those of one machine, and numbers of points and sets stand in another table.
bool is_in_gallery(const Measure& measure)
{
    return measure.kind == MeasureKind::per_set || measure.kind == MeasureKind::estimate ||
           measure.kind == MeasureKind::first;
}

/// Below this part of a value its error is the rounding of coordinates: of 53 bits over the smallest distances that
/// sets have, some 10^-3, times a few operations. Sets that differ at all do so by more than 32 bits of a coordinate
/// tell.
constexpr double rounding = 1e-12;

/// The tile set of each realization that counts, as long as there are several.
std::vector<std::size_t> tile_set_of_each(const Series& stored)
{
    const auto parameters = nlohmann::json::parse(stored.parameters_json);
    const auto sets = parameters.value("sets", std::size_t{1});
    std::vector<std::size_t> groups;
    for (std::size_t k = 0; sets > 1 && groups.size() < static_cast<std::size_t>(stored.realizations); ++k)
        if (!stored.is_repeated(k)) groups.push_back(k % sets);
    return groups;
}

std::optional<double> standard_error_in(const MeasuredValue& value, const Series& stored)
{
    std::optional<double> error = value.standard_error;
    if (!error && value.each.size() > 1) {
        const std::vector<std::size_t> groups = tile_set_of_each(stored);
        const auto each = group_means(value.each, groups);
        if (each.size() > 1) error = standard_error_of_mean(each);
    }
    if (error && *error < rounding * std::abs(value.value)) error = 0;
    return error;
}

void add_gallery_method(const GallerySource& source, GalleryTables& tables)
{
    const Series& stored = *source.stored;
    const std::string name = gallery_name(source);
    fmt::format_to(std::back_inserter(tables.methods), "{},{},{},{},{:.6g},{},{},{},{},{}\n", name,
                   source.curve->dimension, stored.points, periodograms_of(stored),
                   stored.min_distance ? stored.min_distance->mean : 0, stored.sampler, source.seed, source.program,
                   csv_quoted(stored.parameters_json), csv_quoted(source.label));
    for (const Measure& measure : measures()) {
        const auto value = is_in_gallery(measure) ? measure.get(stored) : std::nullopt;
        if (!value || !std::isfinite(value->value)) continue;
        const auto error = standard_error_in(*value, stored);
        fmt::format_to(std::back_inserter(tables.measures), "{},{},{:.5g},{}\n", name, measure.key, value->value,
                       error ? fmt::format("{:.2g}", *error) : "");
    }
    for (const RadialBin& bin : source.curve->bins)
        fmt::format_to(std::back_inserter(tables.curves), "{},{},{:.4g},{:.2g},{:.2f}\n", name, bin.frequency,
                       bin.power, bin.power_error, bin.anisotropy_db);
}

GalleryMethod gallery_method_of(const TableReader& line)
{
    GalleryMethod method;
    method.name = line.text(0);
    method.curve.dimension = static_cast<int>(line.number(1));
    method.curve.points = static_cast<std::size_t>(line.number(2));
    method.curve.periodograms = static_cast<int>(line.number(3));
    method.curve.background_db = background_anisotropy_db(method.curve.periodograms);
    if (const double distance = line.number(4); distance > 0) method.curve.principal_frequency = 1 / distance;
    method.sampler = line.text(5);
    method.seed = line.text(6);
    method.program = line.text(7);
    method.parameters = line.text(8);
    method.label = line.text(9);
    return method;
}

/// The method that a line of another table is about.
GalleryMethod& method_named(std::vector<GalleryMethod>& methods, const TableReader& line)
{
    const auto found = std::ranges::find(methods, line.text(0), &GalleryMethod::name);
    if (found == methods.end()) throw line.error(line.text(0) + " is no method of " + std::string(methods_file));
    return *found;
}

/// Curves have no numbers of samples: the frequencies of a ring one wide are about as many as its area is large.
void set_anisotropy_above_chance(GalleryMethod& method)
{
    constexpr const char* key = "anisotropy_above_chance";
    if (method.measures.contains(key)) return;
    std::vector<RadialBin> rings = method.curve.bins;
    for (RadialBin& ring : rings) {
        const double f = ring.frequency;
        const double samples =
            method.curve.dimension == 2 ? 2 * std::numbers::pi * f : std::numbers::pi * (4 * f * f + 1.0 / 3);
        ring.samples = static_cast<std::size_t>(std::lround(samples));
    }
    if (const auto above = anisotropy_above_chance_db(rings, method.curve.periodograms))
        method.measures[key] = {*above, {}};
}

}

std::string gallery_name(const GallerySource& source)
{
    return source.curve->dimension == 3 ? source.stored->name + "-3d" : source.stored->name;
}

GalleryTables gallery_tables(const std::vector<GallerySource>& sources)
{
    GalleryTables tables{fmt::format("{}\n", methods_header), fmt::format("{}\n", measures_header),
                         fmt::format("{}\n", curves_header)};
    for (const GallerySource& source : sources) add_gallery_method(source, tables);
    return tables;
}

std::vector<GalleryMethod> read_gallery(const GalleryTables& tables)
{
    std::vector<GalleryMethod> gallery;
    for (TableReader line(tables.methods, methods_file, methods_header); line.next();)
        gallery.push_back(gallery_method_of(line));
    for (TableReader line(tables.measures, measures_file, measures_header); line.next();)
        method_named(gallery, line).measures[line.text(1)] = line.estimate(2, 3);
    for (TableReader line(tables.curves, curves_file, curves_header); line.next();) {
        Curve& curve = method_named(gallery, line).curve;
        curve.bins.push_back({line.number(1), line.number(2), line.number(4), 0, line.number(3)});
        curve.max_frequency = line.number(1);
    }
    for (GalleryMethod& method : gallery) set_anisotropy_above_chance(method);
    for (const GalleryMethod& method : gallery)
        if (method.curve.bins.empty())
            throw InputError::at({std::string(curves_file)}, "has no curve of " + method.name);
    return gallery;
}

const std::vector<GalleryMethod>& reference_gallery()
{
    static const std::vector<GalleryMethod> gallery =
        read_gallery({std::string(gallery_file(methods_file)), std::string(gallery_file(measures_file)),
                      std::string(gallery_file(curves_file))});
    return gallery;
}

std::vector<const GalleryMethod*> reference_gallery(int dimension)
{
    std::vector<const GalleryMethod*> methods;
    for (const GalleryMethod& method : reference_gallery())
        if (method.curve.dimension == dimension) methods.push_back(&method);
    return methods;
}

std::vector<const GalleryMethod*> gallery_choice(int dimension)
{
    auto methods = reference_gallery(dimension);
    std::erase_if(methods, [](const GalleryMethod* method) {
        return std::ranges::find(chosen_methods, method->name) == chosen_methods.end();
    });
    return methods;
}

}
