#include "tests/reports/support/synthetic_results.hpp"

#include "analysis/measures/distance_statistics.hpp"
#include "analysis/spectra/radial_statistics.hpp"
#include "analysis/spectra/spectrum.hpp"
#include "analysis/spectra/spectrum_file.hpp"
#include "base/files/whole_file.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/points/point_file.hpp"
#include "tests/support/point_patterns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace poissonlab::test {

namespace {

constexpr int side = 16;
constexpr int spectrum_samples = 64;

PointSet jittered_points(std::mt19937_64& random)
{
    auto points = square_lattice(side, 2);
    for (double& x : points.coordinates) x += 0.6 * uniform(random) / side;
    return points;
}

nlohmann::json statistic(const std::vector<double>& each)
{
    const auto [low, high] = std::ranges::minmax(each);
    const double mean = std::accumulate(each.begin(), each.end(), 0.0) / static_cast<double>(each.size());
    return {{"min", low}, {"mean", mean}, {"max", high}, {"each", each}};
}

void write_radial_table(const std::filesystem::path& file, const Spectrum& spectrum)
{
    std::string csv = "frequency,power,anisotropy_db,samples,power_error\n";
    for (const auto& bin : radial_statistics(spectrum))
        csv +=
            fmt::format("{},{},{},{},{}\n", bin.frequency, bin.power, bin.anisotropy_db, bin.samples, bin.power_error);
    write_whole_file(file, csv);
}

// Writes the files of one series and returns its member of results.json.
nlohmann::json write_series(const std::filesystem::path& folder, const std::string& name, const std::string& label,
                            const std::vector<PointSet>& sets)
{
    std::filesystem::create_directories(folder / name);
    SpectrumEstimate estimate(2, spectrum_samples);
    std::vector<double> distance;
    std::vector<double> radius;
    std::vector<double> covered;
    std::vector<std::string> files;
    for (const auto& set : sets) {
        files.push_back(fmt::format("{}/realization-{:03}.dat", name, files.size()));
        write_points(folder / files.back(), set);
        estimate.add(set);
        distance.push_back(min_toroidal_distance(set));
        radius.push_back(relative_radius(distance.back(), set.size(), 2));
        covered.push_back(covered_fraction(distance.back(), set.size(), 2));
    }
    const auto spectrum = estimate.mean();
    write_spectrum(folder / name / "spectrum.exr", spectrum, {});
    write_radial_table(folder / name / "radial.csv", spectrum);

    const auto count = static_cast<int>(sets.size());
    return {{"name", name},
            {"label", label},
            {"sampler", name},
            {"parameters", {{"strength", 0.6}, {"note", "a<b"}}},
            {"deterministic", count == 1},
            {"points", sets.front().size()},
            {"realizations", count},
            {"min_distance", statistic(distance)},
            {"relative_radius", statistic(radius)},
            {"covered_fraction", statistic(covered)},
            {"spectrum",
             {{"kind", count > 1 ? "power spectrum estimate" : "periodogram"},
              {"size", spectrum_samples},
              {"file", name + "/spectrum.exr"}}},
            {"radial", {{"file", name + "/radial.csv"}, {"background_anisotropy_db", background_anisotropy_db(count)}}},
            {"point_files", files},
            {"timing",
             {{"sample_seconds", std::vector<double>(sets.size(), 0.0123)},
              {"build_seconds", 0.5},
              {"analysis_seconds", 0.1}}}};
}

}

nlohmann::json write_synthetic_results(const std::filesystem::path& folder)
{
    std::mt19937_64 random(1);
    const auto series = {
        write_series(folder, "random", "Random <b>bold</b> & \"quoted\"",
                     {random_points(side * side, 2, random), random_points(side * side, 2, random)}),
        write_series(folder, "jittered", "Jittered, it's fine", {jittered_points(random), jittered_points(random)}),
        write_series(folder, "regular", "Regular grid", {square_lattice(side, 2)})};
    nlohmann::json results = {{"format", "poissonlab-results"},
                              {"format_version", 1},
                              {"version", "0.1.0 (test)"},
                              {"title", "Grids <script>alert(1)</script> & co"},
                              {"command", "poissonlab run grids.toml --set 'a=<1>'"},
                              {"config", "title = \"<i>&amp;</i>\"\n{{braces}}\n"},
                              {"overrides", {"seed=7"}},
                              {"seed", 18446744073709551615U},
                              {"engine", "reference"},
                              {"dimension", 2},
                              {"realizations", 2},
                              {"machine", {{"device", "Test <device>"}, {"driver", "1.2"}, {"threads", 2}}},
                              {"series", series}};
    write_results_json(folder, results);
    return results;
}

void write_results_json(const std::filesystem::path& folder, const nlohmann::json& results)
{
    write_whole_file(folder / "results.json", results.dump(1));
}

}
