// A result folder whose numbers are drawn at random around known means: what two runs of a sampler look like.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace poissonlab::test {

/// The truth about a made-up series, and how realizations scatter about it.
struct MadeUpSeries
{
    std::string name = "darts";
    std::string sampler = "dart-throwing";
    double relative_radius = 0.70;   ///< mean; scatters by 1 %
    double power = 1;                ///< factor of the radial power; each bin scatters by 10 %
    double effective_nyquist = 0.65; ///< scatters by 0.01 between runs, which the stored error says
    bool deterministic = false;
    int realizations = 10;
    std::vector<double> seconds = {0.010, 0.011, 0.012, 0.011, 0.010};
};

struct MadeUpRun
{
    std::uint64_t seed = 1; ///< of the numbers as well
    std::string version = "0.1.0 (test)";
    std::string device = "Test device";
    int threads = 2;
    std::vector<MadeUpSeries> series = {{}};
};

/// Writes results.json, the tables of curves and a point file for each series; returns results.json.
nlohmann::json write_made_up_run(const std::filesystem::path& folder, const MadeUpRun& run);

/// Writes collection.json over these folders of `folder`.
void write_made_up_collection(const std::filesystem::path& folder, const std::vector<std::string>& runs);

}
