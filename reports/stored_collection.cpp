#include "reports/stored_collection.hpp"

#include "io/whole_file.hpp"
#include "reports/stored_object.hpp"

#include <nlohmann/json.hpp>

namespace poissonlab {

namespace fs = std::filesystem;

namespace {

nlohmann::json parse(const fs::path& file)
{
    try {
        return nlohmann::json::parse(read_whole_file(file));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file.string() + ": is not JSON: " + error.what());
    }
}

}

std::optional<StoredCollection> read_stored_collection(const fs::path& folder)
{
    const auto file = folder / "collection.json";
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    const auto json = parse(file);
    const StoredObject root(json, file);
    if (!root.has("format") || root.text("format") != "poissonlab-collection")
        throw root.error("format", "must be \"poissonlab-collection\"; this file is of another kind");
    if (const auto version = root.integer("format_version", 1); version != 1)
        throw root.error("format_version", std::to_string(version) + ": this program reads version 1");
    StoredCollection collection{root.text("title"), {}};
    for (const auto& name : root.texts("runs")) {
        if (name.empty() || name.find('/') != std::string::npos || name.starts_with('.'))
            throw root.error("runs", "'" + name + "' must be the name of a folder in here");
        collection.folders.push_back(folder / name);
    }
    if (collection.folders.empty()) throw root.error("runs", "must name at least one folder");
    return collection;
}

std::vector<fs::path> folders_of_runs(const std::vector<fs::path>& folders)
{
    std::vector<fs::path> result;
    for (const auto& folder : folders) {
        if (const auto collection = read_stored_collection(folder))
            result.insert(result.end(), collection->folders.begin(), collection->folders.end());
        else
            result.push_back(folder);
    }
    return result;
}

std::string title_of_collection(const std::vector<fs::path>& folders)
{
    if (folders.size() != 1) return {};
    const auto collection = read_stored_collection(folders.front());
    return collection ? collection->title : std::string();
}

}
