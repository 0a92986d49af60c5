#include "host/tile_sampling/penrose/penrose_table.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

namespace poissonlab {
namespace {

constexpr const char* table_header = "poissonlab Penrose table 1: 21 rows of 21 vectors, along and left";
constexpr const char* checksum_word = "xxh64 ";

std::string table_text(const PenroseTable& table)
{
    std::string text = std::string(table_header) + "\n";
    for (const auto& row : table.rows) {
        for (const PenroseVector& v : row) text += fmt::format("{} {}  ", v.along, v.left);
        text.replace(text.size() - 2, 2, "\n");
    }
    return text;
}

}

void write_penrose_table(const std::filesystem::path& file, const PenroseTable& table)
{
    const std::string text = table_text(table);
    write_whole_file(file, text + fmt::format("{}{:016x}\n", checksum_word, xxh64_bytes(text)));
}

std::optional<PenroseTable> read_penrose_table(const std::filesystem::path& file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    std::string content;
    try {
        content = read_whole_file(file);
    } catch (const InputError&) {
        return std::nullopt;
    }
    std::istringstream lines(content);
    std::string header;
    std::getline(lines, header);
    PenroseTable table;
    for (auto& row : table.rows)
        for (PenroseVector& v : row) lines >> v.along >> v.left;
    // The file is exactly what was written for these numbers.
    const std::string text = table_text(table);
    if (!lines || content != text + fmt::format("{}{:016x}\n", checksum_word, xxh64_bytes(text))) return std::nullopt;
    constexpr std::int32_t most = longest_vector << vector_bits;
    for (const auto& row : table.rows)
        for (const PenroseVector& v : row)
            if (std::abs(v.along) > most || std::abs(v.left) > most) return std::nullopt;
    return table;
}

}
