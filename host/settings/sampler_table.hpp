// A table that names a sampler and gives its parameters: a [[method]], or the value of a parameter such as
// `start = { sampler = "dart-throwing", relative_radius = [0.6, 0.7] }`.
#pragma once

#include "host/sampling/sampler.hpp"
#include "host/settings/config_tree.hpp"
#include "host/settings/parameter_values.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The largest number of points of a set, and of series of an experiment.
inline constexpr std::int64_t max_points = std::int64_t{1} << 27;
inline constexpr std::size_t max_series = 1000;

/// The greatest depth to which samplers may lie in one another: a [[method]], its start, the start of that ...
inline constexpr int max_sampler_depth = 5;

/// A key of such a table, with every value that it takes.
struct ParameterSetting
{
    const ParameterSpec* parameter = nullptr;
    std::vector<ParameterChoice> choices; ///< at least one; several make one series each
};

/// The key `points` of every [[method]]: the number of points where it is not that of the experiment.
const ParameterSpec& points_parameter();

/// The key `order` of every [[method]]: "own", the order in which the method makes its points, or "sample-elimination".
const ParameterSpec& order_parameter();

/// True where the parameters ask for another order than the method's own.
bool is_ordered(const Parameters& parameters);

/// One choice of each setting, in the settings' order.
using Combination = std::vector<const ParameterChoice*>;

/// Every combination of choices; the last setting varies fastest. `where` and `what` name the table in the
/// InputError for more than max_series.
std::vector<Combination> combinations(const std::vector<ParameterSetting>& settings, const SourceLocation& where,
                                      const std::string& what);

/// The sampler that the key `sampler` of a table names. Throws InputError when there is none.
const SamplerSpec& read_sampler(const ConfigTable& table, const SourceLocation& where, const std::string& what,
                                const SamplerRegistry& registry);

/// The parameters of a sampler that a table gives, in the order in which the sampler declares them. `others`
/// are keys of the table that are none; anything else is an unknown key.
std::vector<ParameterSetting> read_settings(const ConfigTable& table, const SamplerSpec& sampler,
                                            const std::vector<std::string>& others, const SamplerRegistry& registry,
                                            int depth);

/// The values that a table, or a sampler's name alone, gives a parameter whose value is a sampler: one for
/// each combination of the lists in the table. What `check` would refuse is not seen here.
std::vector<ParameterChoice> sampler_choices(const ParameterSpec& spec, const ConfigNode& node,
                                             const SamplerRegistry& registry, int depth);

/// The chosen values as parameters of the sampler, with its defaults for the others; `points` is none.
Parameters chosen_parameters(const SamplerSpec& sampler, const std::vector<ParameterSetting>& settings,
                             const Combination& chosen);

/// The short form of a parameter for names and labels, for example "rho".
std::string symbol_of(const ParameterSpec& spec);

/// A name for a folder, such as "dart-throwing-rho-0.70" or "lloyd-i-16-dart-throwing-rho-0.70-repulsion".
std::string name_of(const SamplerSpec& sampler, const std::vector<ParameterSetting>& settings,
                    const Combination& chosen);

/// The values in the words of a label: "rho = 0.70", "start = Dart throwing (rho = 0.70), repulsion".
/// `only_varying`: only those that differ between series.
std::string values_text(const std::vector<ParameterSetting>& settings, const Combination& chosen,
                        bool only_varying = false);

}
