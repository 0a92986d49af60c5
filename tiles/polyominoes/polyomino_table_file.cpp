#include "tiles/polyominoes/polyomino_table.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_archive.hpp"
#include "base/files/whole_file.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <array>
#include <bit>
#include <string>
#include <string_view>

namespace poissonlab {

template <class Archive>
void serialize(Archive& archive, LatticePlace& place)
{
    archive(place.x, place.y);
}

template <class Archive>
void serialize(Archive& archive, Pose& pose)
{
    archive(pose.shift, pose.turn);
}

template <class Archive>
void serialize(Archive& archive, NearTiles& tiles)
{
    archive(tiles.first, tiles.second, tiles.pose);
}

template <class Archive>
void serialize(Archive& archive, PolyominoRule& rule)
{
    archive(rule.shape, rule.factor, rule.children);
}

template <class Archive>
void serialize(Archive& archive, Neighbourhoods& all)
{
    archive(all.rule, all.first_level, all.collars, all.next, all.pairs);
}

template <class Archive>
void serialize(Archive& archive, RowProof& proof)
{
    archive(proof.squared_distance, proof.divisions, proof.squared_distance_before);
}

template <class Archive>
void serialize(Archive& archive, PolyominoTable& table)
{
    archive(table.neighbourhoods, table.depth, table.rows, table.proofs);
}

namespace {

constexpr std::size_t checksum_size = sizeof(std::uint64_t);

/// The checksum of a table's bytes, as bytes.
std::string checksum_of(std::string_view bytes)
{
    const auto raw = std::bit_cast<std::array<char, checksum_size>>(xxh64_bytes(bytes));
    return {raw.data(), raw.size()};
}

}

void write_with_checksum(const std::filesystem::path& file, const std::string& bytes)
{
    write_whole_file(file, bytes + checksum_of(bytes));
}

std::optional<std::string> read_with_checksum(const std::filesystem::path& file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    std::string bytes = read_whole_file(file);
    if (bytes.size() < checksum_size) return std::nullopt;
    const std::string checksum = bytes.substr(bytes.size() - checksum_size);
    bytes.resize(bytes.size() - checksum_size);
    if (checksum != checksum_of(bytes)) return std::nullopt;
    return bytes;
}

void write_polyomino_table(const std::filesystem::path& file, const PolyominoTable& table)
{
    write_with_checksum(file, to_bytes(table));
}

std::optional<PolyominoTable> read_polyomino_table(const std::filesystem::path& file)
{
    try {
        const std::optional<std::string> bytes = read_with_checksum(file);
        if (!bytes) return std::nullopt;
        PolyominoTable table;
        from_bytes(*bytes, table);
        return table;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

}
