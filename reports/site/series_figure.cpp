#include "reports/site/series_figure.hpp"

#include "base/errors/errors.hpp"
#include "base/files/scratch_folder.hpp"
#include "base/files/whole_file.hpp"
#include "reports/images/picture_store.hpp"
#include "reports/layout/draw_panels.hpp"
#include "reports/layout/site.hpp"
#include "reports/plots/gnuplot.hpp"

#include <algorithm>
#include <array>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

/// The stems of the panels in the order in which papers have them.
constexpr std::array figure_stems = {"points", "spectrum", "radial", "anisotropy"};

/// The run with one of its series, and nothing else.
Run run_of_one(const Run& run, std::size_t index)
{
    Run alone = run;
    alone.methods.clear();
    alone.series = {run.series.at(index)};
    alone.series.front().place.reset();
    alone.tilings.clear();
    alone.constructions.clear();
    alone.distributions.clear();
    return alone;
}

std::vector<Panel> figure_panels(const std::vector<Panel>& all)
{
    std::vector<Panel> panels;
    for (const char* stem : figure_stems)
        std::ranges::copy_if(all, std::back_inserter(panels), [&](const Panel& panel) { return panel.stem == stem; });
    return panels;
}

FigurePicture read_picture(const Panel& panel, const fs::path& folder)
{
    const fs::path file = folder / shown_file(panel);
    return {panel.title, panel.caption, file.extension() == ".svg" ? "image/svg+xml" : "image/png",
            read_whole_file(file)};
}

}

std::vector<FigurePicture> draw_series_figure(const Run& run, std::size_t index)
{
    const ScratchFolder scratch;
    const std::vector<Run> runs = {run_of_one(run, index)};
    const Site site = make_site(runs, scratch.path(), "");
    const ReportSeries& series = site.runs.front().series.front();
    fs::create_directories(series.pictures);

    const std::vector<Panel> panels = figure_panels(series.panels);
    PictureStore store(scratch.path(), scratch.path() / "pictures.txt");
    std::vector<GnuplotPicture> plots;
    for (const Panel& panel : panels) {
        draw_panel(panel, series.pictures, store);
        add_plot(panel, series.pictures, plots);
    }
    draw_with_gnuplot(plots, PrintPictures::none);

    std::vector<FigurePicture> pictures;
    for (const Panel& panel : panels) pictures.push_back(read_picture(panel, series.pictures));
    return pictures;
}

}
