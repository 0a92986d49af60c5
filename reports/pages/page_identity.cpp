// The identity of a series wherever it is mentioned, and the quantities over its realizations.
// The origin of results: program, seed, machine, command and config of a run.
#include "reports/pages/page_parts.hpp"
#include "reports/plots/plot.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace poissonlab {
namespace {

std::string parameters_text(const NamedTexts& parameters)
{
    std::string text;
    for (const auto& [name, value] : parameters)
        text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, value);
    return text;
}

/// "1,708 to 1,754" where realizations differ in size.
std::string points_range(const Series& series)
{
    if (series.points_each.empty()) return {};
    const auto [fewest, most] = std::ranges::minmax_element(series.points_each);
    return fmt::format("{} to {}", format_count(*fewest), format_count(*most));
}

PageData region_data(const Series& series)
{
    if (!series.region) return false;
    PageData data;
    data.set("name", series.region->name);
    const bool is_in_metres = series.region->is_in_metres;
    data.set("area", format_significant(series.region->area, 5) + (is_in_metres ? " m²" : " in its own units"));
    data.set("unit", format_significant(series.region->unit_length, 5) + (is_in_metres ? " m" : " units"));
    data.set("notes", optional_text(fmt::format("{}", fmt::join(series.region->notes, "; "))));
    return data;
}

/// The box's sides in their unit, and the unit of lengths.
PageData box_data(const Series& series)
{
    if (!series.box) return false;
    std::vector<std::string> sides;
    for (const double side : series.box->sides) sides.push_back(fmt::format("{:.6g}", side));
    PageData data;
    data.set("sides", fmt::format("{}", fmt::join(sides, " × ")));
    data.set("unit", format_significant(series.box->unit_length(), 5));
    data.set("of", series.box->sides.size() == 2 ? "area" : "volume");
    return data;
}

}

PageData optional_text(const std::string& text) { return text.empty() ? PageData(false) : PageData(text); }

PageData series_identity(const ReportSeries& series, std::size_t index)
{
    PageData data;
    data.set("label", series.label);
    data.set("color", curve_color(index));
    data.set("sampler", series.stored->sampler);
    data.set("parameters", optional_text(parameters_text(series.stored->parameters)));
    data.set("points", format_count(series.stored->points));
    data.set("is_window", series.stored->is_window);
    data.set("region", region_data(*series.stored));
    data.set("box", box_data(*series.stored));
    data.set("points_range", optional_text(points_range(*series.stored)));
    data.set("realizations", format_count(static_cast<std::uint64_t>(series.stored->realizations)));
    const std::size_t repeated = series.stored->repeated.size();
    data.set("repeated", repeated > 0 ? PageData(format_count(repeated)) : PageData(false));
    return data;
}

std::string radius_words(const Series& series, int digits)
{
    if (!series.relative_radius) return {};
    return fmt::format("{}ρ = {}", series.realizations > 1 ? "mean " : "",
                       format_significant(series.relative_radius->mean, digits));
}

PageData shown_mean(const std::optional<Statistic>& value, int digits)
{
    if (!value) return false;
    PageData data;
    data.set("exact", format_exact(value->mean));
    data.set("mean", format_significant(value->mean, digits));
    return data;
}

std::string engine_words(const std::string& engine)
{
    return engine == "opencl" ? "OpenCL" : engine == "reference" ? "the sequential reference" : engine;
}

void set_provenance(PageData& data, const Run& run)
{
    PageData facts{PageData::type::list};
    const auto add = [&](const std::string& name, const std::string& value) {
        if (value.empty()) return;
        PageData fact;
        fact.set("name", name);
        fact.set("value", value);
        facts << fact;
    };
    add("Program", "poissonlab " + run.version);
    add("Seed", run.seed);
    add("Engine", engine_words(run.engine));
    for (const auto& [name, value] : run.machine.used()) {
        auto words = name;
        std::ranges::replace(words, '_', ' ');
        words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
        add(words, value);
    }
    std::string overrides;
    for (const auto& text : run.overrides) overrides += (overrides.empty() ? "" : "  ") + text;
    add("Overrides", overrides);

    data.set("run_title", run.title);
    data.set("command", optional_text(run.command));
    data.set("config", optional_text(run.config));
    data.set("facts", facts);
}

}
