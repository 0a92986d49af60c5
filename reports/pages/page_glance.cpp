// The series of a small run at a glance: points and spectrum beside each other, and a sentence that says what each is
// good for and what is wrong with it.
#include "reports/pages/page_parts.hpp"
#include "reports/pages/relative_link.hpp"
#include "reports/words/measure_words.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace poissonlab {

namespace {

/// More series would push everything else off the page: they are cards.
constexpr std::size_t most_at_a_glance = 12;

/// The series of smaller runs are all shown large, those of tables of pictures as well.
constexpr std::size_t most_in_small_run = 6;

/// The limits of the sentence.
constexpr double glance_far_apart = 0.65, glance_near = 0.4; ///< relative radius
constexpr double glance_quiet = 0.02, glance_noisy = 0.5;    ///< mean power at low frequencies
constexpr double glance_peaks = 1.5;                         ///< lattice peaks over the power around them
constexpr double glance_seams = 0.2;                         ///< deviation of the density at seams

/// What speaks for a series, and what against it.
struct Opinion
{
    std::vector<std::string> good, bad;
};

std::optional<double> glance_value(const ReportSeries& series, const char* key)
{
    const auto value = measure(key).get(*series.stored);
    return value ? std::optional(value->value) : std::nullopt;
}

void judge_distances(const ReportSeries& series, Opinion& opinion)
{
    const auto& radius = series.stored->relative_radius;
    if (!radius) return;
    const std::string words = "ρ = " + format_significant(radius->min, 3);
    if (radius->min >= glance_far_apart)
        opinion.good.push_back(fmt::format("all points keep apart ({})", words));
    else if (radius->min >= glance_near)
        opinion.bad.push_back(fmt::format("some points are near each other ({})", words));
    else
        opinion.bad.push_back(fmt::format("points nearly meet ({})", words));
}

void judge_noise(const ReportSeries& series, Opinion& opinion)
{
    const auto power = glance_value(series, "low_frequency_mean");
    if (!power) return;
    const std::string share = format_significant(100 * *power, 2) + " % of that of random points";
    if (*power <= glance_quiet)
        opinion.good.push_back("little noise at low frequencies, " + share);
    else if (*power <= glance_noisy)
        opinion.bad.push_back("noise at low frequencies, " + share);
    else
        opinion.bad.emplace_back("as noisy as random points");
}

void judge_directions(const ReportSeries& series, Opinion& opinion)
{
    if (glance_value(series, "peak_anisotropy")) {
        const double excess = anisotropy_beyond_chance(series);
        if (excess > 0)
            opinion.bad.push_back(fmt::format("directions or peaks, {} dB above chance", format_fixed(excess, 1)));
        else
            opinion.good.emplace_back("no directions");
    }
    if (const auto peaks = glance_value(series, "near_lattice_peaks"); peaks && *peaks > glance_peaks)
        opinion.bad.push_back(
            fmt::format("its tiles show as peaks, {} times the power around them", format_significant(*peaks, 2)));
    if (const auto seams = glance_value(series, "seam_density"); seams && *seams > glance_seams)
        opinion.bad.emplace_back("seams");
}

/// "Good: all points keep apart (ρ = 0.75), no directions. Wrong: noise at low frequencies, 6.2 % of ..."
std::string sentence_about(const ReportSeries& series)
{
    Opinion opinion;
    judge_distances(series, opinion);
    judge_noise(series, opinion);
    judge_directions(series, opinion);
    std::vector<std::string> parts;
    if (!opinion.good.empty()) parts.push_back(fmt::format("Good: {}.", fmt::join(opinion.good, "; ")));
    if (!opinion.bad.empty()) parts.push_back(fmt::format("Wrong: {}.", fmt::join(opinion.bad, "; ")));
    return fmt::format("{}", fmt::join(parts, " "));
}

PageData glance_pictures(const ReportSeries& series, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (const char* stem : {"points", "spectrum"})
        for (const Panel& panel : series.panels) {
            if (panel.stem != stem) continue;
            PageData data;
            data.set("source", relative_link(page_folder, series.pictures / shown_file(panel)));
            data.set("image_class", panel.image_class);
            data.set("alt", fmt::format("{}: {}", series.label, panel.title));
            list << data;
        }
    return list;
}

bool is_at_a_glance(const ReportRun& run, const ReportSeries& series)
{
    return run.series.size() <= most_in_small_run || !is_in_matrix(series);
}

}

bool has_glance(const ReportRun& run)
{
    const auto shown = std::ranges::count_if(run.series, [&](const auto& s) { return is_at_a_glance(run, s); });
    return shown > 0 && static_cast<std::size_t>(shown) <= most_at_a_glance;
}

PageData glance(const ReportRun& run, const std::filesystem::path& page_folder)
{
    PageData list{PageData::type::list};
    for (std::size_t i = 0; i < run.series.size(); ++i) {
        const ReportSeries& series = run.series[i];
        if (!is_at_a_glance(run, series)) continue;
        PageData row = series_identity(series, i);
        row.set("link", relative_link(page_folder, page_of(series)));
        row.set("pictures", glance_pictures(series, page_folder));
        row.set("sentence", optional_text(sentence_about(series)));
        row.set("size", fmt::format("N = {}", format_count(series.stored->points)));
        list << row;
    }
    return list;
}

}
