// The analysis of sets in memory for Python: what `poissonlab analyze` computes, in the same steps and so with the same
// bits, without files in between.
#include "base/errors/errors.hpp"
#include "base/files/scratch_folder.hpp"
#include "base/points/flat_points.hpp"
#include "experiment/measuring/series_analysis.hpp"
#include "experiment/run/runner.hpp"
#include "experiment/series/imported_points.hpp"
#include "experiment/series/series_units.hpp"
#include "python/module/module_parts.hpp"
#include "python/module/series_module.hpp"
#include "reports/site/report.hpp"
#include "results/file_names.hpp"

#include <fmt/format.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <utility>

namespace py = pybind11;

namespace poissonlab {
namespace {

/// Does what may throw InputError because of an argument, and says so.
template <class Work>
auto said_by_call(const Work& work)
{
    try {
        return work();
    } catch (const InputError& error) {
        throw error.place().is_argument ? error.moved_to({"analyze"}) : error;
    }
}

/// Sets that were analysed.
class AnalysedSets
{
public:
    /// `is_known_periodic`: nothing is said of pairs across the border.
    AnalysedSets(const std::vector<AnyArray>& arrays, const std::string& label, const std::vector<std::string>& changes,
                 bool is_known_periodic)
    {
        const auto options = said_by_call([&] { return overridden_region(changes, {}); });
        for (std::size_t i = 0; i < arrays.size(); ++i) {
            const std::string name = fmt::format("{}: realization {}", label, i);
            sets_.push_back(point_set_of(arrays[i], name, options.has_value(), argument_words));
        }
        if (sets_.empty()) throw InputError(label + ": there are no points");
        if (const auto axis = flat_axis(sets_)) {
            for (PointSet& set : sets_) set = without_axis(std::move(set), *axis);
            warnings_.push_back(fmt::format("{}: {}", label, flat_sentence(*axis)));
        }
        for (std::size_t i = 0; options && i < sets_.size(); ++i) // throws where some are outside
            options->region->framed(sets_[i], fmt::format("{}: realization {}", label, i));
        without_lock([&] {
            experiment_ = import_sets(sets_, label);
            experiment_.overrides = changes;
            experiment_.analysis = said_by_call([&] { return overridden_analysis(changes, dimension()); });
            experiment_.analysis.is_periodic = is_known_periodic;
            experiment_.analysis.is_foreign = !is_known_periodic;
            analyse();
        });
    }

    const Series& series() const { return series_; }
    int dimension() const { return sets_.front().dimension; }
    const std::vector<RadialBin>& radial() const { return radial_; }
    const std::vector<PairCorrelationBin>& pairs() const { return pairs_; }
    const std::vector<NumberVarianceBin>& number_variance() const { return number_variance_; }
    const std::vector<RegionCurveRow>& region() const { return region_; }
    const std::vector<PointSet>& sets() const { return sets_; }
    /// The notices for the caller, a sentence or two each.
    const std::vector<std::string>& warnings() const { return warnings_; }
    const std::vector<Spectrum>& spectra() const { return spectra_; }
    static bool are_planes() { return false; }

    /// Draws from files, as every report does.
    std::vector<FigurePicture> figure() const
    {
        const ScratchFolder scratch;
        write_results(scratch.path() / "results");
        return draw_series_figure(read_run(scratch.path() / "results"), 0);
    }

    /// The output folder and report of `poissonlab analyze`.
    void report(const std::filesystem::path& folder) const
    {
        without_lock([&] {
            write_results(folder);
            write_report({folder}, folder, [](const std::string&) { stop_if_interrupted(); });
        });
    }

private:
    /// Parts are put together as those of a series that is stored: sums depend on the order.
    void analyse()
    {
        const std::string& label = experiment_.series.front().label;
        AnalysisOptions options = experiment_.analysis;
        options.zone_plate = false; // is for reports
        SeriesAnalysis whole(label, false, options);
        add(whole, 0);
        for (std::size_t first = realizations_per_part; first < sets_.size(); first += realizations_per_part) {
            const SeriesAnalysis::Begin begin{static_cast<std::uint32_t>(first), sets_.front().size()};
            SeriesAnalysis part(label, false, options, begin);
            add(part, first);
            if (part.repeats(whole)) {
                part = SeriesAnalysis(label, false, options, begin);
                part.leave_out(whole);
                add(part, first);
            }
            whole.append(part);
        }
        measure(whole);
    }

    void add(SeriesAnalysis& analysis, std::size_t first) const
    {
        const std::size_t end = std::min<std::size_t>(sets_.size(), first + realizations_per_part);
        for (std::size_t i = first; i < end; ++i) {
            stop_if_interrupted();
            analysis.add(sets_[i]);
        }
    }

    void measure(SeriesAnalysis& analysis)
    {
        if (const std::string mixture = mixture_words(series_); !mixture.empty())
            warnings_.push_back(fmt::format("{}: {}", series_.label, mixture));
        if (analysis.has_spectrum()) {
            spectra_.push_back(analysis.mean_spectrum());
            radial_ = analysis.radial_curve(spectra_.front());
            analysis.measure_spectrum(spectra_.front());
        }
        stop_if_interrupted();
        analysis.measure_first();
        pairs_ = analysis.pair_correlation();
        number_variance_ = analysis.number_variance();
        region_ = analysis.region_curves();
        series_ = analysis.result();
        series_.name = experiment_.series.front().name;
        series_.label = experiment_.series.front().label;
        if (const std::string border = border_words(series_); !border.empty())
            warnings_.push_back(fmt::format("{}: {} {}", series_.label, border, border_advice(dimension())));
        if (analysis.has_spectrum()) series_.radial_file = file_names::radial;
    }

    void write_results(const std::filesystem::path& folder) const
    {
        Progress progress(Progress::Style::quiet);
        run_experiment(experiment_, folder, progress);
    }

    std::vector<PointSet> sets_;
    std::vector<std::string> warnings_;
    Experiment experiment_;
    Series series_;
    std::vector<RadialBin> radial_;
    std::vector<PairCorrelationBin> pairs_;
    std::vector<NumberVarianceBin> number_variance_;
    std::vector<RegionCurveRow> region_;
    std::vector<Spectrum> spectra_; ///< one, or none
};

}

void add_analysis(py::module_& module)
{
    py::class_<AnalysedSets> type(module, "AnalysedSets", "Sets that were analysed.");
    type.def(py::init<const std::vector<AnyArray>&, const std::string&, const std::vector<std::string>&, bool>(),
             py::arg("sets"), py::arg("label"), py::arg("changes"), py::arg("is_known_periodic"));
    type.def_property_readonly("warnings", &AnalysedSets::warnings);
    bind_series<AnalysedSets>(type);
    type.def("report", &AnalysedSets::report, py::arg("folder"));
}

}
