// A collection: a config whose key `include` names other configs, which are run one after the other under one report.
#pragma once

#include "experiment/config/config.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// One config of a collection.
struct CollectedConfig
{
    std::string name;   ///< of its folder, unique: the stem of its file
    std::string device; ///< its own, else that of the collection that includes it
    Config config;
};

struct Collection
{
    std::string title;                    ///< default: the file's stem
    std::vector<CollectedConfig> configs; ///< those of included collections in the place of these
};

/// True where a config names others.
bool is_collection(const ParsedConfig& config);

/// Checks a collection and all that it includes, by paths and globs relative to its folder. Overrides apply to each
/// config. Throws InputError: keys beside `include`, `title` and `device`; files that are not there or are included
/// twice; cycles; overrides of a method by its number; and whatever checked_config() throws.
Collection read_collection(const ParsedConfig& config, const std::vector<std::string>& overrides = {});
}
