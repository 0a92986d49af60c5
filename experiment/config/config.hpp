// The config: what an experiment is asked to do, checked. docs and configs/quick.toml show every key.
//
// The samplers that a [[method]] table can name, and the keys that each of these tables can have.
#pragma once

#include "experiment/config/analysis_options.hpp"
#include "host/settings/config_tree.hpp"
#include "host/settings/sampler_registry.hpp"
#include "host/settings/sampler_table.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The largest number of realizations of a series.
inline constexpr std::int64_t max_realizations = 10000;

/// The largest number of runs for the sake of times.
inline constexpr std::int64_t max_timing_runs = 1000;

struct MethodConfig
{
    const SamplerSpec* sampler = nullptr;
    std::string label; ///< empty: made from the sampler's title
    SourceLocation where;
    std::optional<RegionOptions> region; ///< its own, or that of [analysis]; nothing: its sets fill the unit square
    bool has_own_region = false;
    std::vector<ParameterSetting>
        settings; ///< `points` first, then as the sampler declares its parameters, then `order`
};

/// A table of a kind of work, which host/kinds reads.
struct KindTable
{
    std::string name; ///< one of kind_tables()
    ConfigNode node;
};

/// The names of such tables, in the order in which results are listed.
const std::vector<std::string>& kind_tables();

struct Config
{
    std::string file;                   ///< as the user named it
    std::string text;                   ///< its content
    std::vector<std::string> overrides; ///< --set arguments, applied

    std::string title;      ///< default: the file's stem
    std::uint64_t seed = 1; ///< TOML integers are signed: 0 to 2^63 - 1
    Engine engine = Engine::opencl;
    std::string device; ///< part of a device's name, or its number; empty: the default device
    std::size_t points = 16384;
    int realizations = 10;
    int timing_runs = 5; ///< the least number of times that each series is timed
    int dimension = 2;
    AnalysisOptions analysis;
    std::vector<MethodConfig> methods;
    std::vector<KindTable> tables; ///< at least one, or one method
};

/// A config's text and the tables in it, not checked yet.
struct ParsedConfig
{
    std::string file; ///< as messages name it
    std::string text;
    ConfigTable top;
};

/// Parses a config. Throws InputError for what is no TOML, and for files that cannot be read.
ParsedConfig parse_file(const std::filesystem::path& file);

/// Checks a config. Throws InputError, `file:line: key = value: what is allowed`. The samplers of the `registry` must
/// outlive the result.
Config checked_config(ParsedConfig parsed, const std::vector<std::string>& overrides = {},
                      const SamplerRegistry& registry = sampler_registry());

/// Parses and checks a config.
Config read_config(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Parses and checks the text of a config; messages name it `file`.
Config parse_config(const std::string& text, const std::string& file, const std::vector<std::string>& overrides = {},
                    const SamplerRegistry& registry = sampler_registry());

/// The keys of a [[method]] beside its sampler's parameters.
const std::vector<std::string>& method_keys();

/// True if [analysis] of a config, or one of its methods, has a region.
bool analysis_has_region(const ConfigTable& config);
bool some_method_has_region(const ConfigTable& config);

/// The samplers of a method: those in regions where the method or [analysis] has one, else those of `torus`.
const SamplerRegistry& registry_of(const ConfigTable& method, bool analysis_has_region, const SamplerRegistry& torus);

}
