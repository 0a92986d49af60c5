#include "experiment/store/unit_store.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

#include <charconv>
#include <system_error>

#include <dirent.h>
#include <sys/stat.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view format_line = "poissonlab-unit 1\n";
constexpr std::string_view manifest_extension = ".unit";

/// A file of a unit, as its manifest has it.
struct FileEntry
{
    std::string name;
    std::uint64_t bytes = 0;
    std::uint64_t hash = 0;
};

struct Manifest
{
    std::string key;
    std::string record;
    std::vector<FileEntry> files;
};

std::string hash_line(std::string_view text) { return fmt::format("xxh64 {:016x}\n", xxh64_bytes(text)); }

/// Text with lengths before everything that is not ours, the record as it is, and a checksum of it all at the end.
std::string manifest_text(const Manifest& manifest)
{
    std::string text(format_line);
    text += fmt::format("key {}\n{}", manifest.key.size(), manifest.key);
    text += fmt::format("files {}\n", manifest.files.size());
    for (const FileEntry& file : manifest.files)
        text += fmt::format("{} {} {:016x}\n", file.name, file.bytes, file.hash);
    text += fmt::format("record {}\n{}\n", manifest.record.size(), manifest.record);
    return text + hash_line(text);
}

/// Reads what manifest_text() wrote; the checksum has shown that this is all there.
class ManifestReader
{
public:
    explicit ManifestReader(std::string_view text) : rest_(text) {}

    std::string_view word(char end)
    {
        const std::size_t length = rest_.find(end);
        const std::string_view result = rest_.substr(0, length);
        rest_.remove_prefix(length == std::string_view::npos ? rest_.size() : length + 1);
        return result;
    }
    std::uint64_t number(char end, int base = 10)
    {
        const std::string_view digits = word(end);
        std::uint64_t value = 0;
        std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
        return value;
    }
    std::string bytes(std::uint64_t count)
    {
        const std::string result(rest_.substr(0, count));
        rest_.remove_prefix(result.size());
        return result;
    }

private:
    std::string_view rest_;
};

std::optional<std::string> content_if_readable(const fs::path& file)
{
    try {
        return read_whole_file(file);
    } catch (const InputError&) {
        return std::nullopt;
    }
}

std::optional<Manifest> read_manifest(const fs::path& file)
{
    const auto content = content_if_readable(file);
    const std::size_t tail = hash_line({}).size();
    if (!content || content->size() < format_line.size() + tail || !content->starts_with(format_line)) return {};
    const std::string_view text = std::string_view(*content).substr(0, content->size() - tail);
    if (!content->ends_with(hash_line(text))) return {};

    ManifestReader reader(text.substr(format_line.size()));
    Manifest manifest;
    reader.word(' ');
    manifest.key = reader.bytes(reader.number('\n'));
    reader.word(' ');
    const std::uint64_t files = reader.number('\n');
    for (std::uint64_t i = 0; i < files; ++i) {
        FileEntry entry;
        entry.name = reader.word(' ');
        entry.bytes = reader.number(' ');
        entry.hash = reader.number('\n', 16);
        // Not even a checksum that is right makes a manifest ours: files lie beside it, and end with it.
        if (entry.name.empty() || entry.name.find('/') != std::string::npos) return {};
        manifest.files.push_back(std::move(entry));
    }
    reader.word(' ');
    manifest.record = reader.bytes(reader.number('\n'));
    return manifest;
}

fs::path with_ending(const fs::path& base, std::string_view ending) { return base.string() + std::string(ending); }

/// The file of a unit that `base` starts the name of.
fs::path data_file(const fs::path& base, std::string_view name) { return with_ending(base, "." + std::string(name)); }

/// The unit of a manifest whose files are all as it says.
std::optional<StoredUnit> checked_unit(Manifest manifest, const fs::path& base)
{
    StoredUnit unit;
    for (const FileEntry& entry : manifest.files) {
        const fs::path file = data_file(base, entry.name);
        std::error_code error;
        if (fs::file_size(file, error) != entry.bytes || error) return {};
        const auto content = content_if_readable(file);
        if (!content || xxh64_bytes(*content) != entry.hash) return {};
        unit.files.emplace(entry.name, file);
    }
    unit.record = std::move(manifest.record);
    return unit;
}

/// A misfortune of machines that share the store: a network file system (NFS) remembers for long that a file was not
/// there. Opening its folder makes it ask the server whether the folder has changed.
void ask_server_about(const fs::path& folder)
{
    if (DIR* const opened = ::opendir(folder.c_str())) ::closedir(opened);
}

void create_folder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw StorageError(fmt::format("cannot create the folder {}: {}", folder.string(), error.message()));
}

}

UnitKey::UnitKey(std::string_view kind) { add("unit", kind); }

UnitKey& UnitKey::add(std::string_view name, std::string_view value)
{
    text_.append(name).append(" = ");
    for (const char c : value) {
        if (c == '\n')
            text_ += "\\n";
        else if (c == '\\')
            text_ += "\\\\";
        else
            text_ += c;
    }
    text_ += '\n';
    return *this;
}

UnitKey& UnitKey::add(const UnitKey& other)
{
    text_ += other.text_;
    return *this;
}

std::string UnitKey::name() const
{
    constexpr std::uint64_t second_seed = 0x9e3779b97f4a7c15; // any other than the first
    return fmt::format("{:016x}{:016x}", xxh64_bytes(text_), xxh64_bytes(text_, second_seed));
}

/// Returns nothing where the manifest is not there.
std::optional<UnitStore::Stamp> UnitStore::stamp_of(const fs::path& manifest)
{
    struct stat status = {};
    if (::stat(manifest.c_str(), &status) != 0) {
        ask_server_about(manifest.parent_path());
        if (::stat(manifest.c_str(), &status) != 0) return std::nullopt;
    }
    return Stamp{status.st_dev, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

fs::path UnitStore::base_of(const std::string& name) const { return folder_ / name.substr(0, 2) / name; }

std::optional<StoredUnit> UnitStore::find(const UnitKey& key) const
{
    const fs::path base = base_of(key.name());
    const fs::path manifest_file = with_ending(base, manifest_extension);
    const auto stamp = stamp_of(manifest_file); // before reading: what is written meanwhile has another one
    if (!stamp) return {};
    {
        const std::lock_guard lock(mutex_);
        const auto known = known_.find(key.text());
        if (known != known_.end() && known->second.stamp == *stamp) return known->second.unit;
    }
    auto manifest = read_manifest(manifest_file);
    if (!manifest || manifest->key != key.text()) return {};
    auto unit = checked_unit(*std::move(manifest), base);
    if (!unit) return {};
    const std::lock_guard lock(mutex_);
    known_.insert_or_assign(key.text(), Known{*stamp, *unit});
    return unit;
}

fs::path UnitStore::file(const UnitKey& key, std::string_view name) const
{
    const fs::path file = data_file(base_of(key.name()), name);
    create_folder(file.parent_path());
    return file;
}

void UnitStore::store(const UnitKey& key, std::string_view record, const std::vector<std::string>& files)
{
    const fs::path base = base_of(key.name());
    create_folder(base.parent_path());
    Manifest manifest{key.text(), std::string(record), {}};
    StoredUnit unit{manifest.record, {}};
    for (const std::string& name : files) {
        const fs::path file = data_file(base, name);
        const auto content = content_if_readable(file);
        if (!content) throw StorageError(file.string() + ": was written and is gone");
        manifest.files.push_back({name, content->size(), xxh64_bytes(*content)});
        unit.files.emplace(name, file);
    }
    const fs::path manifest_file = with_ending(base, manifest_extension);
    write_whole_file(manifest_file, manifest_text(manifest));
    const auto stamp = stamp_of(manifest_file);
    const std::lock_guard lock(mutex_);
    if (stamp) known_.insert_or_assign(key.text(), Known{*stamp, std::move(unit)});
}

void UnitStore::remove(const UnitKey& key)
{
    const fs::path base = base_of(key.name());
    const auto manifest = read_manifest(with_ending(base, manifest_extension));
    std::error_code error;
    fs::remove(with_ending(base, manifest_extension), error); // first: without it the files are nothing
    if (manifest && manifest->key == key.text())
        for (const FileEntry& entry : manifest->files) fs::remove(data_file(base, entry.name), error);
    const std::lock_guard lock(mutex_);
    known_.erase(key.text());
}

std::vector<fs::path> UnitStore::manifests() const
{
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder_, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == manifest_extension && !entry->path().filename().string().starts_with("."))
            found.push_back(entry->path());
    return found;
}

bool UnitStore::copy_unit(const fs::path& manifest_file)
{
    const auto manifest = read_manifest(manifest_file);
    const std::string name = manifest_file.stem().string();
    if (!manifest || name.size() < 3) return false;
    const fs::path base = base_of(name);
    const auto own = read_manifest(with_ending(base, manifest_extension));
    if (own && checked_unit(*own, base)) return false;
    const fs::path source = manifest_file.parent_path() / name;
    if (!checked_unit(*manifest, source)) return false;

    create_folder(base.parent_path());
    for (const FileEntry& entry : manifest->files)
        write_whole_file(data_file(base, entry.name), read_whole_file(data_file(source, entry.name)));
    write_whole_file(with_ending(base, manifest_extension), manifest_text(*manifest));
    return true;
}

}
