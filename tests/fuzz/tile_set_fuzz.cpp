// Poisson disk tile sets, .ptiles and JSON: what is accepted is written and read again, and small sets are certified
// and looked up as `tiles verify` and `tiles points` do.
//
// Mutations alone would never get past the checksum and the size of a binary file, so that the mutator mends both.
#include "base/files/xxh64_bytes.hpp"
#include "tests/fuzz/fuzz_support.hpp"
#include "tests/fuzz/mended_mutation.hpp"
#include "tiles/poisson/monotile_points_file.hpp"
#include "tiles/poisson/proof/tile_certificate.hpp"
#include "tiles/poisson/tile_lookup.hpp"
#include "tiles/poisson/tile_set_file.hpp"
#include "tiles/poisson/tile_set_json.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>

namespace poissonlab::fuzz {
namespace {

constexpr std::size_t header_size = 128; // docs/tile-set-file.md
constexpr std::size_t checksum_offset = 120;
constexpr std::uint32_t most_certified_points = 1000;

std::uint32_t word_at(const unsigned char* data, std::size_t offset)
{
    std::uint32_t word = 0;
    std::memcpy(&word, data + offset, sizeof(word));
    return word;
}

/// Sets what a header says of how far points with so many coordinates are outside of their squares.
void mend_overhang(unsigned char* data, std::uint64_t coordinates)
{
    std::array<std::int32_t, 2> overhang{}; // below, above
    for (std::uint64_t i = 0; i < coordinates; ++i) {
        const std::int32_t stored = data[header_size + 2 * i] | data[header_size + 2 * i + 1] << 8;
        overhang = {std::max(overhang[0], 32768 - 2 * stored), std::max(overhang[1], 2 * stored - 98304)};
    }
    std::memcpy(data + 100, overhang.data(), sizeof(overhang));
}

/// The size of a file with the points of a monotile, by the numbers of its header.
std::uint64_t monotile_size(const unsigned char* data)
{
    const std::uint64_t states = word_at(data, 28), points = word_at(data, 32) % 32, parts = word_at(data, 48);
    return header_size + 16 * (points + word_at(data, 52) + parts) + 8 * states * (1 + points) + 2 * parts * points;
}

/// Makes the file as long as its header says, where there is room, and its checksum right. Returns the new size.
std::size_t mended(unsigned char* data, std::size_t size, std::size_t max_size)
{
    if (size < header_size || std::memcmp(data, "PTILES", 6) != 0) return size;
    const std::uint64_t points = std::uint64_t{word_at(data, 28)} * word_at(data, 32);
    const std::uint64_t dimension = word_at(data, 20) % 4;
    const std::uint32_t version = word_at(data, 8);
    const bool has_chains = version == 2 && word_at(data, 88) == 1;
    const std::uint64_t lengths = has_chains ? std::uint64_t{2} * word_at(data, 24) * word_at(data, 24) : 0;
    const std::uint64_t ranks = version > 1 && word_at(data, 108) == 1 ? points : 0;
    const std::uint64_t classes = version == 3 ? word_at(data, 36) % 33 : 0;
    const std::uint64_t of_classes =
        4 * classes + 8 * classes * (classes + 1); // numbers, and two distances of each pair
    const std::uint64_t declared =
        version == 4 ? monotile_size(data) : header_size + (points * dimension + lengths + ranks) * 2 + of_classes;
    if (points <= max_size && lengths <= max_size && declared <= max_size) {
        for (std::size_t i = size; i < declared; ++i) data[i] = static_cast<unsigned char>(i * i * 37);
        size = declared;
        if (has_chains) mend_overhang(data, points * dimension);
    }
    Xxh64 hash;
    const auto* bytes = reinterpret_cast<const char*>(data);
    hash.add({bytes, checksum_offset});
    hash.add({bytes + header_size, size - header_size});
    const std::uint64_t checksum = hash.value();
    std::memcpy(data + checksum_offset, &checksum, sizeof(checksum));
    return size;
}

void check_certificate(const PoissonTileSet& set)
{
    const TileCertificate certificate = certify(set);
    require(certificate.squared_min_distance <= certificate.squared_closure_distance,
            "more than the distance that occurs is guaranteed");
    // Points of one tile are points of a tiling.
    for (std::uint32_t tile = 0; tile < std::min(set.parameters.tiles, 16U); ++tile)
        for (std::uint32_t i = 0; i < set.parameters.points_per_tile; ++i)
            for (std::uint32_t j = 0; j < i; ++j) {
                const UnitPosition a = set.position(tile, i), b = set.position(tile, j);
                std::uint64_t squared = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::int64_t x = std::int64_t{a[k]} - b[k];
                    squared += static_cast<std::uint64_t>(x * x);
                }
                require(certificate.squared_min_distance <= squared, "points of a tile are nearer than is guaranteed");
            }
}

void check_lookup(const PoissonTileSet& set)
{
    constexpr std::int32_t far = std::numeric_limits<std::int32_t>::max();
    for (const std::int32_t period : {0, 1, 5, far}) {
        const ptiles_tiling tiling = runtime_tiling(set, {7, period});
        for (const std::int32_t x : {-far - 1, -1, 0, far})
            for (const std::int32_t y : {-far - 1, 2, far})
                require(ptiles_tile(&tiling, x, y, x) < set.parameters.tiles, "a tile that is not in the set");
    }
}

/// The engines' use of the file's bytes, without the help of the reader above.
void check_runtime(std::string_view bytes)
{
    std::vector<std::uint16_t> at_even_address(bytes.size() / 2 + 1);
    std::memcpy(at_even_address.data(), bytes.data(), bytes.size());
    ptiles_tiling tiling{{}, 3, 0};
    if (ptiles_open(&tiling.set, at_even_address.data(), bytes.size())) return;
    const std::array<double, 3> position{0.3, -0.7, 0.1}, high{1.3, 0.3, 0.6};
    ptiles_point nearest{};
    if (tiling.set.points_per_tile > most_certified_points) return;
    const double squared = ptiles_nearest(&tiling, position.data(), &nearest);
    require(squared >= 0 && nearest.index < tiling.set.points_per_tile, "a nearest point that is none");
    std::array<ptiles_point, 4> points{};
    const std::uint64_t found =
        ptiles_in_window(&tiling, position.data(), high.data(), points.data(), points.size(), 1);
    for (std::size_t i = 0; i < std::min<std::size_t>(found, points.size()); ++i)
        require(points[i].position[0] >= position[0] && points[i].position[0] < high[0],
                "a point outside of the window");
}

/// Points of monotiles by their file's tables, whether these are those of a tiling or lie.
void check_monotile(const pmono_set& set)
{
    constexpr std::int64_t far = std::int64_t{1} << 40;
    for (const std::array<std::int64_t, 2>& origin : {std::array<std::int64_t, 2>{0, 0}, {far, -far}, {-12, 34567}}) {
        const std::array<double, 2> low{-3, -2.5}, high{4, 5};
        std::array<pmono_point, 4> points{};
        const std::uint64_t found =
            pmono_in_window(&set, 5, origin.data(), low.data(), high.data(), points.data(), points.size(), 0.9);
        for (std::size_t i = 0; i < std::min<std::size_t>(found, points.size()); ++i)
            require(points[i].position[0] >= low[0] && points[i].position[1] < high[1] && points[i].level < 0.9,
                    "a point outside of the window");
    }
}

void check_accepted(const PoissonTileSet& set)
{
    require(decode_tile_set(encode_tile_set(set), "again") == set, "a set that changes when it is written and read");
    if (std::size_t{set.parameters.tiles} * set.parameters.points_per_tile > most_certified_points) return;
    const PoissonTileSet again = decode_tile_set(tile_set_to_json(set), "again");
    require(again == set, "a set that changes when it is written and read as JSON");
    accepts("", [&] { check_certificate(set); });
    check_lookup(set);
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
    // Threads of their own would make libFuzzer's measurements differ from run to run.
    static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    fuzz::check_runtime(bytes);
    std::optional<MonotilePointsFile> monotile;
    if (fuzz::accepts("a.ptiles", [&] { monotile.emplace(std::string(bytes), "a.ptiles"); }))
        fuzz::check_monotile(monotile->set());
    PoissonTileSet set;
    if (fuzz::accepts("a.ptiles", [&] { set = decode_tile_set(bytes, "a.ptiles"); })) fuzz::check_accepted(set);
    return 0;
}
