// Keys that several kinds of distributions have in common.
#pragma once

#include "host/config/config_tree.hpp"
#include "host/config/distributions/distribution_config.hpp"

namespace poissonlab {

/// `density` and `density_from`. Throws InputError where a density cannot be made of them.
DensityChoice read_density_choice(const ConfigTable& table, const SourceLocation& where);

/// `points`, which must be there.
std::size_t read_distributed_points(const ConfigTable& table, const SourceLocation& where);

/// `tiles` or `method`.
EvenMethodChoice read_even_method_choice(const ConfigTable& table);

/// A number in a list or of its own, from `low` to `high`. `others`: what else the key may have, for the message.
double read_listed_number(const std::string& key, const ConfigNode& node, double low, double high,
                          const std::string& others = "");

/// A number of each object: a number, { uniform = [a, b] } or { normal = [mean, deviation] }.
SpreadChoice read_spread(const ConfigTable& table, const std::string& key, double low, double high,
                         const SpreadChoice& otherwise);

/// The InputError for a key that is missing.
InputError missing_key(const SourceLocation& where, const std::string& key);

/// Adds the file to the inputs of a config, where the text names one.
void add_input(DistributionConfig& config, const std::string& text);

}
