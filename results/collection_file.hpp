// collection.json: a folder that holds several output folders, the runs of a collection.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

struct CollectionFile
{
    std::string title;
    std::string command;           ///< as it would be typed
    std::vector<std::string> runs; ///< folders beside the file, in the order of the report
};

/// Writes folder/collection.json. Throws StorageError.
void write_collection_file(const std::filesystem::path& folder, const CollectionFile& collection);

/// Reads it; nothing where the folder has none. Throws InputError for files of another kind.
std::optional<CollectionFile> read_collection_file(const std::filesystem::path& folder);

/// The output folders that a folder stands for: itself, or the runs of the collection that it holds. Throws InputError.
std::vector<std::filesystem::path> output_folders(const std::filesystem::path& folder);

/// The output folders of several folders, in their order.
std::vector<std::filesystem::path> output_folders(const std::vector<std::filesystem::path>& folders);

}
