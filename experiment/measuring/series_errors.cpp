// The standard errors of a series' spectral measures: from how its realizations, or its tile sets, differ.
#include "experiment/measuring/series_analysis.hpp"

#include "analysis/measures/hyperuniformity.hpp"
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/spectra/radial_bin.hpp"
#include "analysis/statistics/jackknife.hpp"

namespace poissonlab {

double CurveErrors::of(const Statistic& statistic) const
{
    return error_of_ ? error_of_(curves_.front(), statistic) : jackknife_error(curves_, statistic);
}

double CurveErrors::of_squares(const Statistic& statistic) const
{
    return jackknife_error_of_squares(curves_, statistic);
}

/// The group of each curve, where a set has so many of them; curves of one group depend on each other. A group is a
/// tile set, where there are several, else the set. None where each curve stands for itself.
std::vector<std::size_t> SeriesAnalysis::independent_groups(std::size_t curves_of_set) const
{
    std::vector<std::size_t> groups;
    if (options_.tile_sets <= 1 && curves_of_set == 1) return groups;
    for (const SetMeasures& set : sets_)
        groups.insert(groups.end(), curves_of_set,
                      options_.tile_sets > 1 ? set.realization % options_.tile_sets : set.realization);
    return groups;
}

/// Errors of statistics of the mean curve in bins one sample wide.
CurveErrors SeriesAnalysis::curve_errors(const std::vector<RadialBin>& radial) const
{
    const auto& each = estimate_.value().radial_curves();
    if (has_tapers() && sets_.size() == 1) return region_->curve_errors(radial, spectrum_size_);
    return CurveErrors(group_means(each, independent_groups(curves_of_set())));
}

/// The error of the exponent follows from how much it depends on single realizations or tile sets: a curve that bends
/// leaves residuals in the likelihood that are no chance.
void SeriesAnalysis::measure_exponent_error(const std::vector<PowerShell>& shells, int realizations, double least)
{
    const CurveErrors errors(group_means(shell_powers_, independent_groups()));
    if (!errors.are_known()) return;
    Estimate& exponent = measures_.numbers["hyperuniformity_exponent"];
    exponent.standard_error = errors.of([&](const std::vector<double>& powers) {
        std::vector<PowerShell> some = shells;
        for (std::size_t i = 0; i < some.size(); ++i) some[i].power = powers[i];
        const auto found = hyperuniformity_exponent(some, realizations, least);
        return found ? found->value : exponent.value;
    });
}

/// Standard errors from how much the measures depend on single realizations, or on single tile sets.
void SeriesAnalysis::measure_errors(std::vector<RadialBin> radial, const Spectrum& mean)
{
    const CurveErrors errors = curve_errors(radial);
    if (!errors.are_known()) return; // of one set, or all are of one tile set
    const std::size_t n = sets_.front().points;
    const FrequencyRange low = low_frequency_range(n, mean.dimension);
    const auto of_curve = [&](const auto& measure) {
        return [&, measure](const std::vector<double>& power) {
            for (std::size_t k = 0; k < radial.size(); ++k) radial[k].power = power[k];
            return measure(radial);
        };
    };
    using Curve = std::vector<RadialBin>;
    if (sets_.size() > 1) { // of one set by tapers, steep rises and noise that adds to squares would have half too much
        if (const auto found = measures_.numbers.find("effective_nyquist"); found != measures_.numbers.end())
            found->second.standard_error = errors.of(of_curve([&](const Curve& curve) {
                return effective_nyquist_frequency(curve, n, mean.dimension).value_or(found->second.value);
            }));
        if (measures_.oscillation)
            measures_.oscillation->standard_error = errors.of_squares(
                of_curve([&](const Curve& curve) { return oscillation(curve, n, mean.dimension).value; }));
    }
    if (const auto found = measures_.numbers.find("low_frequency_mean"); found != measures_.numbers.end())
        found->second.standard_error =
            errors.of(of_curve([&](const Curve& curve) { return mean_power_in(curve, low).value(); }));
    if (auto& fit = measures_.low_frequency_power) {
        const LowFrequencyPower whole = *fit;
        fit->exponent_standard_error = errors.of(
            of_curve([&](const Curve& curve) { return low_frequency_power(curve, low).value_or(whole).exponent; }));
        fit->intercept_standard_error = errors.of(
            of_curve([&](const Curve& curve) { return low_frequency_power(curve, low).value_or(whole).intercept; }));
    }
    if (measures_.lattice_peaks) measure_lattice_errors();
}

void SeriesAnalysis::measure_lattice_errors()
{
    const auto errors_of = [&](std::vector<double> SetMeasures::*list) {
        std::vector<std::vector<double>> powers;
        for (const SetMeasures& set : sets_) powers.push_back(set.*list);
        return CurveErrors(group_means(powers, independent_groups()));
    };
    const CurveErrors of_shells = errors_of(&SetMeasures::lattice_shells);
    if (of_shells.are_known() && measures_.lattice_peaks->empty_rings == 0)
        measures_.lattice_peaks->mean_ratio_standard_error = of_shells.of(
            [&](const std::vector<double>& mean) { return mean_ratio_of_shells(mean, sets_.front().points); });
    if (!measures_.numbers.contains("near_lattice_peaks")) return;
    const CurveErrors errors = errors_of(&SetMeasures::near_lattice);
    if (!errors.are_known()) return;
    const auto error_of = [&](double NearLatticePeaks::*member) {
        return errors.of([&](const std::vector<double>& mean) {
            return near_lattice_peaks(mean, sets_.front().points).value_or(NearLatticePeaks{}).*member;
        });
    };
    measures_.numbers["near_lattice_peaks"].standard_error = error_of(&NearLatticePeaks::mean_ratio);
    measures_.numbers["lattice_excess"].standard_error = error_of(&NearLatticePeaks::excess_share);
}

/// Sets the error of the peak anisotropy where it is known: not of one set, whose tapers are not independent, nor where
/// realizations share tile sets, in which their rings are alike.
void SeriesAnalysis::measure_peak_error(const std::vector<RadialBin>& radial, const Spectrum& mean)
{
    auto& peak = measures_.peak_anisotropy;
    const auto groups = independent_groups();
    const bool are_independent =
        groups.empty() || group_means(std::vector<double>(groups.size()), groups).size() == groups.size();
    if (peak && are_independent && !has_tapers() && mean.realizations >= 2)
        peak->standard_error_db = peak_anisotropy_error_db(radial, *peak, mean);
}

}
