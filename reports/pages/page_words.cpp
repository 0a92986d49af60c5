// The sentence that a page says about its runs, and the names of things in their dimensions.
#include "base/text/noun.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace poissonlab {

std::string script_text(const std::string& text)
{
    std::string result;
    for (const char c : nlohmann::json(text).dump()) result += c == '<' ? "\\u003c" : std::string(1, c);
    return result;
}

namespace {

/// "16,384", or "256 to 16,384" where series differ.
template <typename Value>
std::string range_of(const std::vector<const ReportSeries*>& series, Value Series::*member)
{
    const auto values = [&](const ReportSeries* entry) { return entry->stored->*member; };
    const auto [low, high] = std::ranges::minmax(series, {}, values);
    const auto from = format_count(static_cast<std::uint64_t>(values(low)));
    const auto to = format_count(static_cast<std::uint64_t>(values(high)));
    return from == to ? from : from + " to " + to;
}

std::string counted(std::size_t count, const char* one)
{
    return count == 0 ? std::string() : fmt::format("{} {}", format_count(count), noun(count, one));
}

std::string tilings_summary(const std::vector<const ReportRun*>& runs)
{
    std::size_t sets = 0, tilings = 0;
    for (const ReportRun* run : runs)
        for (const auto& tiling : run->tilings) ++(tiling.stored->set.empty() ? tilings : sets);
    if (sets + tilings == 0) return {};
    return counted(sets, "tile set") + (sets > 0 && tilings > 0 ? " and " : "") + counted(tilings, "tiling") + ".";
}

std::string constructions_summary(const std::vector<const ReportRun*>& runs)
{
    std::size_t count = 0;
    for (const ReportRun* run : runs) count += run->constructions.size();
    if (count == 0) return {};
    return fmt::format("{} of the construction of Poisson tiles.",
                       count == 1 ? "A picture" : format_count(count) + " pictures");
}

std::string distributions_summary(const std::vector<const ReportRun*>& runs)
{
    std::size_t textures = 0, packings = 0, others = 0, schemes = 0;
    for (const ReportRun* run : runs) {
        for (const ReportDistribution& entry : run->distributions)
            ++(is_of_textures(entry) ? textures : is_of_packings(entry) ? packings : others);
        schemes += run->schemes.size();
    }
    std::vector<std::string> parts;
    const auto add = [&](std::size_t count, const char* what) {
        if (count > 0) parts.push_back(counted(count, what));
    };
    add(textures, "texture");
    add(packings, "packing");
    add(others, "distribution");
    add(schemes, "scheme");
    return parts.empty() ? std::string() : fmt::format("{}.", fmt::join(parts, ", "));
}

/// The places of the points: sets that are windows, and those in regions, have borders.
std::string domain_words(const std::vector<const ReportSeries*>& series)
{
    std::vector<std::string> words;
    const auto add_where = [&](const char* what, const auto& is_there) {
        if (std::ranges::any_of(series, is_there)) words.emplace_back(what);
    };
    add_where("on the unit torus", [](const auto* entry) {
        return !entry->stored->is_window && !entry->stored->region && !entry->stored->box;
    });
    add_where("in periodic boxes", [](const auto* entry) { return entry->stored->box.has_value(); });
    add_where("in windows", [](const auto* entry) { return entry->stored->is_window; });
    add_where("in regions", [](const auto* entry) { return entry->stored->region.has_value(); });
    return fmt::format("{}", fmt::join(words, " or "));
}

std::string series_summary(const std::vector<const ReportRun*>& runs)
{
    std::vector<const ReportSeries*> series;
    for (const ReportRun* run : runs)
        for (const auto& entry : run->series) series.push_back(&entry);
    if (series.empty()) return {};
    const auto realizations = range_of(series, &Series::realizations);
    const bool mixed = has_dimension(runs, 2) && has_dimension(runs, 3);
    const auto dimension = mixed ? "2D and 3D" : fmt::format("{}D", series.front()->run->dimension);
    const std::string points = range_of(series, &Series::points);
    auto text = fmt::format("{} series of {} {} {} in {}, {} realization{}{}",
                            series.size() == 1 ? "One" : format_count(series.size()), points,
                            noun(points == "1" ? 1 : 2, "point"), domain_words(series), dimension, realizations,
                            realizations == "1" ? "" : "s", series.size() == 1 ? "" : " each");
    const auto& engine = series.front()->run->engine;
    const bool one_engine =
        std::ranges::all_of(series, [&](const auto* entry) { return entry->run->engine == engine; });
    if (!engine.empty() && one_engine) text += fmt::format(", made with {}", engine_words(engine));
    return text + ".";
}

}

bool has_dimension(const std::vector<const ReportRun*>& runs, int dimension)
{
    return std::ranges::any_of(runs, [&](const auto* run) { return run->stored->dimension == dimension; });
}

void set_dimension_words(PageData& page, const std::vector<const ReportRun*>& runs)
{
    const bool plane = has_dimension(runs, 2);
    const bool space = has_dimension(runs, 3);
    const auto words = [&](const std::string& name, const std::string& in_plane, const std::string& in_space) {
        page.set(name, plane && space ? in_plane + " (3D: " + in_space + ")" : plane ? in_plane : in_space);
    };
    words("disk", "disk", "sphere");
    words("disks", "disks", "spheres");
    words("ring", "ring", "shell");
    words("rings", "rings", "spherical shells");
    words("circle", "circle", "sphere");
    words("lattice", "hexagonal lattice", "face-centred cubic lattice");
    page.set("space", space);
}

PageData missing_in(const std::vector<const ReportRun*>& runs)
{
    PageData list{PageData::type::list};
    for (const ReportRun* run : runs)
        for (const std::string& sentence : run->stored->missing) list << PageData{sentence};
    return list;
}

std::string summary_of(const std::vector<const ReportRun*>& runs)
{
    std::string text;
    for (const auto& part :
         {series_summary(runs), tilings_summary(runs), constructions_summary(runs), distributions_summary(runs)})
        if (!part.empty()) text += (text.empty() ? "" : " ") + part;
    return text;
}

}
