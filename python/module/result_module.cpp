// Output folders for Python: running configs, and reading what runs came to.
#include "analysis/spectra/spectrum_file.hpp"
#include "base/crew/thread_limit.hpp"
#include "base/errors/errors.hpp"
#include "experiment/run/run_plan.hpp"
#include "experiment/run/runner.hpp"
#include "experiment/store/unit_store.hpp"
#include "python/module/module_parts.hpp"
#include "python/module/series_module.hpp"
#include "reports/site/report.hpp"
#include "results/collection_file.hpp"
#include "results/curve_tables.hpp"
#include "results/run.hpp"
#include "results/stored_points.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace py = pybind11;
namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// A series of an output folder. Its files are read when they are asked for.
class StoredSeries
{
public:
    StoredSeries(std::shared_ptr<const Run> run, std::size_t index) : run_(std::move(run)), index_(index) {}

    const Series& series() const { return run_->series[index_]; }
    int dimension() const { return run_->dimension; }

    std::vector<RadialBin> radial() const { return read(series().radial_file, read_radial_table); }
    std::vector<PairCorrelationBin> pairs() const
    {
        return read(series().pair_correlation_file, read_pair_correlation_table);
    }
    std::vector<NumberVarianceBin> number_variance() const
    {
        return read(series().number_variance_file, read_number_variance_table);
    }
    std::vector<RegionCurveRow> region() const
    {
        return read(series().region ? series().region->file : std::string(), read_region_curves);
    }
    std::vector<Spectrum> spectra() const { return read(series().spectrum_file, read_spectrum_planes); }
    bool are_planes() const { return dimension() == 3; }

    std::vector<PointSet> sets() const
    {
        std::vector<PointSet> sets;
        for (const std::string& file : series().point_files)
            for (PointSet& set : read_stored_points(series(), run_->folder / file)) sets.push_back(std::move(set));
        return sets;
    }

    std::vector<FigurePicture> figure() const { return draw_series_figure(*run_, index_); }

private:
    /// The content of a file, nothing where the series has none.
    template <typename Content>
    Content read(const std::string& file, Content (*reader)(const fs::path&)) const
    {
        return file.empty() ? Content{} : reader(run_->folder / file);
    }

    std::shared_ptr<const Run> run_;
    std::size_t index_;
};

/// An output folder that was read.
class StoredRun
{
public:
    explicit StoredRun(const fs::path& folder)
        : run_(std::make_shared<const Run>(without_lock([&] { return read_run(folder); })))
    {}

    const Run& run() const { return *run_; }

    std::vector<StoredSeries> series() const
    {
        std::vector<StoredSeries> all;
        for (std::size_t i = 0; i < run_->series.size(); ++i) all.emplace_back(run_, i);
        return all;
    }

private:
    std::shared_ptr<const Run> run_;
};

/// The runs of a folder: one, or those of a collection.
std::vector<StoredRun> open_folder(const fs::path& folder)
{
    std::vector<StoredRun> runs;
    for (const fs::path& each : without_lock([&] { return output_folders(folder); })) runs.emplace_back(each);
    return runs;
}

void report(const fs::path& folder, const fs::path& out)
{
    without_lock([&] { write_report({folder}, out, [](const std::string&) { stop_if_interrupted(); }); });
}

/// An output folder, and a sentence on each series that was left out of it.
using RunOutcome = std::pair<fs::path, std::vector<std::string>>;

/// Carries out what `poissonlab run` does in one process, without a word.
RunOutcome run_config(const std::string& config, const fs::path& out, const std::vector<std::string>& changes,
                      const std::string& device, int threads, bool with_report)
{
    return without_lock([&] {
        const ThreadLimit limit(threads);
        RunOptions options;
        options.config = config;
        options.out = out;
        options.device = device;
        options.overrides = changes;
        options.threads = threads;
        options.command = "poissonlab.run(" + config + ")";
        const RunPlan plan = plan_run(options, ThreadLimit::current());
        RunSettings settings;
        settings.units = plan.out / unit_folder_name;
        CollectionFile done{plan.title, options.command, {}};
        std::vector<std::string> left_out;
        for (const PlannedRun& run : plan.runs)
            std::ranges::copy(run.experiment.left_out, std::back_inserter(left_out));
        settings.on_published = [&](const PlannedRun& run) { done.runs.push_back(run.out.filename().string()); };
        Progress progress(Progress::Style::quiet);
        const RunsOutcome outcome = run_experiments(plan.runs, settings, *make_crew_of_one(), progress);
        if (plan.is_collection) write_collection_file(plan.out, done);
        if (with_report && outcome.is_published)
            write_report({plan.out}, plan.out, [](const std::string&) { stop_if_interrupted(); });
        outcome.raise_failures();
        return RunOutcome{plan.out, std::move(left_out)};
    });
}

}

void add_results(py::module_& module)
{
    py::class_<StoredSeries> series(module, "StoredSeries", "A series of an output folder.");
    bind_series<StoredSeries>(series);
    py::class_<StoredRun>(module, "StoredRun", "An output folder.")
        .def_property_readonly("title", [](const StoredRun& run) { return run.run().title; })
        .def_property_readonly("folder", [](const StoredRun& run) { return run.run().folder; })
        .def_property_readonly("config", [](const StoredRun& run) { return run.run().config; })
        .def_property_readonly("seed", [](const StoredRun& run) { return run.run().seed; })
        .def_property_readonly("engine", [](const StoredRun& run) { return run.run().engine; })
        .def_property_readonly("version", [](const StoredRun& run) { return run.run().version; })
        .def("series", &StoredRun::series);
    module.def("open", open_folder, py::arg("folder"));
    module.def("report", report, py::arg("folder"), py::arg("out"));
    module.def("run", run_config, py::arg("config"), py::arg("out"), py::arg("changes"), py::arg("device"),
               py::arg("threads"), py::arg("report"));
}

}
