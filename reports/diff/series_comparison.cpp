// Which numbers of a series are compared, each with its unit and which way is better.
#include "reports/diff/run_comparison.hpp"
#include "results/pair_correlation_table.hpp"
#include "results/radial_table.hpp"

namespace poissonlab {

namespace {

class SeriesNumbers
{
public:
    explicit SeriesNumbers(const SeriesComparison& pair) : pair_(pair)
    {
        const auto& a = *pair.before;
        const auto& b = *pair.after;
        terms_.same_seed = !pair.run_before->seed.empty() && pair.run_before->seed == pair.run_after->seed &&
                           pair.run_before->engine == pair.run_after->engine && a.parameters == b.parameters;
        terms_.deterministic = a.deterministic && b.deterministic;
        terms_.one_tile_set = a.sampler.ends_with("-tiles");
    }

    /// Nothing where neither has it; where one has it, listed without a verdict.
    template <typename Value, typename Judge>
    void add(NumberComparison number, const std::optional<Value>& before, const std::optional<Value>& after,
             const Judge& judge_both, double Value::*shown)
    {
        if (!before && !after) return;
        if (before && after) {
            judge_both(number, *before, *after);
        } else {
            number.note = before ? "only in the old results" : "only in the new results";
            (before ? number.before : number.after) = SampleMean{(before ? *before : *after).*shown, 0, 1};
        }
        numbers_.push_back(std::move(number));
    }

    void add_statistic(NumberComparison number, const std::optional<Statistic>& before,
                       const std::optional<Statistic>& after)
    {
        const auto judge_both = [&](NumberComparison& both, const Statistic& a, const Statistic& b) {
            if (!a.each.empty() && !b.each.empty()) return judge(both, a.each, b.each, terms_);
            both.before = SampleMean{a.mean, 0, 1};
            both.after = SampleMean{b.mean, 0, 1};
            judge(both, terms_);
        };
        add(std::move(number), before, after, judge_both, &Statistic::mean);
    }

    /// A number of all realizations together, with its standard error where one is stored.
    void add_estimate(NumberComparison number, const std::optional<SampleMean>& before,
                      const std::optional<SampleMean>& after)
    {
        const auto judge_both = [&](NumberComparison& both, const SampleMean& a, const SampleMean& b) {
            both.before = a;
            both.after = b;
            judge(both, terms_);
        };
        add(std::move(number), before, after, judge_both, &SampleMean::value);
    }

    /// A number of the first realization.
    void add_single(NumberComparison number, const std::optional<double>& before, const std::optional<double>& after)
    {
        const auto single = [](const std::optional<double>& value) {
            return value ? std::optional(SampleMean{*value, 0, 1}) : std::nullopt;
        };
        add_estimate(std::move(number), single(before), single(after));
    }

    void add_points();
    void add_distances();
    void add_measures();
    void add_integration();
    void add_curves();
    void add_zone_plate();
    void add_times();

    std::vector<NumberComparison> take() { return std::move(numbers_); }

private:
    static NumberComparison named(const std::string& quantity, const std::string& unit, Better better)
    {
        NumberComparison number;
        number.quantity = quantity;
        number.unit = unit;
        number.better = better;
        return number;
    }

    /// What `member` gives of both series' measures.
    template <typename Member>
    void add_measure(const NumberComparison& number, const Member& member)
    {
        add_estimate(number, member(*pair_.before), member(*pair_.after));
    }

    void add_spectral_measures();
    void add_fit();
    void add_curve(const NumberComparison& number, const std::vector<CurvePoint>& before,
                   const std::vector<CurvePoint>& after, const std::string& place);

    const SeriesComparison& pair_;
    ComparisonTerms terms_;
    std::vector<NumberComparison> numbers_;
};

std::size_t samples_of(const Series& series) { return static_cast<std::size_t>(series.realizations); }

std::optional<SampleMean> estimate(double value, const std::optional<double>& error, const Series& series)
{
    return SampleMean{value, error.value_or(0), samples_of(series)};
}

void SeriesNumbers::add_points()
{
    auto number = named("points", "", Better::neither);
    number.before = SampleMean{static_cast<double>(pair_.before->points), 0, 1};
    number.after = SampleMean{static_cast<double>(pair_.after->points), 0, 1};
    const bool same = pair_.before->points == pair_.after->points;
    number.verdict = same ? Verdict::identical : Verdict::changed;
    numbers_.push_back(number);
}

void SeriesNumbers::add_distances()
{
    const auto& a = *pair_.before;
    const auto& b = *pair_.after;
    add_statistic(named("relative radius", "", Better::higher), a.relative_radius, b.relative_radius);
    add_statistic(named("minimum distance", "", Better::higher), a.min_distance, b.min_distance);
    add_statistic(named("covered fraction", "", Better::higher), a.covered_fraction, b.covered_fraction);
}

void SeriesNumbers::add_spectral_measures()
{
    using Estimate = std::optional<SampleMean>;
    add_measure(named("effective Nyquist frequency", "√N / 2 (3D: ∛N / 2)", Better::higher),
                [](const Series& s) -> Estimate {
                    if (!s.measures.effective_nyquist) return std::nullopt;
                    return estimate(*s.measures.effective_nyquist, s.measures.effective_nyquist_error, s);
                });
    add_measure(named("oscillation", "", Better::lower), [](const Series& s) -> Estimate {
        if (!s.measures.oscillation) return std::nullopt;
        return estimate(s.measures.oscillation->value, s.measures.oscillation->standard_error, s);
    });
    add_measure(named("peak anisotropy", "dB", Better::lower), [](const Series& s) -> Estimate {
        if (!s.measures.peak_anisotropy) return std::nullopt;
        return estimate(s.measures.peak_anisotropy->db, s.measures.peak_anisotropy->standard_error_db, s);
    });
    add_measure(named("mean lattice peak", "", Better::lower), [](const Series& s) -> Estimate {
        if (!s.measures.lattice_peaks) return std::nullopt;
        return estimate(s.measures.lattice_peaks->mean_ratio, s.measures.lattice_peaks->mean_ratio_error, s);
    });
}

void SeriesNumbers::add_fit()
{
    using Estimate = std::optional<SampleMean>;
    add_measure(named("low-frequency exponent", "", Better::neither), [](const Series& s) -> Estimate {
        if (!s.measures.low_frequency_power) return std::nullopt;
        return estimate(s.measures.low_frequency_power->exponent, s.measures.low_frequency_power->exponent_error, s);
    });
    add_measure(named("power towards frequency 0", "", Better::lower), [](const Series& s) -> Estimate {
        if (!s.measures.low_frequency_power) return std::nullopt;
        return estimate(s.measures.low_frequency_power->intercept, s.measures.low_frequency_power->intercept_error, s);
    });
}

void SeriesNumbers::add_integration()
{
    const auto of = [](const Series& s, const std::string& integrand) -> std::optional<SampleMean> {
        for (const auto& integral : s.measures.integration)
            if (integral.integrand == integrand) return estimate(integral.rms_error, integral.standard_error, s);
        return std::nullopt;
    };
    for (const auto& integral : pair_.before->measures.integration)
        add_estimate(named("error of integrals, " + integral.integrand, "", Better::lower),
                     of(*pair_.before, integral.integrand), of(*pair_.after, integral.integrand));
}

void SeriesNumbers::add_measures()
{
    add_spectral_measures();
    add_fit();
    add_integration();
    const auto& a = pair_.before->measures;
    const auto& b = pair_.after->measures;
    add_single(named("largest gap", "", Better::lower), a.largest_empty_radius, b.largest_empty_radius);
    const auto variance = [](const Measures& measures) {
        return measures.voronoi ? std::optional(measures.voronoi->relative_area_variance) : std::nullopt;
    };
    const auto six = [](const Measures& measures) {
        return measures.voronoi ? std::optional(measures.voronoi->neighbour_share[2]) : std::nullopt;
    };
    add_single(named("variance of Voronoi areas", "", Better::neither), variance(a), variance(b));
    add_single(named("Voronoi cells with 6 neighbours", "", Better::neither), six(a), six(b));
}

void SeriesNumbers::add_curve(const NumberComparison& number, const std::vector<CurvePoint>& before,
                              const std::vector<CurvePoint>& after, const std::string& place)
{
    NumberComparison both = number;
    judge(both, before, after, place, terms_);
    numbers_.push_back(std::move(both));
}

std::vector<CurvePoint> radial_curve(const Run& run, const Series& series)
{
    std::vector<CurvePoint> curve;
    for (const auto& bin : read_radial_table(run.folder / series.radial_file))
        curve.push_back({bin.frequency, {bin.power, bin.power_error, samples_of(series)}});
    return curve;
}

std::vector<CurvePoint> pair_curve(const Run& run, const Series& series)
{
    std::vector<CurvePoint> curve;
    for (const auto& bin : read_pair_correlation_table(run.folder / series.pair_correlation_file))
        curve.push_back({bin.distance, {bin.value, bin.standard_error, samples_of(series)}});
    return curve;
}

void SeriesNumbers::add_curves()
{
    const auto& a = *pair_.before;
    const auto& b = *pair_.after;
    if (!a.radial_file.empty() && !b.radial_file.empty())
        add_curve(named("radially averaged power", "", Better::neither), radial_curve(*pair_.run_before, a),
                  radial_curve(*pair_.run_after, b), "frequency");
    if (!a.pair_correlation_file.empty() && !b.pair_correlation_file.empty())
        add_curve(named("pair correlation", "", Better::neither), pair_curve(*pair_.run_before, a),
                  pair_curve(*pair_.run_after, b), "distance");
}

void SeriesNumbers::add_zone_plate()
{
    using Errors = std::optional<Statistic>;
    const auto whole = [](const Series& s) { return s.zone_plate ? Errors(s.zone_plate->rms_error) : std::nullopt; };
    const auto resolved = [](const Series& s) {
        return s.zone_plate ? s.zone_plate->resolved_rms_error : std::nullopt;
    };
    add_statistic(named("zone plate error", "", Better::lower), whole(*pair_.before), whole(*pair_.after));
    add_statistic(named("zone plate error, where resolved", "", Better::lower), resolved(*pair_.before),
                  resolved(*pair_.after));
}

// Times compare on the same machine with the same device, driver and number of threads.
void SeriesNumbers::add_times()
{
    const auto& a = pair_.before->sample_seconds;
    const auto& b = pair_.after->sample_seconds;
    if (a.empty() || b.empty()) return;
    auto number = named("time to generate", "s", Better::lower);
    judge_times(number, a, b);
    if (pair_.run_before->machine != pair_.run_after->machine) {
        number.verdict = Verdict::not_comparable;
        number.note = "other device, driver or threads";
    }
    numbers_.push_back(std::move(number));
}

}

std::vector<NumberComparison> compare_series(const SeriesComparison& pair)
{
    SeriesNumbers numbers(pair);
    numbers.add_points();
    numbers.add_distances();
    numbers.add_measures();
    numbers.add_curves();
    numbers.add_zone_plate();
    numbers.add_times();
    return numbers.take();
}

}
