#include "io/collection_file.hpp"

#include "errors/errors.hpp"
#include "io/whole_file.hpp"

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "poissonlab-collection";
constexpr int format_version = 1;

/// Throws InputError for a name that is not one of a folder beside the file.
void check_run(const fs::path& file, const std::string& run)
{
    if (run.empty() || run.front() == '.' || fs::path(run).filename() != run)
        throw InputError(file.string() + ": runs: \"" + run + "\" must be the name of a folder beside the file");
}

}

void write_collection_file(const fs::path& folder, const CollectionFile& collection)
{
    const Json json = {{"format", format_name},
                       {"format_version", format_version},
                       {"title", collection.title},
                       {"command", collection.command},
                       {"runs", collection.runs}};
    // Arguments can hold any bytes; JSON is UTF-8.
    write_whole_file(folder / collection_file_name, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<CollectionFile> read_collection_file(const fs::path& folder)
{
    const fs::path file = folder / collection_file_name;
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    try {
        const Json json = Json::parse(read_whole_file(file));
        if (json.at("format") != format_name)
            throw InputError(file.string() + ": format: must be \"" + format_name + "\"; this file is of another kind");
        if (json.at("format_version") != format_version)
            throw InputError(file.string() + ": format_version: this program reads version " +
                             std::to_string(format_version));
        CollectionFile collection{json.at("title"), json.at("command"), json.at("runs")};
        if (collection.runs.empty()) throw InputError(file.string() + ": runs: must name at least one folder");
        for (const std::string& run : collection.runs) check_run(file, run);
        return collection;
    } catch (const nlohmann::json::exception& problem) {
        throw InputError(file.string() + ": is not a collection: " + problem.what());
    }
}

std::vector<fs::path> output_folders(const fs::path& folder)
{
    const auto collection = read_collection_file(folder);
    if (!collection) return {folder};
    std::vector<fs::path> folders;
    for (const std::string& run : collection->runs) folders.push_back(folder / run);
    return folders;
}

std::vector<fs::path> output_folders(const std::vector<fs::path>& folders)
{
    std::vector<fs::path> all;
    for (const fs::path& folder : folders)
        for (fs::path& run : output_folders(folder)) all.push_back(std::move(run));
    return all;
}

}
