#include "reports/stored_collection.hpp"

#include "io/whole_file.hpp"
#include "reports/stored_object.hpp"

#include <nlohmann/json.hpp>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

constexpr int supported_format_version = 1;

nlohmann::json parse(const fs::path& file)
{
    try {
        return nlohmann::json::parse(read_whole_file(file));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file.string() + ": is not JSON: " + error.what());
    }
}

}

std::vector<fs::path> run_folders(const fs::path& folder)
{
    const auto file = folder / "collection.json";
    if (!fs::is_regular_file(file)) return {folder};
    const auto json = parse(file);
    const StoredObject root(json, file);
    if (!root.has("format") || root.text("format") != "poissonlab-collection")
        throw root.error("format", "must be \"poissonlab-collection\"; this file is of another kind");
    if (const auto version = root.integer("format_version", 1); version != supported_format_version)
        throw root.error("format_version", std::to_string(version) + ": this program reads version " +
                                               std::to_string(supported_format_version));
    std::vector<fs::path> folders;
    for (const auto& name : root.texts("runs")) {
        if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
            throw root.error("runs", "'" + name + "' must be the name of a folder");
        folders.push_back(folder / name);
    }
    if (folders.empty()) throw root.error("runs", "must name at least one folder");
    return folders;
}

std::vector<StoredRun> read_stored_runs(const fs::path& folder)
{
    std::vector<StoredRun> runs;
    for (const auto& run : run_folders(folder)) runs.push_back(read_stored_run(run));
    return runs;
}

}
