#include "results/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace poissonlab {
namespace {

using Value = std::optional<MeasuredValue>;
using Form = Digits::Form;

constexpr const char* of_largest_distance = "of the largest possible distance";

Value value_of(const std::optional<Statistic>& statistic)
{
    if (!statistic) return std::nullopt;
    return MeasuredValue{statistic->mean, {}, statistic->each, {{statistic->min, statistic->max}}};
}

Value sample_time(const Series& series)
{
    const std::vector<double>& seconds = series.sample_seconds;
    if (seconds.empty()) return std::nullopt;
    const auto [shortest, longest] = std::ranges::minmax(seconds);
    return MeasuredValue{median(seconds), {}, seconds, {{shortest, longest}}};
}

Value device_memory(const Series& series)
{
    if (series.device_bytes == 0) return std::nullopt;
    return MeasuredValue{static_cast<double>(series.device_bytes) / (1 << 20)};
}

Value shared_points(const Series& series)
{
    if (!series.tile_set || !series.tile_set->shared_points) return std::nullopt;
    return MeasuredValue{*series.tile_set->shared_points};
}

Value points_per_second(const Series& series)
{
    const Value time = sample_time(series);
    if (!time || time->value <= 0) return std::nullopt;
    return MeasuredValue{static_cast<double>(series.points) / time->value / 1e6};
}

Value build_time(const Series& series)
{
    const auto& set = series.tile_set;
    if (!set || !set->build) return std::nullopt;
    MeasuredValue value{set->build->seconds};
    if (set->cached) value.remark = "earlier";
    return value;
}

Value points(const Series& series)
{
    MeasuredValue value{static_cast<double>(series.points)};
    if (series.points_each.empty()) return value;
    const auto [fewest, most] = std::ranges::minmax(series.points_each);
    value.range = {static_cast<double>(fewest), static_cast<double>(most)};
    value.each.assign(series.points_each.begin(), series.points_each.end());
    return value;
}

Value sets(const Series& series)
{
    MeasuredValue value{static_cast<double>(series.realizations)};
    const std::size_t asked = static_cast<std::size_t>(series.realizations) + series.repeated.size();
    if (!series.repeated.empty()) value.remark = fmt::format("of {}: others are equal to these", asked);
    return value;
}

constexpr Digits significant(int digits) { return {Form::significant, digits}; }
constexpr Digits decimals(int digits) { return {Form::decimals, digits}; }

Measure row(const char* key, const char* name, const char* unit, Better better, MeasureKind kind, Digits digits,
            const char* meaning, std::function<Value(const Series&)> get)
{
    return {key, name, {}, unit, better, kind, digits, meaning, std::move(get)};
}

/// A row that the ranking shows when all measures are asked for.
Measure detail(Measure row)
{
    row.is_detail = true;
    return row;
}

Measure with_symbol(const char* symbol, Measure row)
{
    row.symbol = symbol;
    return row;
}

/// A row for the number of Measures::numbers with its key.
Measure number(const char* key, const char* name, const char* unit, Better better, MeasureKind kind, Digits digits,
               const char* meaning)
{
    Measure number = row(key, name, unit, better, kind, digits, meaning, [=](const Series& series) -> Value {
        const auto found = series.measures.numbers.find(key);
        if (found == series.measures.numbers.end()) return std::nullopt;
        return MeasuredValue{found->second.value, found->second.standard_error};
    });
    number.is_number = true;
    return number;
}

/// The way in which a row gets its value from a member of Measures, of series that have it.
template <class Member>
auto from(std::optional<Member> Measures::*member, double Member::*value)
{
    return [=](const Series& series) -> Value {
        const auto& found = series.measures.*member;
        return found ? Value(MeasuredValue{(*found).*value}) : std::nullopt;
    };
}

/// The way in which a row gets its value and its standard error from a member of Measures, of series that have it.
template <class Member, class Error>
auto from(std::optional<Member> Measures::*member, double Member::*value, Error Member::*standard_error)
{
    return [=](const Series& series) -> Value {
        const auto& found = series.measures.*member;
        return found ? Value(MeasuredValue{(*found).*value, (*found).*standard_error}) : std::nullopt;
    };
}

/// A row of an exponent, of series whose power goes with one.
Measure of_power_laws(Measure row)
{
    row.get = [get = row.get](const Series& series) -> Value {
        const Value exponent = get(series);
        if (!exponent || !is_power_law(series, exponent->value, exponent->standard_error.value_or(0)))
            return std::nullopt;
        return exponent;
    };
    return row;
}

/// The share of Voronoi cells with so many neighbours.
Measure cells(const char* key, const char* name, std::size_t neighbours)
{
    return detail(row(key, name, "%", Better::neither, MeasureKind::first, decimals(1),
                      "Of the first realization. 100 % with 6 is a hexagonal lattice.",
                      [=](const Series& series) -> Value {
                          const auto& cells = series.measures.voronoi;
                          if (!cells) return std::nullopt;
                          return MeasuredValue{100 * cells->neighbour_share.at(neighbours - 4)};
                      }));
}

/// The relative error of an integral. Its standard error follows from that of the root of the mean square error.
Value integral_error(const Series& series, const std::string& integrand)
{
    for (const IntegrationError& error : series.measures.integration) {
        if (error.integrand != integrand) continue;
        MeasuredValue value{error.relative_variance};
        if (error.standard_error > 0 && error.rms_error > 0)
            value.standard_error = 2 * error.standard_error / error.rms_error * error.relative_variance;
        return value;
    }
    return std::nullopt;
}

Measure integral(const std::string& integrand)
{
    const std::string key = "integration_" + integrand, name = "error of integrals, " + integrand;
    return detail(row(key.c_str(), name.c_str(), "of the squared error of random points", Better::lower,
                      MeasureKind::estimate, significant(2),
                      "The mean squared error of the mean over the points of a function whose integral is known, over "
                      "that of as many random points.",
                      [=](const Series& series) { return integral_error(series, integrand); }));
}

std::vector<Measure> sizes_and_distances()
{
    return {
        with_symbol("N", row("points", "points", "", Better::neither, MeasureKind::size, {Form::count}, "", points)),
        with_symbol("K",
                    row("realizations", "sets", "", Better::neither, MeasureKind::setting, {Form::count}, "", sets)),
        with_symbol(
            "ρ",
            row("relative_radius", "relative radius", of_largest_distance, Better::higher, MeasureKind::per_set,
                significant(4),
                "The smallest distance between two points, over the largest that so many points could keep: 0 for "
                "random points, 1 for a perfect lattice. Dart throwing of many points cannot pass "
                "0.777 in 2D and 0.804 in 3D; methods that move points reach 0.75 to 0.85, farthest points more than "
                "0.9; towards 1, points fall into rows. The mean over the K "
                "sets, and from the smallest to the largest.",
                [](const Series& series) { return value_of(series.relative_radius); })),
        detail(number("proven_relative_radius", "proven relative radius", of_largest_distance, Better::higher,
                      MeasureKind::size, significant(4),
                      "What is known without measuring: no set of the method has a smaller relative radius, by a proof "
                      "over all neighbourhoods that tiles can have.")),
        detail(
            number("relative_radius_within_tiles", "relative radius within tiles", of_largest_distance, Better::higher,
                   MeasureKind::estimate, significant(4),
                   "Of sets that are tiled: that of the nearest two points of one tile, where the relative radius is "
                   "of any two. Far above it, tiles do not fit at their borders; above 1 it can be where tiles have "
                   "few points. The mean over the K sets, with its standard error.")),
        detail(number("mean_nearest_distance", "mean nearest distance", of_largest_distance, Better::higher,
                      MeasureKind::estimate, significant(4),
                      "The distance from a point to the nearest other one, on average over all points and the K sets, "
                      "with its standard error: {0.465|0.494} for random points, 1 for a perfect lattice. Far above "
                      "the relative radius, few points are as near to another as the nearest two.")),
        detail(
            number("prefix_relative_radius", "relative radius of first parts", of_largest_distance, Better::higher,
                   MeasureKind::estimate, significant(3),
                   "The smallest relative radius of the first half, quarter and eighth of the points, each of as many "
                   "points: of methods whose points come in an order in which every first part is a good set. The "
                   "mean over the K sets, with its standard error.")),
        row("min_distance", "minimum distance", "of the torus' side; of the root of a region's area", Better::higher,
            MeasureKind::per_set, significant(4),
            "The same distance as it is: twice the radius of the {disks|spheres}. It compares between sets of the "
            "same number of points.",
            [](const Series& series) { return value_of(series.min_distance); }),
        detail(row("covered_fraction", "covered fraction", "", Better::higher, MeasureKind::per_set, significant(4),
                   "What {disks|balls} around the points cover whose diameter is the minimum distance: at most "
                   "{0.907|0.740}.",
                   [](const Series& series) { return value_of(series.covered_fraction); })),
        row("largest_empty", "largest empty circle", of_largest_distance, Better::lower, MeasureKind::first,
            significant(4),
            "The radius of the largest {circle|ball} without a point inside, of the first realization: at least "
            "0.577 in 2D. A gap above the relative radius has room for another point.",
            from(&Measures::largest_empty, &LargestEmptyBall::relative_radius)),
    };
}

std::vector<Measure> spectral_measures()
{
    using Fit = LowFrequencyPower;
    return {
        row("oscillation", "oscillation", "power", Better::lower, MeasureKind::estimate, significant(3),
            "How much the power goes up and down beyond its first rise above {√N|∛N} / 2, with its standard error.",
            from(&Measures::oscillation, &Oscillation::value, &Oscillation::standard_error)),
        number("effective_nyquist", "effective Nyquist frequency", "{√N|∛N} / 2", Better::higher, MeasureKind::estimate,
               significant(3),
               "The frequency up to which the mean power stays below 0.1, with its standard error: what lies below it "
               "is sampled almost without noise. It is 0 for random points, and for sets whose power levels out above "
               "0.1, as that of best candidate does, however far their low frequencies reach."),
        of_power_laws(detail(row(
            "low_frequency_exponent", "low-frequency exponent", "", Better::neither, MeasureKind::estimate, decimals(3),
            "b in power ~ frequency^b: 0 for random points, above 0 errors of integrals fall faster. It is the slope "
            "of a line through the logarithms of the rings' powers. The hyperuniformity exponent estimates the "
            "same b by maximum likelihood, without the bias of logarithms: it is the one to quote.",
            from(&Measures::low_frequency_power, &Fit::exponent, &Fit::exponent_standard_error)))),
        detail(row("low_frequency_intercept", "power towards frequency 0", "", Better::neither, MeasureKind::estimate,
                   decimals(3),
                   "1 for random points, 0.059 for saturated dart throwing. It is the value at frequency 0 of "
                   "a parabola that is fitted to the lowest frequencies, and falls below 0 where that does not fit.",
                   from(&Measures::low_frequency_power, &Fit::intercept, &Fit::intercept_standard_error))),
        detail(number("low_frequency_mean", "mean power at low frequencies", "", Better::lower, MeasureKind::estimate,
                      significant(2),
                      "Over the frequencies up to {√N|∛N} / 4, with its standard error: 1 for random points; stealthy "
                      "sets have 0.001 or less.")),
        of_power_laws(number(
            "hyperuniformity_exponent", "hyperuniformity exponent", "", Better::higher, MeasureKind::estimate,
            decimals(2),
            "b where power goes as frequency^b towards frequency 0, by maximum likelihood over the frequencies up to "
            "{√N|∛N} / 4, of tilings up to 0.4 of the frequency at which tiles repeat, with its standard error. 0 for "
            "random points; the higher, the more even the points are at large scales. Curves that bend within the "
            "range change it: displaced grids, whose power goes as frequency² in the end, have 1.85 to 2. Stealthy "
            "sets have no "
            "exponent: it says how deep they fall, or is 0 where all that is left is rounding. Sets whose power rises "
            "towards frequency 0, as long waves of a start do, have none.")),
        number(
            "hyperuniformity_p_value", "p-value of hyperuniformity", "", Better::neither, MeasureKind::estimate,
            significant(2),
            "The probability that a hyperuniform set looks as little hyperuniform as this one: the significance test "
            "of Klatt, Last and Henze. Below 0.05 the set is not hyperuniform: some power is left at frequency 0, "
            "however little (see the mean power at low frequencies). Larger values do not contradict hyperuniformity, "
            "and are "
            "no rank: 0.9 is no better than 0.3."),
        number("anisotropy_above_chance", "anisotropy above chance", "dB", Better::lower, MeasureKind::estimate,
               decimals(1),
               "How far the anisotropy of a {ring|shell} rises above the −10 log₁₀ K dB that chance gives, at most; 0 "
               "where no {ring|shell} stands out: of sets without directions fewer than one in a thousand are said to "
               "have any. {Rings|Shells} of fewer than 100 samples and those with less than a hundredth of the power "
               "of random points take no part."),
        detail(row("peak_anisotropy", "peak anisotropy", "dB", Better::lower, MeasureKind::estimate, decimals(1),
                   "The largest anisotropy of these {rings|shells}, with its standard error: chance alone stays near "
                   "−10 log₁₀ K dB, so that it compares only between sets of as many realizations; grids and repeated "
                   "tiles rise far above it.",
                   from(&Measures::peak_anisotropy, &PeakAnisotropy::db, &PeakAnisotropy::standard_error_db))),
        row("lattice_peaks", "mean lattice peak", "power over that around", Better::lower, MeasureKind::estimate,
            significant(3),
            "Mean power at the frequencies at which tiles repeat, over the power around them, with its standard error: "
            "1 where tiles leave no trace.",
            from(&Measures::lattice_peaks, &LatticePeaks::mean_ratio, &LatticePeaks::mean_ratio_standard_error)),
        detail(row("largest_lattice_peak", "largest lattice peak", "power over that around", Better::lower,
                   MeasureKind::estimate, significant(3),
                   "The largest of these peaks, which chance alone lets grow with their number.",
                   from(&Measures::lattice_peaks, &LatticePeaks::max_ratio))),
        detail(number("near_lattice_peaks", "mean lattice peak up to the first ring", "power over that around",
                      Better::lower, MeasureKind::estimate, significant(3),
                      "The mean of those peaks only that are where a good distribution has no power or its first "
                      "{ring|shell}, and seen most.")),
        detail(number("lattice_excess", "power in lattice peaks", "of all up to the first {ring|shell}", Better::lower,
                      MeasureKind::estimate, significant(2),
                      "What these peaks have above the power around them, of all power up to there: near 0 where tiles "
                      "leave no trace.")),
        detail(number("lattice_share", "power on the lattice", "of all", Better::lower, MeasureKind::estimate,
                      significant(2),
                      "The part of all power, up to the end of the spectrum, at the frequencies at which tiles repeat, "
                      "with its standard error: about 1/M{²|³} of M tiles along an axis where tiles leave no trace.")),
        detail(row("shared_points", "points that tiles share", "of a tile's points", Better::lower, MeasureKind::size,
                   significant(2),
                   "The part of its points that a tile has in common with another one of a tiling, on average, counted "
                   "in the first tile set. It predicts the power on the lattice.",
                   shared_points)),
        detail(
            number("off_lattice_anisotropy", "anisotropy between lattice peaks", "dB above chance", Better::lower,
                   MeasureKind::estimate, decimals(2),
                   "The mean anisotropy of {rings|shells} without the lattice's frequencies, above the −10 log₁₀ K dB "
                   "of chance: what few tiles that repeat leave everywhere.")),
        detail(
            number("seam_density", "deviation of the density at seams", "of the mean density", Better::lower,
                   MeasureKind::estimate, decimals(2),
                   "The largest deviation of the density from its mean, over the distance from the tiles' borders in "
                   "steps of a quarter of a disk's radius: 0 without seams.")),
        detail(number("border_density", "density near borders of tiles", "of the mean density", Better::neither,
                      MeasureKind::estimate, decimals(2),
                      "The density of the points that are within a disk's radius of the tiles' borders, at a relative "
                      "radius of 0.75: below 1 where tiles keep points away from each other's borders.")),
    };
}

std::vector<Measure> integrals_and_cells()
{
    std::vector<Measure> rows;
    for (const int dimension : {2, 3})
        for (const Integrand& integrand : integrands(dimension))
            if (Measure row = integral(integrand.name); std::ranges::find(rows, row.key, &Measure::key) == rows.end())
                rows.push_back(std::move(row));
    rows.push_back(cells("cells_5", "Voronoi cells with 5 neighbours", 5));
    rows.push_back(cells("cells_6", "Voronoi cells with 6 neighbours", 6));
    rows.push_back(cells("cells_7", "Voronoi cells with 7 neighbours", 7));
    rows.push_back(
        detail(row("voronoi_area_variance", "variance of Voronoi areas", "of their squared mean", Better::neither,
                   MeasureKind::first, decimals(4), "Of the first realization: 0.280 for random points.",
                   from(&Measures::voronoi, &VoronoiStatistics::relative_area_variance))));
    return rows;
}

std::vector<Measure> zone_plate_errors_and_times()
{
    return {
        row("zone_plate_error", "zone plate error", "RMS, white is 1", Better::lower, MeasureKind::per_set,
            significant(4),
            "The root mean square difference between the zone plate as the set samples it, one sample a pixel, and as "
            "it is with infinitely many samples, over the part that pixels can show. Errors do not tell noise from "
            "false patterns, which disturb more: regular points have small ones here, and rings that are not there in "
            "the picture.",
            [](const Series& s) { return s.zone_plate ? value_of(s.zone_plate->resolved_rms_error) : std::nullopt; }),
        detail(row("zone_plate_rms_error", "zone plate error, all of the picture", "RMS, white is 1", Better::lower,
                   MeasureKind::per_set, significant(4),
                   "Most of the plate is finer than any set can follow, so that all sets have much the same error.",
                   [](const Series& s) { return s.zone_plate ? value_of(s.zone_plate->rms_error) : std::nullopt; })),
        detail(
            row("device_memory", "device memory", "MiB", Better::lower, MeasureKind::size, significant(3),
                "The most that generating takes of an OpenCL device, as it is foretold before a run, with building the "
                "tile set. Methods that work on the host alone have none.",
                device_memory)),
        row("build_time", "time to build the tile set", "s", Better::lower, MeasureKind::time, {Form::seconds},
            "What the tile set takes to build, once for all tilings. “Earlier”: it was built by an earlier run, and "
            "that time was kept.",
            build_time),
        row("sample_time", "time to generate", "s, median", Better::lower, MeasureKind::time, {Form::seconds},
            "The median over the timed runs, without building kernels and tile sets, and from the shortest to the "
            "longest.",
            sample_time),
        row("points_per_second", "points per second", "millions", Better::higher, MeasureKind::time, significant(3),
            "Points of a set over the median time.", points_per_second),
    };
}

const char* kind_words(MeasureKind kind)
{
    constexpr std::array words{"none",
                               "none: exact",
                               "spread of the sets",
                               "standard error, where one is known",
                               "none: first set only",
                               "spread of the runs, on one machine"};
    return words.at(static_cast<std::size_t>(kind));
}

}

std::string in_dimension(const std::string& text, int dimension)
{
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = text.find('{', at), bar = text.find('|', open), close = text.find('}', open);
        result += text.substr(at, open - at);
        if (close == std::string::npos) break;
        const std::string plane = text.substr(open + 1, bar - open - 1), space = text.substr(bar + 1, close - bar - 1);
        result += dimension == 3 ? space : dimension == 2 ? plane : plane + " (3D: " + space + ")";
        at = close + 1;
    }
    return result;
}

std::string Measure::title() const
{
    std::string text = name;
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return symbol.empty() ? text : text + " " + symbol;
}

bool is_power_law(const Series& series, double exponent, double standard_error)
{
    constexpr double errors_below = 3;
    return !series.region && exponent >= -errors_below * standard_error;
}

const std::vector<Measure>& measures()
{
    static const std::vector<Measure> all = [] {
        std::vector<Measure> rows;
        for (const auto& some :
             {sizes_and_distances(), spectral_measures(), integrals_and_cells(), zone_plate_errors_and_times()})
            rows.insert(rows.end(), some.begin(), some.end());
        return rows;
    }();
    return all;
}

const Measure& measure(const std::string& key)
{
    const auto found = std::ranges::find(measures(), key, &Measure::key);
    if (found == measures().end()) throw std::out_of_range("no measure is called " + key);
    return *found;
}

std::string measures_table()
{
    std::string text = "| key | measure | unit | better | error |\n| --- | --- | --- | --- | --- |\n";
    constexpr std::array better{"higher", "lower", ""};
    for (const Measure& row : measures())
        text += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.key, in_dimension(row.name), in_dimension(row.unit),
                            better.at(static_cast<std::size_t>(row.better)), kind_words(row.kind));
    return text;
}

}
