#include "experiment/config/collection.hpp"

#include "base/files/file_glob.hpp"
#include "base/files/whole_file.hpp"
#include "experiment/config/overrides.hpp"
#include "experiment/config/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace fs = std::filesystem;

namespace poissonlab {
namespace {

/// The paths and globs of the key `include`.
std::vector<const ConfigNode*> entries_of(const ConfigNode& include)
{
    const char* allowed = "must be a list of paths of configs, such as [\"first.toml\", \"more/*.toml\"]";
    const auto* list = include.get_if<ConfigList>();
    if (!list || list->empty()) throw invalid_node("include", include, allowed);
    std::vector<const ConfigNode*> entries;
    for (const ConfigNode& entry : *list) {
        const auto* path = entry.get_if<std::string>();
        if (!path || path->empty()) throw invalid_node("include", entry, allowed);
        entries.push_back(&entry);
    }
    return entries;
}

void check_collection_keys(const ConfigTable& top)
{
    for (const auto& [key, node] : top)
        if (key != "include" && key != "title" && key != "device")
            throw invalid_node(
                key, node, "cannot be combined with include: a collection has only the keys include, title and device");
}

/// Reads a collection and those that it includes.
class CollectionReader
{
public:
    explicit CollectionReader(const std::vector<std::string>& overrides) : overrides_(overrides) {}

    Collection read(const fs::path& file, const ConfigTable& top)
    {
        collection_.title = file.stem().string();
        Keys(top, {file.string()}, "").text("title", collection_.title, "of the report");
        add_collection(file, top, "");
        return std::move(collection_);
    }

private:
    void add_collection(const fs::path& file, const ConfigTable& top, const std::string& device)
    {
        check_collection_keys(top);
        open_.push_back(file);
        std::string own_device = device;
        Keys(top, {file.string()}, "").text("device", own_device, "of all configs");
        for (const ConfigNode* entry : entries_of(*find(top, "include"))) {
            const std::string& path = *entry->get_if<std::string>();
            const auto files = named_files(file.parent_path(), path);
            if (files.empty()) throw invalid_node("include", *entry, no_such_file(file.parent_path(), path));
            for (const fs::path& included : files) add_file(included.lexically_normal(), *entry, own_device);
        }
        open_.pop_back();
    }

    void add_file(const fs::path& file, const ConfigNode& entry, const std::string& device)
    {
        check_cycle(file, entry);
        if (!seen_.insert(fs::weakly_canonical(file)).second)
            throw invalid_node("include", entry, file.string() + " is included twice");
        if (fs::is_directory(file))
            throw invalid_node("include", entry, file.string() + " is a folder; config files (.toml) are needed");
        if (is_no_lasting_file(file))
            throw invalid_node("include", entry,
                               file.string() + " is a pipe or a device; config files (.toml) are needed");
        ParsedConfig parsed = parse_file(file);
        if (is_collection(parsed)) return add_collection(file, parsed.top, device);
        add_config(std::move(parsed), entry, device);
    }

    void check_cycle(const fs::path& file, const ConfigNode& entry) const
    {
        const fs::path canonical = fs::weakly_canonical(file);
        const auto same = [&](const fs::path& other) { return fs::weakly_canonical(other) == canonical; };
        const auto first = std::ranges::find_if(open_, same);
        if (first == open_.end()) return;
        std::string cycle;
        for (auto step = first; step != open_.end(); ++step) cycle += step->string() + " includes ";
        throw invalid_node("include", entry, "goes round in a circle: " + cycle + file.string());
    }

    void add_config(ParsedConfig parsed, const ConfigNode& entry, const std::string& device)
    {
        const std::string file = parsed.file;
        CollectedConfig collected{safe_name(fs::path(file).stem().string()), {}, {}};
        if (!names_.insert(collected.name).second)
            throw invalid_node("include", entry,
                               fmt::format("{}: another config has the same name, and with it the folder \"{}\"", file,
                                           collected.name));
        try {
            collected.config = checked_config(std::move(parsed), overrides_);
        } catch (const InputError& error) {
            // Overrides have no place of their own that would say which config they do not suit.
            if (!error.place().is_argument) throw;
            throw InputError::at({file}, error.what());
        }
        collected.device = collected.config.device.empty() ? device : collected.config.device;
        collection_.configs.push_back(std::move(collected));
    }

    const std::vector<std::string>& overrides_;
    Collection collection_;
    std::vector<fs::path> open_;  ///< collections that are being read, the outermost first
    std::set<fs::path> seen_;     ///< canonical paths of all files that were included
    std::set<std::string> names_; ///< folders
};

}

bool is_collection(const ParsedConfig& config) { return find(config.top, "include") != nullptr; }

Collection read_collection(const ParsedConfig& config, const std::vector<std::string>& overrides)
{
    check_collection_overrides(overrides);
    return CollectionReader(overrides).read(config.file, config.top);
}
}
