// Manifests of finished units of work: what is no sound unit counts as missing, and whatever they say, no file
// elsewhere is read or written. The mutator mends the checksum at the end, which no mutation would get right.
#include "base/files/xxh64_bytes.hpp"
#include "experiment/store/unit_store.hpp"
#include "tests/fuzz/fuzz_support.hpp"
#include "tests/fuzz/mended_mutation.hpp"

#include <fmt/format.h>

#include <cstring>

namespace poissonlab::fuzz {
namespace {

constexpr std::string_view checksum_example = "xxh64 0123456789abcdef\n";

UnitKey key() { return UnitKey("fuzz").add("seed", 1); }

/// A store with the data file that the corpus names.
std::filesystem::path make_store()
{
    const std::filesystem::path folder = input_folder() / "units";
    const auto file = UnitStore(folder).file(key(), "a.txt");
    write_input(std::filesystem::relative(file, input_folder()), "content");
    return folder;
}

/// Puts a right checksum at the end, in place of the one that is there. Returns the new size.
std::size_t mended(unsigned char* data, std::size_t size, std::size_t max_size)
{
    if (size >= checksum_example.size()) size -= checksum_example.size();
    if (size + checksum_example.size() > max_size) return size;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const std::string line = fmt::format("xxh64 {:016x}\n", xxh64_bytes(text));
    std::memcpy(data + size, line.data(), line.size());
    return size + line.size();
}

void check_unit(const StoredUnit& unit, const std::filesystem::path& folder)
{
    for (const auto& [name, file] : unit.files) {
        require(std::filesystem::is_regular_file(file), "a unit with a file that is not there");
        require(file.parent_path().parent_path() == folder, "a unit with a file that is elsewhere");
    }
}

}
}

extern "C" std::size_t LLVMFuzzerCustomMutator(unsigned char* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed)
{
    return poissonlab::fuzz::mutated(data, size, max_size, seed, poissonlab::fuzz::mended);
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    static const std::filesystem::path folder = fuzz::make_store();
    const std::string name = fuzz::key().name();
    const auto manifest = std::filesystem::path("units") / name.substr(0, 2) / (name + ".unit");
    fuzz::write_input(manifest, {reinterpret_cast<const char*>(data), size});

    std::optional<StoredUnit> unit;
    fuzz::accepts("", [&] { unit = UnitStore(folder).find(fuzz::key()); });
    if (unit) fuzz::check_unit(*unit, folder);

    // Copied, it is the same unit; what is damaged is not copied.
    const std::filesystem::path copy = fuzz::input_folder() / "copy";
    std::size_t copied = 0;
    fuzz::accepts("", [&] { UnitStore(copy).merge(UnitStore(folder), [&](std::size_t count) { copied = count; }); });
    if (unit) {
        const auto again = UnitStore(copy).find(fuzz::key());
        fuzz::require(copied == 1 && again && again->record == unit->record, "a unit that changes when it is copied");
        fuzz::check_unit(*again, copy);
    }
    if (copied > 0) std::filesystem::remove_all(copy);
    return 0;
}
