// Panels on pages: the picture with its axis or key, the words, the legend of a plot of several series.
#include "reports/drawings/cells_image.hpp"
#include "reports/images/tone_mapping.hpp"
#include "reports/pages/page_frame.hpp"
#include "reports/pages/page_parts.hpp"
#include "reports/words/number_format.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

/// Ticks at plus and minus the principal frequency, in percent of the picture's width.
PageData principal_ticks(const Curve& curve, const SpectrumPicture& picture)
{
    PageData ticks{PageData::type::list};
    const int size = picture.size;
    if (!curve.principal_frequency) return ticks;
    const double pixels = *curve.principal_frequency * picture.box.longest();
    if (pixels >= size / 2) return ticks;
    for (const double sign : {-1.0, 1.0})
        ticks << PageData("percent", fmt::format("{:.2f}", 100 * (size / 2 + 0.5 + sign * pixels) / size));
    return ticks;
}

/// Makes the axis below a 2D spectrum; planes of a 3D one have no common axis.
PageData spectrum_axis(const ReportSeries& series, const SpectrumPicture& picture)
{
    if (picture.dimension == 3) return false;
    PageData data;
    const int half = picture.size / 2;
    const auto frequency = [&](int pixel) {
        return format_fixed(pixel / picture.box.longest(), picture.box.is_unit() ? 0 : 1);
    };
    data.set("lowest", frequency(-half));
    data.set("highest", frequency(half - 1));
    data.set("ticks", principal_ticks(series.curve, picture));
    return data;
}

using Shares = std::array<double, cell_classes>;

/// Shares of all cells of the first realization, as stored; or of those in the picture where nothing is stored.
Shares shares_of(const ReportSeries& series, const CellsView& view)
{
    if (const auto& stored = series.stored->measures.voronoi) return stored->neighbour_share;
    Shares shares{};
    for (const auto& cell : view.cells)
        shares[cell_class(cell.neighbours)] += 1.0 / static_cast<double>(view.cells.size());
    return shares;
}

PageData cell_key(const Shares& shares)
{
    PageData entries{PageData::type::list};
    for (std::size_t i = 0; i < cell_classes; ++i) {
        PageData entry;
        entry.set("color", cell_class_color(i));
        entry.set("text", fmt::format("{}: {} %", cell_class_name(i), format_fixed(100 * shares[i], 1)));
        entries << entry;
    }
    return PageData("entries", entries);
}

PageData legend(const SeriesList& series, const Plot& plot, const PlotPlace& place)
{
    PageData list{PageData::type::list};
    for (const auto& curve : plot.curves) {
        PageData entry;
        entry.set("color", curve_color(curve.index));
        entry.set("dashes", optional_text(curve_dashes(curve.index)));
        entry.set("label", curve.label);
        const bool is_series = curve.index < series.size(); // and no method of the gallery
        entry.set("link", is_series ? PageData(relative_link(place.page_folder, page_of(*series[curve.index].series)))
                                    : PageData(false));
        list << entry;
    }
    return list;
}

/// A link to a file that may not be there.
PageData link_if_there(const PlotPlace& place, const std::string& name)
{
    const auto file = place.plots / name;
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return false;
    return relative_link(place.page_folder, file);
}

PageData overlay_data(const Panel& panel, const SeriesList& series, const PlotPlace& place)
{
    auto alt = fmt::format("{} {}: ", panel.title, panel.caption);
    for (const auto& curve : panel.plot()->curves) alt += (alt.ends_with(": ") ? "" : ", ") + curve.label;
    PageData data;
    data.set("title", panel.title);
    data.set("caption", panel.caption);
    data.set("how_to_read", optional_text(panel.guide));
    data.set("alt", alt);
    data.set("svg", relative_link(place.page_folder, place.plots / shown_file(panel)));
    data.set("png", link_if_there(place, print_file(panel)));
    data.set("legend", legend(series, *panel.plot(), place));
    return data;
}

/// The right end of the axis below a picture of points: in sides of the torus, or in the units that a box was given in.
PageData width_of(const PointsView& view, const ReportSeries& series)
{
    const auto& box = series.stored->box;
    return box ? fmt::format("{:.4g}", view.window * box->sides[0]) : format_significant(view.window, 2);
}

PageData file_link(const std::string& text, const std::string& link)
{
    PageData data;
    data.set("text", text);
    data.set("link", link);
    return data;
}

}

PageData panel_data(const ReportSeries& series, const Panel& panel)
{
    const auto* points = std::get_if<PointsView>(&panel.picture);
    const auto* cells = std::get_if<CellsView>(&panel.picture);
    const auto* spectrum = std::get_if<SpectrumPicture>(&panel.picture);
    const bool has_axis = spectrum && spectrum->part == SpectrumPicture::Part::whole;
    PageData data;
    data.set("title", panel.title);
    data.set("caption", panel.caption);
    data.set("alt", fmt::format("{}: {}. {}", series.label, panel.title, panel.caption));
    data.set("source", shown_file(panel));
    data.set("link", full_size_file(panel));
    data.set("image_class", panel.image_class);
    data.set("figure_class", optional_text(panel.figure_class));
    data.set("how_to_read", optional_text(panel.guide));
    data.set("window", points ? width_of(*points, series) : PageData(false));
    data.set("spectrum_axis", has_axis ? spectrum_axis(series, *spectrum) : PageData(false));
    data.set("cell_key", cells ? cell_key(shares_of(series, *cells)) : PageData(false));
    return data;
}

PageData panel_files(const ReportSeries& series, const Panel& panel)
{
    PageData links{PageData::type::list};
    for (const auto& stored : panel.stored)
        links << file_link(stored.words, relative_link(series.pictures, stored.file));
    if (const auto shown = shown_file(panel); shown.ends_with(".svg")) links << file_link("svg", shown);
    if (const auto png = link_if_there({series.pictures, series.pictures}, print_file(panel)); !png.is_false())
        links << file_link("png", png.string_value());
    PageData data;
    data.set("group", panel.title);
    data.set("links", links);
    data.set("more", false);
    return data;
}

PageData overlays(const std::vector<Panel>& panels, const SeriesList& series, const PlotPlace& place)
{
    PageData list{PageData::type::list};
    for (const auto& panel : panels) list << overlay_data(panel, series, place);
    return list;
}

PageData tone_scale()
{
    PageData ticks{PageData::type::list};
    for (const double power : {0.01, 0.1, 1.0, 10.0}) {
        PageData tick;
        tick.set("power", format_exact(power));
        tick.set("percent", fmt::format("{:.2f}", 100 * report_tone_mapping.position(power)));
        ticks << tick;
    }
    PageData data;
    data.set("scale_ticks", ticks);
    data.set("black_power", format_exact(report_tone_mapping.black_power));
    data.set("white_power", format_exact(report_tone_mapping.white_power));
    return data;
}

}
