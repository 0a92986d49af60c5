// Methods whose parameters have lists of values, as tables of pictures with the values at their borders.
// The measures of one series, each with its unit and what it means.
#include "reports/layout/thumbnails.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace poissonlab {
namespace {

const MethodGrid& method_of(const ReportSeries& series) { return series.run->methods[series.stored->place->method]; }

/// Two axes are the rows and the columns of a table, one alone its columns; every combination of values of further axes
/// has a table of its own.
bool has_rows(const MethodGrid& method) { return method.axes.size() > 1; }

/// The places of a table's series on the axes that are no borders of it.
std::vector<std::size_t> table_of(const Series& series)
{
    return {series.place->indices.begin() + std::min<std::ptrdiff_t>(2, std::ssize(series.place->indices)),
            series.place->indices.end()};
}

std::string heading(const MethodAxis& axis, std::size_t index)
{
    return with_formatted_points(axis.symbol + " = " + axis.values[index]);
}

std::vector<std::string> parts_of(const std::string& label)
{
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= label.size();) {
        const auto end = std::min(label.find(", ", begin), label.size());
        parts.push_back(label.substr(begin, end - begin));
        begin = end + 2;
    }
    return parts;
}

using Cells = std::map<std::pair<std::size_t, std::size_t>, const ReportSeries*>; // by row and column

//// The part that the labels of all series of a table have in common: "Corner-based Poisson disk tiles, repulsion".
std::string common_label(const Cells& cells)
{
    std::string text;
    for (const auto& part : parts_of(cells.begin()->second->label)) {
        const bool common = std::ranges::all_of(cells, [&](const auto& cell) {
            const auto parts = parts_of(cell.second->label);
            return std::ranges::find(parts, part) != parts.end();
        });
        if (common) text += (text.empty() ? "" : ", ") + part;
    }
    return text;
}

std::string title_of(const MethodGrid& method, const std::vector<std::size_t>& table, const Cells& cells)
{
    if (cells.size() > 1)
        if (const auto common = common_label(cells); !common.empty()) return common;
    std::string title = method.label.empty() ? method.sampler : method.label;
    for (std::size_t i = 0; i < table.size(); ++i) title += ", " + heading(method.axes[i + 2], table[i]);
    return title;
}

/// The number below a picture: what the picture shows, in one figure.
std::string value_of(const ReportSeries& series)
{
    const auto& stored = *series.stored;
    if (stored.measures.lattice_peaks)
        return "peaks " + format_significant(stored.measures.lattice_peaks->mean_ratio, 3);
    if (stored.zone_plate && stored.zone_plate->resolved_rms_error)
        return "error " + format_significant(stored.zone_plate->resolved_rms_error->mean, 3);
    if (stored.relative_radius) return radius_words(stored, 3);
    return {};
}

PageData picture_data(const ReportSeries& series, const SmallPicture& picture, bool hidden,
                      const std::filesystem::path& page_folder)
{
    PageData data;
    data.set("kind", picture.kind);
    data.set("image_class", picture.image_class);
    data.set("source", relative_link(page_folder, series.pictures / picture.file));
    data.set("alt", fmt::format("{}: {}", series.label, picture.name));
    data.set("hidden", hidden);
    return data;
}

PageData cell_data(const ReportSeries* series, const std::filesystem::path& page_folder)
{
    PageData data;
    if (!series) {
        data.set("link", false);
        return data;
    }
    PageData pictures{PageData::type::list};
    const auto available = small_pictures(*series);
    for (const auto& picture : available)
        pictures << picture_data(*series, picture, &picture != &available.front(), page_folder);
    data.set("link", relative_link(page_folder, page_of(*series)));
    data.set("pictures", pictures);
    data.set("value", value_of(*series));
    return data;
}

PageData kinds_of(const ReportSeries& series)
{
    PageData list{PageData::type::list};
    const auto available = small_pictures(series);
    for (const auto& picture : available) {
        PageData kind;
        kind.set("kind", picture.kind);
        kind.set("text", picture.name);
        kind.set("pressed", &picture == &available.front() ? "true" : "false");
        list << kind;
    }
    return list;
}

PageData table_data(const MethodGrid& method, const std::vector<std::size_t>& table, const Cells& cells,
                    const std::filesystem::path& page_folder)
{
    const MethodAxis* down = has_rows(method) ? &method.axes[0] : nullptr;
    const MethodAxis& across = method.axes[down ? 1 : 0];
    PageData data;
    data.set("title", title_of(method, table, cells));
    data.set("column_symbol", across.symbol);
    data.set("row_symbol", down ? PageData(down->symbol) : PageData(false));
    data.set("kinds", kinds_of(*cells.begin()->second));
    PageData columns{PageData::type::list};
    for (std::size_t i = 0; i < across.values.size(); ++i) columns << PageData(heading(across, i));
    data.set("columns", columns);
    PageData rows{PageData::type::list};
    for (std::size_t row = 0; row < (down ? down->values.size() : 1); ++row) {
        PageData line;
        line.set("heading", down ? heading(*down, row) : std::string());
        PageData list{PageData::type::list};
        for (std::size_t column = 0; column < across.values.size(); ++column) {
            const auto found = cells.find({row, column});
            list << cell_data(found == cells.end() ? nullptr : found->second, page_folder);
        }
        line.set("cells", list);
        rows << line;
    }
    data.set("rows", rows);
    return data;
}

}

bool is_in_matrix(const ReportSeries& series) { return series.stored->place && !series.stored->place->indices.empty(); }

PageData matrices(const ReportRun& run, const std::filesystem::path& page_folder)
{
    std::map<std::pair<std::size_t, std::vector<std::size_t>>, Cells> tables; // by method and further places
    for (const auto& series : run.series) {
        if (!is_in_matrix(series)) continue;
        const auto& place = series.stored->place->indices;
        const auto cell = place.size() == 1 ? std::pair(std::size_t{0}, place[0]) : std::pair(place[0], place[1]);
        tables[{series.stored->place->method, table_of(*series.stored)}][cell] = &series;
    }
    PageData list{PageData::type::list};
    for (const auto& [key, cells] : tables)
        list << table_data(method_of(*cells.begin()->second), key.second, cells, page_folder);
    return list;
}

namespace {

/// The minimum distance of sets that lie in a region or a box, in its units, as people know them.
void change_to_own_unit(Measure& measure, MeasuredValue& value, const OwnUnit& own)
{
    measure.unit = own.name;
    value.value *= own.lengths;
    if (value.standard_error) *value.standard_error *= own.lengths;
    for (double& each : value.each) each *= own.lengths;
    if (value.range)
        for (double& end : *value.range) end *= own.lengths;
}

}

PageData measures_list(const ReportSeries& series)
{
    PageData list{PageData::type::list};
    for (Measure measure : measures()) {
        auto value = measure.meaning.empty() ? std::nullopt : measure.get(*series.stored);
        if (!value) continue;
        if (const auto own = own_unit(*series.stored); own && measure.key == "min_distance")
            change_to_own_unit(measure, *value, *own);
        const MeasureWords words = words_of(measure, *value);
        PageData data;
        data.set("key", measure.key);
        const auto in_words = [&](const std::string& text) { return in_dimension(text, series.run->dimension); };
        data.set("name", in_words(measure.title() + (measure.unit.empty() ? "" : " (" + measure.unit + ")")));
        data.set("value", words.shown);
        data.set("exact", format_exact(value->value));
        std::string error = words.spread;
        if (!words.range.empty()) error += fmt::format("{}sets from {}", error.empty() ? "" : "; ", words.range);
        data.set("error", optional_text(error));
        data.set("meaning", in_words(measure.meaning));
        list << data;
    }
    return list;
}

}
