// A collection: several runs in one folder, with a collection.json that lists them (docs/output-folder.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct StoredCollection
{
    std::string title;
    std::vector<std::filesystem::path> folders; ///< of its runs, in order
};

/// What folder/collection.json says; nothing where there is none. Throws InputError that names the file and the member.
std::optional<StoredCollection> read_stored_collection(const std::filesystem::path& folder);

/// The folders with those of collections in their place.
std::vector<std::filesystem::path> folders_of_runs(const std::vector<std::filesystem::path>& folders);

/// The title of the collection, where there is one and nothing else; else empty.
std::string title_of_collection(const std::vector<std::filesystem::path>& folders);

}
