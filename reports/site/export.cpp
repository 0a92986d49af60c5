#include "reports/site/export.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "base/programs/interrupt.hpp"
#include "reports/claims/claim_table.hpp"
#include "reports/layout/site.hpp"
#include "reports/plots/plot_export.hpp"
#include "results/collection_file.hpp"
#include "results/run.hpp"
#include "results/stored_points.hpp"

#include <fmt/format.h>

#include <set>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

class Exporter
{
public:
    /// The plot of a panel, if it is one, in a folder that is made where it is missing.
    void add(const Panel& panel, const fs::path& folder)
    {
        const Plot* plot = panel.plot();
        if (plot == nullptr) return;
        write(folder / (panel.stem + ".csv"), plot_csv(*plot));
        write(folder / (panel.stem + ".tex"), plot_latex(*plot));
    }

    void add_points(const ReportSeries& series)
    {
        for (const std::string& name : series.stored->point_files) {
            const fs::path stored = series.run->folder / name;
            const std::vector<PointSet> sets = read_stored_points(*series.stored, stored);
            for (std::size_t i = 0; i < sets.size(); ++i) {
                const std::string number = sets.size() > 1 ? fmt::format("-{}", i + 1) : "";
                for (const char* extension : {".csv", ".usda"}) {
                    const fs::path file = series.pictures / (stored.stem().string() + number + extension);
                    prepare(file);
                    write_points(file, sets[i], series.full_label);
                }
            }
        }
    }

    /// A file, in a folder that is made where it is missing.
    void write(const fs::path& file, const std::string& content)
    {
        prepare(file);
        write_whole_file(file, content);
    }

private:
    void prepare(const fs::path& file)
    {
        stop_if_interrupted();
        std::error_code error;
        fs::create_directories(file.parent_path(), error);
        if (error) throw StorageError(fmt::format("{}: {}", file.parent_path().string(), error.message()));
    }
};

void export_plots(const Site& site, Exporter& exporter)
{
    for (const ReportRun& run : site.runs) {
        for (const ReportSeries& series : run.series)
            for (const Panel& panel : series.panels) exporter.add(panel, series.pictures);
        for (const auto* panels : {&run.overlays, &run.integration, &run.regions, &run.tile_radii})
            for (const Panel& panel : *panels) exporter.add(panel, run.root);
    }
    if (site.has_several_runs())
        for (const Panel& panel : site.overlays) exporter.add(panel, site.out);
}

/// The names of series tell them apart only within a run; those of 3D differ from those of 2D. Throws InputError for
/// the same name twice.
void export_gallery(const Site& site, Exporter& exporter)
{
    std::vector<GallerySource> sources;
    std::set<std::string> names;
    for (const ReportSeries* series : site.series()) {
        if (!series->stored->has_spectrum() || series->stored->region) continue; // curves of the torus and the plane
        sources.push_back({series->stored, series->label, &series->curve, series->run->seed, series->run->version});
        if (!names.insert(gallery_name(sources.back())).second)
            throw InputError(fmt::format("{}: the series {} is there twice; a gallery needs each once",
                                         series->run->folder.string(), series->stored->name));
    }
    const GalleryTables tables = gallery_tables(sources);
    exporter.write(site.out / "methods.csv", tables.methods);
    exporter.write(site.out / "measures.csv", tables.measures);
    exporter.write(site.out / "curves.csv", tables.curves);
}

}

void export_results(const std::vector<fs::path>& result_folders, const fs::path& out, const ExportParts& parts,
                    const std::function<void(const std::string&)>& progress)
{
    const auto say = [&](const std::string& step) {
        if (progress) progress(step);
    };
    say("reading results");
    std::vector<Run> runs;
    for (const auto& folder : output_folders(result_folders)) runs.push_back(read_run(folder));
    const Site site = make_site(runs, out, {});
    Exporter exporter;
    if (parts.plots) {
        say("writing plots");
        export_plots(site, exporter);
    }
    if (parts.gallery) {
        say("writing the tables of a gallery");
        export_gallery(site, exporter);
    }
    if (parts.claims) {
        say("judging the papers' claims");
        exporter.write(site.out / "claims.csv", claims_csv(judge_claims(site.series(), site.distributions())));
    }
    for (const ReportSeries* series : site.series()) {
        if (!parts.points) break;
        say("writing points of " + series->full_label);
        exporter.add_points(*series);
    }
}

}
