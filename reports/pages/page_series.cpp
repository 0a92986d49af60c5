// The page of a series: panels, measures, and the stored files.
#include "reports/layout/site.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/pages/verdicts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

constexpr std::size_t most_point_files_linked = 20;

PageData point_files(const ReportSeries& series)
{
    PageData links{PageData::type::list};
    const auto& files = series.stored->point_files;
    const std::size_t linked = std::min(files.size(), most_point_files_linked);
    for (std::size_t i = 0; i < linked; ++i) {
        PageData link;
        link.set("text", std::to_string(i + 1));
        link.set("link", relative_link(series.pictures, series.run->folder / files[i]));
        links << link;
    }
    const auto hidden = files.size() - linked;
    PageData data;
    data.set("group", "Point sets");
    data.set("links", links);
    data.set("more", optional_text(hidden > 0 ? fmt::format("and {} more", format_count(hidden)) : ""));
    return data;
}

/// The mean of the sets' minimum distances, in the unit that the sets were given in.
PageData min_distance(const Series& series)
{
    std::optional<Statistic> distance = series.min_distance;
    const auto own = own_unit(series);
    if (distance && own) distance->mean *= own->lengths;
    PageData data = shown_mean(distance, 4);
    if (distance) data.set("unit", optional_text(own ? own->name : ""));
    return data;
}

PageData neighbour(const std::vector<ReportSeries>& all, std::size_t index, const std::filesystem::path& from)
{
    if (index >= all.size()) return false;
    PageData data;
    data.set("label", all[index].label);
    data.set("link", relative_link(from, page_of(all[index])));
    return data;
}

}

std::string render_series_page(const Site& site, const ReportRun& run, std::size_t index)
{
    const ReportSeries& series = run.series[index];
    PageData panels{PageData::type::list};
    PageData files{PageData::type::list};
    for (const auto& panel : series.panels) {
        panels << panel_data(series, panel);
        files << panel_files(series, panel);
    }
    files << point_files(series);
    auto data = series_identity(series, index);
    data.set("overview", relative_link(series.pictures, site.out / overview_page));
    data.set("run_link",
             site.has_several_runs() ? PageData(relative_link(series.pictures, page_of(run))) : PageData(false));
    data.set("previous", neighbour(run.series, index - 1, series.pictures)); // of the first there is none
    data.set("next", neighbour(run.series, index + 1, series.pictures));
    data.set("panels", panels);
    data.set("endless",
             optional_text(has_endless_page(series) ? relative_link(series.pictures, endless_page_of(series)) : ""));
    data.set("tone_scale", series.stored->spectrum_file.empty() ? PageData(false) : tone_scale());
    data.set("relative_radius", optional_text(radius_words(*series.stored, 4)));
    data.set("min_distance", min_distance(*series.stored));
    data.set("measures", measures_list(series));
    const auto& blue_noise = series.stored->blue_noise;
    data.set("blue_noise", optional_text(blue_noise ? blue_noise->words() : ""));
    data.set("left_out", optional_text(short_spectrum_words(*series.stored, run.stored->dimension)));
    data.set("border", optional_text(border_notice(series)));
    data.set("mixture", optional_text(series.stored->sampler == "file" ? mixture_words(*series.stored) : ""));
    data.set("file_groups", files);
    set_provenance(data, *run.stored);
    return render_in_frame(site, {page_of(series), series.label + " · " + site.title, {}}, "series", data);
}

}
