#include "experiment/config/analysis_options.hpp"

#include "experiment/config/overrides.hpp"
#include "host/settings/config_values.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

/// 512^3 frequencies take some 7 GiB while they are made.
constexpr int most_frequencies_2d = 8192;
constexpr int most_frequencies_3d = 512;
constexpr int most_tiles = 4096;

int read_spectrum_size(const ConfigTable& table, int dimension)
{
    const int most = dimension == 2 ? most_frequencies_2d : most_frequencies_3d;
    const auto size = static_cast<int>(read_integer(table, "spectrum_size", 4, most, 0));
    if (size % 2 != 0) throw invalid_node("spectrum_size", *find(table, "spectrum_size"), "must be even");
    return size;
}

/// The way to compute periodograms; std::nullopt if there are none, and then keys about them are refused.
std::optional<PeriodogramMethod> read_periodogram_method(const ConfigTable& table)
{
    switch (read_word(table, "spectrum", {"fast", "exact", "none"})) {
    case 0:
        return PeriodogramMethod::fast;
    case 1:
        return PeriodogramMethod::exact;
    default:
        break;
    }
    for (const char* key : {"spectrum_size", "bin_width", "volume", "tiles"})
        if (const ConfigNode* node = find(table, key))
            throw invalid_node(key, *node, "does not go with spectrum = \"none\"; leave it out");
    return std::nullopt;
}

/// A flag that only means something in one dimension.
bool read_flag_for(const ConfigTable& table, const std::string& key, int dimension, int needed, const char* why)
{
    const bool flag = read_flag(table, key, false);
    if (flag && dimension != needed)
        throw invalid_node(key, *find(table, key), fmt::format("needs dimension = {}: {}", needed, why));
    return flag;
}

/// The table [analysis] of `--set` arguments over these entries.
ConfigTable overridden_table(const std::vector<std::string>& overrides, const ConfigTable& entries)
{
    ConfigTable top{{"analysis", {entries, {}, {}}}};
    apply_overrides(top, overrides);
    check_keys(top, {"analysis"});
    const ConfigNode* analysis = find(top, "analysis");
    const auto* table = analysis->get_if<ConfigTable>();
    if (!table) throw invalid_node("analysis", *analysis, "must be a table: --set analysis.KEY=VALUE");
    check_keys(*table, analysis_option_keys());
    return *table;
}

}

const std::vector<std::string>& analysis_option_keys()
{
    static const std::vector<std::string> keys = {
        "spectrum", "spectrum_size", "bin_width", "volume", "zone_plate", "tiles",        "window",
        "measures", "point_files",   "region",    "planar", "density",    "density_from", "envelope"};
    return keys;
}

AnalysisOptions read_analysis_options(const ConfigTable& analysis, int dimension)
{
    AnalysisOptions options;
    options.spectrum = read_periodogram_method(analysis);
    options.spectrum_size = read_spectrum_size(analysis, dimension);
    options.bin_width = read_number(analysis, "bin_width", 1, 100, options.bin_width);
    options.volume = read_flag_for(analysis, "volume", dimension, 3, "spectra of 2D sets are stored whole");
    options.zone_plate =
        read_flag_for(analysis, "zone_plate", dimension, 2, "the zone plate is a function of the plane");
    options.tiles = static_cast<int>(read_integer(analysis, "tiles", 2, most_tiles, 0));
    options.window = read_flag(analysis, "window", false);
    options.distances_only = read_word(analysis, "measures", {"all", "distances"}) == 1;
    options.first_points_only = read_word(analysis, "point_files", {"all", "first"}) == 1;
    options.region = read_region_options(analysis, dimension);
    if (options.region && options.spectrum_size > largest_region_spectrum)
        throw invalid_node("spectrum_size", *find(analysis, "spectrum_size"),
                           fmt::format("must be at most {} for sets in a region", largest_region_spectrum));
    return options;
}

AnalysisOptions overridden_analysis(const std::vector<std::string>& overrides, int dimension,
                                    const ConfigTable& entries)
{
    return read_analysis_options(overridden_table(overrides, entries), dimension);
}

std::optional<RegionOptions> overridden_region(const std::vector<std::string>& overrides, const ConfigTable& entries)
{
    return read_region_options(overridden_table(overrides, entries), 2);
}

}
