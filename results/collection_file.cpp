#include "results/collection_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/json_file.hpp"
#include "base/files/whole_file.hpp"
#include "results/file_names.hpp"

#include <nlohmann/json.hpp>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* collection_format = "poissonlab-collection";
constexpr int collection_format_version = 1;

[[noreturn]] void fail(const fs::path& file, const std::string& member, const std::string& problem)
{
    throw InputError(file.string() + ": " + member + ": " + problem);
}

std::string text_at(const nlohmann::json& json, const fs::path& file, const std::string& member)
{
    const auto found = json.find(member);
    if (found == json.end() || !found->is_string()) fail(file, member, "must be a text in quotes");
    return found->get<std::string>();
}

/// The member "runs": names of folders beside the file, at least one.
std::vector<std::string> runs_of(const nlohmann::json& json, const fs::path& file)
{
    const auto found = json.find("runs");
    if (found == json.end() || !found->is_array()) fail(file, "runs", "must be a list of names of folders");
    if (found->empty()) fail(file, "runs", "must name at least one folder");
    std::vector<std::string> runs;
    for (const auto& run : *found) {
        const std::string name = run.is_string() ? run.get<std::string>() : "";
        if (name.empty() || name.front() == '.' || name.find('/') != std::string::npos || printable(name) != name)
            fail(file, "runs", shortened(run.dump()) + " must be the name of a folder beside the file");
        runs.push_back(name);
    }
    return runs;
}

}

void write_collection_file(const fs::path& folder, const CollectionFile& collection)
{
    const Json json = {{"format", collection_format},
                       {"format_version", collection_format_version},
                       {"title", collection.title},
                       {"command", collection.command},
                       {"runs", collection.runs}};
    // Arguments can hold any bytes; JSON is UTF-8.
    write_whole_file(folder / file_names::collection, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<CollectionFile> read_collection_file(const fs::path& folder)
{
    const fs::path file = folder / file_names::collection;
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    const nlohmann::json json = read_json_file(file);
    if (!json.is_object() || json.value("format", nlohmann::json()) != collection_format)
        fail(file, "format", std::string("must be \"") + collection_format + "\"; this file is of another kind");
    if (json.value("format_version", nlohmann::json()) != collection_format_version)
        fail(file, "format_version", "this program reads version " + std::to_string(collection_format_version));
    return CollectionFile{text_at(json, file, "title"), text_at(json, file, "command"), runs_of(json, file)};
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
