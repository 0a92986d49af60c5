// A collection: a config whose key `include` names other configs, which are run one after the other under one report.
#pragma once

#include "experiment/config/config.hpp"

#include <filesystem>
#include <optional>
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

/// Reads and checks a config and all that it includes, by paths and globs relative to its folder; nothing where it has
/// no key `include`. Overrides apply to each config. Throws InputError: keys beside `include`, `title` and `device`;
/// files that are not there or are included twice; cycles; overrides of a method by its number; and whatever
/// read_config() throws.
std::optional<Collection> read_collection(const std::filesystem::path& file,
                                          const std::vector<std::string>& overrides = {});

}
