// kind = "tiling-costs": hash evaluations a tile, counted, and times a tile by scanlines and directly.
//
// Lagae, Tile-Based Methods in Computer Graphics, 2007, sections 3.2, 3.3, 3.4.2.3, 3.4.3 and 3.5. Times are medians of
// measurements that take turns; they differ between machines and are there to be compared with each other.
#include "host/schemes/scheme_run.hpp"
#include "tiles/tilings/direct_tiling.hpp"
#include "tiles/tilings/scanline_tiling.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace poissonlab {
namespace {

/// A hash function that counts how often it is asked.
class CountingHash
{
public:
    explicit CountingHash(int& count) : count_(count) {}

    Color colors() const { return 2; }
    Color operator()(std::int64_t, std::int64_t) const
    {
        ++count_;
        return 0;
    }

private:
    int& count_;
};

struct DirectWay
{
    DirectAlgorithm algorithm;
    const char* key;
    const char* title;
};

constexpr std::array<DirectWay, 4> direct_ways{
    {{DirectAlgorithm::corner, "corner", "corner tiles"},
     {DirectAlgorithm::wang_two_hashes, "two_hashes", "Wang tiles, two hash functions"},
     {DirectAlgorithm::wang_one_hash, "one_hash", "Wang tiles, one hash function"},
     {DirectAlgorithm::wang_edge_hash, "edge_hash", "Wang tiles, a hash function at the edges"}}};

int evaluations_of(DirectAlgorithm algorithm)
{
    int count = 0;
    const CountingHash hash(count);
    switch (algorithm) {
    case DirectAlgorithm::corner:
        direct_corner_tile(hash, Plane{}, 0, 0);
        break;
    case DirectAlgorithm::wang_two_hashes:
        two_hash_wang_tile(hash, hash, Plane{}, 0, 0);
        break;
    case DirectAlgorithm::wang_one_hash:
        one_hash_wang_tile(hash, Plane{}, 0, 0);
        break;
    case DirectAlgorithm::wang_edge_hash:
        edge_hash_wang_tile(hash, hash, Plane{}, 0, 0);
        break;
    }
    return count;
}

/// Keeps a compiler from leaving out what nobody looks at.
void keep(TileIndex tile)
{
    volatile TileIndex kept = tile;
    static_cast<void>(kept);
}

std::function<void()> streamed(const Tiling& tiling, std::uint64_t side)
{
    return [&tiling, side] {
        tiling.stream({-3, -3, side, side}, [](auto, auto, std::span<const TileIndex> tiles) { keep(tiles.back()); });
    };
}

std::function<void()> anywhere(const Tiling& tiling, std::uint64_t side)
{
    return [&tiling, side] {
        std::uint64_t x = 1, y = 2;
        TileIndex sum = 0;
        for (std::uint64_t i = 0; i < side * side; ++i) {
            x += 0x9E3779B97F4A7C15; // Weyl sequences: places that nothing foresees
            y += 0xD1B54A32D192ED03;
            sum += tiling.tile(static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
        }
        keep(sum);
    };
}

std::function<void()> scanned(const TileSet& set, std::uint64_t side, std::uint64_t seed)
{
    return [&set, side, seed] {
        ScanlineTiling(set, side, seed).stream(side, [](auto, auto, std::span<const TileIndex> tiles) {
            keep(tiles.back());
        });
    };
}

/// Adds a time a tile of each piece of work to the numbers and to the table.
class TimeTable
{
public:
    TimeTable(std::uint64_t side, DistributionResult& result)
        : tiles_(static_cast<double>(side * side)), result_(result)
    {}

    void add(std::string key, std::string title, std::function<void()> work)
    {
        names_.emplace_back(std::move(key), std::move(title));
        work_.push_back(std::move(work));
    }

    void measure()
    {
        const std::vector<double> times = median_nanoseconds(work_, tiles_);
        for (std::size_t i = 0; i < times.size(); ++i)
            result_.numbers.push_back(
                {names_[i].first + "_ns", names_[i].second, times[i], "ns a tile", {}, false, true});
    }

private:
    double tiles_;
    DistributionResult& result_;
    std::vector<std::pair<std::string, std::string>> names_;
    std::vector<std::function<void()>> work_;
};

void add_counts(DistributionResult& result)
{
    for (const DirectWay& way : direct_ways)
        result.numbers.push_back({fmt::format("{}_evaluations", way.key),
                                  fmt::format("Hash evaluations, {}", way.title),
                                  static_cast<double>(evaluations_of(way.algorithm)), "a tile, counted"});
}

/// Table entries and exact periods of the hash functions.
void add_hashes(Color colors, std::uint64_t seed, DistributionResult& result)
{
    const LongPeriodHash combined(colors, stream_key(seed, Purpose::tiling_colors, 0));
    const auto& sizes = combined.design().sizes;
    result.numbers.push_back({"tables", "Tables of the long-period hash", static_cast<double>(sizes.size()), ""});
    result.numbers.push_back({"entries", "Entries of these tables", std::accumulate(sizes.begin(), sizes.end(), 0.0),
                              "a permutation table has 252 to 256"});
    result.numbers.push_back({"period", "Period of the long-period hash", static_cast<double>(combined.period().x),
                              "lattice points, found exactly"});
}

DistributionTable set_sizes()
{
    DistributionTable table{"Tiles in the sets", {"colours", "compact, Wang", "compact, corner", "complete"}, {}};
    for (Color colors = 2; colors <= 8; ++colors)
        table.rows.push_back({fmt::format("{}", colors), fmt::format("{}", compact_wang_set(colors).size()),
                              fmt::format("{}", compact_corner_set(colors).size()),
                              fmt::format("{}", TileSet::complete(TileKind::wang, colors).size())});
    return table;
}

}

DistributionResult make_tiling_costs(const TilingCostSettings& settings, std::uint64_t seed)
{
    const Color colors = settings.colors;
    const auto side = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(settings.tiles)));
    DistributionResult result;
    result.facts = {fmt::format("{} colours", colors), fmt::format("{0} x {0} tiles a measurement", side)};
    add_counts(result);
    add_hashes(colors, seed, result);
    const TileSet wang = compact_wang_set(colors), corner = compact_corner_set(colors);
    const TileSet complete_corner = TileSet::complete(TileKind::corner, colors);
    std::vector<Tiling> tilings;
    tilings.reserve(2 * direct_ways.size() + 1);
    TimeTable times(side, result);
    times.add("scanline_wang", "Wang tiles by scanlines, compact set", scanned(wang, side, seed));
    times.add("scanline_corner", "Corner tiles by scanlines, compact set", scanned(corner, side, seed));
    times.add("scanline_corner_complete", "Corner tiles by scanlines, complete set",
              scanned(complete_corner, side, seed));
    for (const DirectWay& way : direct_ways) {
        const Tiling& plain =
            tilings.emplace_back(way.algorithm, WangColors{colors, colors}, HashKind::permutation, seed);
        times.add(fmt::format("{}_streamed", way.key), fmt::format("{}, streamed, permutation table", way.title),
                  streamed(plain, side));
        times.add(fmt::format("{}_anywhere", way.key), fmt::format("{}, anywhere, permutation table", way.title),
                  anywhere(plain, side));
        const Tiling& combined =
            tilings.emplace_back(way.algorithm, WangColors{colors, colors}, HashKind::long_period, seed);
        times.add(fmt::format("{}_long_streamed", way.key), fmt::format("{}, streamed, long-period hash", way.title),
                  streamed(combined, side));
        times.add(fmt::format("{}_long_anywhere", way.key), fmt::format("{}, anywhere, long-period hash", way.title),
                  anywhere(combined, side));
    }
    times.measure();
    result.tables.push_back(set_sizes());
    return result;
}

}
