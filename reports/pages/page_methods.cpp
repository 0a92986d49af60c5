// One row a method: its best series in small pictures and the numbers that methods are chosen by.
#include "reports/layout/thumbnails.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

namespace poissonlab {

namespace {

/// The sizes of chapter 6 of the dissertation: sets with spectra, and sets that sample the zone plate.
constexpr std::array<std::size_t, 2> timed_sizes{16'384, 262'144};

/// Reports of fewer series are seen at a glance in the ranking.
constexpr std::size_t many_series = 12;

/// Tilings and saturated sets have about as many points.
bool has_about(const ReportSeries& series, std::size_t points)
{
    const double ratio = static_cast<double>(series.stored->points) / static_cast<double>(points);
    return ratio > 0.9 && ratio < 1.1;
}

/// A method in a dimension, in regions or elsewhere, and all of its series.
struct Method
{
    std::string sampler;
    int dimension = 2;
    bool is_in_region = false;
    std::vector<const ReportSeries*> series;
};

std::vector<Method> methods_of(const Site& site)
{
    std::vector<Method> methods;
    for (const ReportSeries* series : site.series()) {
        const auto found = std::ranges::find_if(methods, [&](const Method& method) {
            return method.sampler == series->stored->sampler && method.dimension == series->run->dimension &&
                   method.is_in_region == series->stored->region.has_value();
        });
        Method& method = found == methods.end() ? methods.emplace_back(series->stored->sampler, series->run->dimension,
                                                                       series->stored->region.has_value())
                                                : *found;
        method.series.push_back(series);
    }
    return methods;
}

std::optional<MeasuredValue> value_of(const std::string& key, const ReportSeries& series)
{
    const auto measure = std::ranges::find(measures(), key, &Measure::key);
    return measure == measures().end() ? std::nullopt : measure->get(*series.stored);
}

/// The series that stands for a method: with a spectrum, of several sets, of the size that methods are compared at, as
/// far as there is any; then without directions, then of the largest relative radius. (A large radius alone is that of
/// a lattice.)
const ReportSeries& best_of(const Method& method)
{
    const auto worth = [](const ReportSeries* series) {
        const Series& stored = *series->stored;
        return std::tuple(stored.has_spectrum(), !follows_density(*series), has_about(*series, timed_sizes[0]),
                          stored.is_estimate, -anisotropy_above_chance(*series).value_or(0),
                          stored.relative_radius ? stored.relative_radius->mean : 0);
    };
    return **std::ranges::max_element(method.series, {}, worth);
}

/// A measure of a series as the ranking has it; empty where there is none.
std::string shown(const std::string& key, const ReportSeries& series)
{
    const auto measure = std::ranges::find(measures(), key, &Measure::key);
    if (measure == measures().end()) return {};
    const auto value = measure->get(*series.stored);
    return value ? words_of(*measure, *value).shown : std::string();
}

/// The series that has the least of a measure.
const ReportSeries* least_of(const Method& method, const std::string& key)
{
    const ReportSeries* best = nullptr;
    double least = 0;
    for (const ReportSeries* series : method.series) {
        const auto value = value_of(key, *series);
        if (!value || (best && value->value >= least)) continue;
        best = series;
        least = value->value;
    }
    return best;
}

/// The shortest median time of the method's sets of so many points.
std::string time_for(const Method& method, std::size_t points)
{
    std::optional<double> shortest;
    for (const ReportSeries* series : method.series)
        if (const auto time = value_of("sample_time", *series); time && has_about(*series, points))
            shortest = std::min(shortest.value_or(time->value), time->value);
    return shortest ? format_seconds(*shortest) : std::string();
}

std::string preparation_of(const ReportSeries& series)
{
    if (const auto built = value_of("build_time", series)) return format_seconds(built->value);
    const double seconds = series.stored->preparation_seconds;
    return seconds > 1e-3 ? format_seconds(seconds) : std::string();
}

/// Device memory, where the method needs a device.
std::string memory_of(const ReportSeries& series)
{
    const auto memory = value_of("device_memory", series);
    return memory ? format_significant(memory->value, 3) : std::string();
}

/// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.16, in short.
std::string verdict_of_the_paper(const std::string& sampler)
{
    static const std::map<std::string, std::string> verdicts{
        {"dart-throwing", "not for interactive use, nor for many points"},
        {"relaxation-dart-throwing", "not for interactive use, nor for many points"},
        {"voronoi-darts", "for interactive use, but slow beside tiles"},
        {"sector-darts", "for interactive use, but slow beside tiles"},
        {"lloyd", "not for interactive use, nor for many points"},
        {"shade-tiles", "major shortcomings: should not be used"},
        {"averaged-tiles", "not recommended: a small radius, a rather bad spectrum"},
        {"penrose", "not for a constant density: a spectrum below average"},
        {"recursive-wang-tiles", "not for a constant density: a low radius, a spectrum below average"},
        {"edge-tiles", "better than earlier tiles in radius and spectrum"},
        {"template-tiles", "of theoretical interest: too many artifacts in the spectrum"},
        {"corner-tiles", "seem to be the best of those that tile"},
    };
    const auto found = verdicts.find(sampler);
    return found == verdicts.end() ? std::string() : found->second;
}

/// The verdict follows from the numbers by the limits that the table names.
std::string verdict_by_numbers(const Method& method, const ReportSeries& best)
{
    std::vector<std::string> words;
    if (follows_density(best)) return "follows a density";
    if (const auto& radius = best.stored->relative_radius)
        words.push_back(radius->min >= 0.65 ? "far apart" : radius->min >= 0.4 ? "some points near" : "points meet");
    if (anisotropy_above_chance(best)) words.emplace_back(has_directions(best) ? "not isotropic" : "isotropic");
    if (const auto seams = value_of("seam_density", best); seams && seams->value > 0.2) words.emplace_back("seams");
    for (const ReportSeries* series : method.series)
        if (const auto time = value_of("sample_time", *series);
            time && has_about(*series, timed_sizes[0]) && time->value < 0.01) {
            words.emplace_back("fast");
            break;
        }
    return fmt::format("{}", fmt::join(words, ", "));
}

/// The small pictures of a kind, one of the best series or, of the zone plate, of the series that has the best.
PageData picture_of(const Site& site, const ReportSeries* series, const std::string& kind)
{
    if (series == nullptr) return false;
    for (const SmallPicture& picture : small_pictures(*series)) {
        if (picture.kind != kind) continue;
        PageData data;
        data.set("link", relative_link(site.out, page_of(*series)));
        data.set("source", relative_link(site.out, series->pictures / picture.file));
        data.set("image_class", picture.image_class);
        data.set("alt", fmt::format("{}: {}", series->label, picture.name));
        return data;
    }
    return false;
}

/// The columns after the method's name.
struct MethodColumn
{
    const char* title;
    const char* detail;
    const char* style; ///< what cells are, in the style sheet's words
};

constexpr std::array method_columns{MethodColumn{"points", "", "picture"},
                                    MethodColumn{"spectrum", "", "picture"},
                                    MethodColumn{"radial power", "", "picture"},
                                    MethodColumn{"zone plate", "", "picture"},
                                    MethodColumn{"relative radius", "smallest", "number"},
                                    MethodColumn{"relative radius", "mean", "number"},
                                    MethodColumn{"anisotropy", "dB above chance", "number"},
                                    MethodColumn{"anisotropy", "between lattice peaks, dB above chance", "number"},
                                    MethodColumn{"error of the zone plate", "", "number"},
                                    MethodColumn{"time", "16,384 points", "number"},
                                    MethodColumn{"time", "262,144 points", "number"},
                                    MethodColumn{"preparation", "", "number"},
                                    MethodColumn{"device memory", "MiB", "number"},
                                    MethodColumn{"the paper says", "", "verdict"},
                                    MethodColumn{"the numbers say", "", "verdict"}};

/// A cell has a picture, a text, or nothing.
struct MethodCell
{
    PageData picture = false;
    std::string text = {};

    bool is_empty() const { return picture.is_false() && text.empty(); }
};

using MethodCells = std::array<MethodCell, method_columns.size()>;

MethodCells cells_of(const Site& site, const Method& method)
{
    const ReportSeries& best = best_of(method);
    const ReportSeries* plates = least_of(method, "zone_plate_error");
    const auto& radius = best.stored->relative_radius;
    const auto text = [](const std::string& words) { return MethodCell{false, words}; };
    return {MethodCell{picture_of(site, &best, "points")},
            MethodCell{picture_of(site, &best, "spectrum")},
            MethodCell{picture_of(site, &best, "radial")},
            MethodCell{picture_of(site, plates, "plate")},
            text(radius ? format_fixed(radius->min, 3) : ""),
            text(radius ? format_fixed(radius->mean, 3) : ""),
            text(shown("anisotropy_above_chance", best)),
            text(shown("off_lattice_anisotropy", best)),
            text(plates ? shown("zone_plate_error", *plates) : ""),
            text(time_for(method, timed_sizes[0])),
            text(time_for(method, timed_sizes[1])),
            text(preparation_of(best)),
            text(memory_of(best)),
            text(method.is_in_region ? std::string() : verdict_of_the_paper(method.sampler)),
            text(verdict_by_numbers(method, best))};
}

/// The row of a method, with the cells of those columns that any method has something for.
PageData method_row(const Site& site, const Method& method, bool has_dimensions, const MethodCells& cells,
                    const std::vector<std::size_t>& columns)
{
    const ReportSeries& best = best_of(method);
    PageData row;
    row.set("name", method.sampler + (has_dimensions ? fmt::format(", {}D", method.dimension) : "") +
                        (method.is_in_region ? ", in a region" : ""));
    row.set("is_window", best.stored->is_window);
    row.set("best", best.label);
    row.set("link", relative_link(site.out, page_of(best)));
    const std::size_t count = method.series.size();
    row.set("count", count > 1 ? PageData(fmt::format("best of {} series", format_count(count))) : PageData(false));
    PageData list{PageData::type::list};
    for (const std::size_t column : columns) {
        PageData cell;
        cell.set("style", method_columns[column].style);
        cell.set("picture", cells[column].picture);
        cell.set("text", optional_text(cells[column].text));
        cell.set("nothing", cells[column].is_empty());
        list << cell;
    }
    row.set("cells", list);
    return row;
}

}

bool set_methods(PageData& page, const Site& site)
{
    const std::vector<Method> methods = methods_of(site);
    const std::size_t count = site.series().size();
    const bool has_methods = methods.size() > 1 && count > methods.size() && count > many_series;
    page.set("has_methods", has_methods);
    if (!has_methods) return false;
    const bool has_dimensions = std::ranges::any_of(
        methods, [&](const Method& method) { return method.dimension != methods.front().dimension; });
    std::vector<MethodCells> cells;
    for (const Method& method : methods) cells.push_back(cells_of(site, method));
    std::vector<std::size_t> columns;
    PageData headings{PageData::type::list};
    for (std::size_t c = 0; c < method_columns.size(); ++c) {
        if (std::ranges::all_of(cells, [&](const MethodCells& row) { return row[c].is_empty(); })) continue;
        columns.push_back(c);
        PageData heading;
        heading.set("title", method_columns[c].title);
        heading.set("style", method_columns[c].style);
        heading.set("detail", optional_text(method_columns[c].detail));
        headings << heading;
    }
    PageData rows{PageData::type::list};
    for (std::size_t i = 0; i < methods.size(); ++i)
        rows << method_row(site, methods[i], has_dimensions, cells[i], columns);
    page.set("method_columns", headings);
    page.set("methods", rows);
    return true;
}

}
