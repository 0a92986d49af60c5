// Finished units of work on disk: what a run that was interrupted, and every later one, need not do again.
//
// Files and no database: results are hard links to them, and machines share the folder, where SQLite is not safe.
//
// The values on which a unit of work depends, and the name that follows from them.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace poissonlab {

/// Lines "name = value": everything that decides the outcome of a unit of work, the version of the code included, and
/// nothing else. Units with equal keys are the same.
class UnitKey
{
public:
    /// `kind` is the first line, for example "realization".
    explicit UnitKey(std::string_view kind);

    /// Appends a line. Line breaks in values are escaped, so that different values stay different.
    UnitKey& add(std::string_view name, std::string_view value);
    UnitKey& add(std::string_view name, std::integral auto value)
    {
        if constexpr (std::is_same_v<decltype(value), bool>)
            return add(name, std::string_view(value ? "yes" : "no"));
        else
            return add(name, std::string_view(std::to_string(value)));
    }

    /// Appends all lines of another key.
    UnitKey& add(const UnitKey& other);

    const std::string& text() const { return text_; }

    /// 32 hexadecimal digits: two XXH64 hashes of the text with different seeds.
    std::string name() const;

private:
    std::string text_;
};

/// The folder of units in an output folder.
inline constexpr const char* unit_folder_name = ".units";

/// A unit as it was stored.
struct StoredUnit
{
    std::string record;                                 ///< bytes whose meaning its kind decides
    std::map<std::string, std::filesystem::path> files; ///< by the names that they were stored under
};

/// A folder of units. Each has a manifest with its key, a record, and the sizes and checksums (XXH64) of its files,
/// which is written last: a unit is there whole or not at all, whatever ended the process that wrote it. Several
/// processes, on several machines, may read and write one folder at the same time: equal keys mean equal contents, so
/// that it does not matter who comes last. All members may be called by several threads.
class UnitStore
{
public:
    /// The store creates nothing before the first unit is stored.
    explicit UnitStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    const std::filesystem::path& folder() const { return folder_; }

    /// The unit, where it is there and every checksum is right; what is damaged counts as missing. What this process
    /// has checked before is not read again while its manifest stays the same file. Another process may remove a unit
    /// at any time: files that were found may be gone when they are read.
    std::optional<StoredUnit> find(const UnitKey& key) const;

    /// The path to which a unit's file must be written, by a function of base/files/whole_file, before the unit is
    /// stored. Creates the folder; throws StorageError.
    std::filesystem::path file(const UnitKey& key, std::string_view name) const;

    /// Stores a unit with its record and the files, by name, that were written before. Throws StorageError.
    void store(const UnitKey& key, std::string_view record, const std::vector<std::string>& files = {});

    /// Forgets a unit and removes its files.
    void remove(const UnitKey& key);

    /// Copies all sound units of another store, those that are here apart, and returns how many. Damaged ones are left
    /// out. `progress` is told of each unit. Throws StorageError.
    template <class Progress>
    std::size_t merge(const UnitStore& other, const Progress& progress)
    {
        std::size_t count = 0;
        for (const std::filesystem::path& manifest : other.manifests()) {
            if (copy_unit(manifest)) progress(++count);
        }
        return count;
    }

private:
    /// A manifest, as far as the file system tells one from another without reading it.
    struct Stamp
    {
        std::uint64_t device = 0;
        std::uint64_t inode = 0;
        std::int64_t seconds = 0; ///< of the last change
        std::int64_t nanoseconds = 0;

        bool operator==(const Stamp&) const = default;
    };
    struct Known
    {
        Stamp stamp;
        StoredUnit unit;
    };

    static std::optional<Stamp> stamp_of(const std::filesystem::path& manifest);
    std::filesystem::path base_of(const std::string& name) const;
    std::vector<std::filesystem::path> manifests() const;
    bool copy_unit(const std::filesystem::path& manifest);

    std::filesystem::path folder_;
    mutable std::mutex mutex_;
    mutable std::map<std::string, Known> known_; ///< by a key's text
};

}
