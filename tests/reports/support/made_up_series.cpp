#include "tests/reports/support/made_up_series.hpp"

#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/images/square_image.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab::test {

Series& stored_of(ReportSeries& series) { return const_cast<Series&>(*series.stored); }

ReportSeries& MadeUpReport::add(const std::string& sampler, const NamedTexts& parameters, std::size_t points,
                                int dimension)
{
    Run& run = runs_.emplace_back();
    run.dimension = dimension;
    run.machine.device = "Test device";
    run.machine.threads = 2;
    Series& stored = stored_.emplace_back();
    stored.sampler = stored.label = sampler;
    stored.name = sampler + std::to_string(stored_.size());
    stored.parameters = parameters;
    if (sampler.ends_with("-tiles")) stored.defaults = {{"points_per_tile", "64"}, {"relative_radius", "0.75"}};
    stored.points = points;
    stored.realizations = 10;
    ReportSeries& series = series_.emplace_back();
    series.run = &run;
    series.stored = &stored;
    series.label = sampler;
    return series;
}

void MadeUpReport::set_radius(ReportSeries& series, double radius)
{
    stored_of(series).relative_radius = Statistic{radius, radius, radius, {}};
}

void MadeUpReport::set_radii(ReportSeries& series, const std::vector<double>& radii)
{
    stored_of(series).relative_radius = poissonlab::statistic_of(radii);
}

void MadeUpReport::set_curve(ReportSeries& series, const MadeUpCurve& curve)
{
    const int dimension = series.run->dimension;
    const double principal = 1 / (0.75 * max_min_distance(series.stored->points, dimension));
    series.curve.principal_frequency = principal;
    series.curve.background_db = -10;
    series.curve.dimension = dimension;
    const double rise = curve.width * principal;
    for (int k = 1; k < 2.5 * principal; ++k) {
        const double f = k, share = std::clamp((f - principal) / rise + 0.5, 0.0, 1.0);
        const double top = f > 1.3 * principal ? curve.beyond : curve.peak;
        RadialBin bin;
        bin.frequency = f;
        bin.power = curve.low + share * (top - curve.low);
        bin.power_error = curve.error;
        bin.samples = static_cast<std::size_t>(2 * std::numbers::pi * f);
        bin.anisotropy_db =
            -10 + curve.anisotropy + (k == 40 ? curve.spike : 0) + (k % 2 == 0 ? curve.scatter : -curve.scatter);
        series.curve.bins.push_back(bin);
    }
}

void MadeUpReport::set_peaks(ReportSeries& series, int tiles, double mean_ratio)
{
    stored_of(series).measures.lattice_peaks =
        LatticePeaks{tiles, 10 * mean_ratio, mean_ratio, {}, 1000, mean_ratio / 20};
}

void MadeUpReport::set_iterations(ReportSeries& series, std::vector<double> mean_radius, double scatter)
{
    Iterations iterations;
    series.iterations.clear();
    for (int k = 0; k < 10; ++k) {
        std::vector<IterationRecord>& realization = series.iterations.emplace_back();
        for (const double radius : mean_radius)
            realization.push_back({radius + (realization.empty() ? 0.0 : k % 2 == 0 ? scatter : -scatter), 0});
    }
    iterations.realizations.assign(mean_radius.size(), 10);
    iterations.relative_radius.mean = std::move(mean_radius);
    stored_of(series).iterations = iterations;
}

void MadeUpReport::set_plate_error(ReportSeries& series, double low, double high)
{
    ZonePlateResult plate;
    plate.size = 32; // too small for false rings, which need a picture
    stored_of(series).zone_plate = plate;
    series.zone_plate = {{1, 0.1, low, 1000}, {2, 0.4, high, 1000}};
}

ReportSeries& MadeUpReport::add_plate(const std::string& sampler, const NamedTexts& parameters, double amplitude,
                                      std::size_t points)
{
    constexpr int size = 128;
    SquareImage picture = zone_plate_reference(size);
    std::normal_distribution<double> noise(0, 0.1);
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const double x = (column + 0.5) * plate_side / size - 5, y = (row + 0.5) * plate_side / size - 7;
            picture.pixels[static_cast<std::size_t>(row * size + column)] +=
                noise(random_) + amplitude * std::sin(x * x + y * y);
        }
    ReportSeries& series = add(sampler, parameters, points);
    const std::string name = stored_of(series).name + ".exr";
    write_square_image(folder_.path() / name, picture, {});
    runs_.back().folder = folder_.path();
    ZonePlateResult plate;
    plate.size = size;
    plate.file = name;
    stored_of(series).zone_plate = plate;
    return series;
}

DistributionResult& MadeUpReport::add_scheme(const std::string& kind, const std::map<std::string, double>& numbers,
                                             std::optional<double> error)
{
    DistributionResult& scheme = schemes_.emplace_back();
    scheme.kind = kind;
    for (const auto& [key, value] : numbers) scheme.numbers.push_back({key, key, value, "", error});
    return scheme;
}

std::vector<const DistributionResult*> MadeUpReport::schemes() const
{
    std::vector<const DistributionResult*> all;
    for (const auto& scheme : schemes_) all.push_back(&scheme);
    return all;
}

std::optional<ClaimOutcome> MadeUpReport::outcome(const std::string& claim) const
{
    for (const JudgedClaim& judged : judge_claims(series(), schemes()))
        if (judged.claim->id == claim) return judged.outcome;
    return std::nullopt;
}

std::vector<const ReportSeries*> MadeUpReport::series() const
{
    std::vector<const ReportSeries*> all;
    for (const auto& entry : series_) all.push_back(&entry);
    return all;
}

}
