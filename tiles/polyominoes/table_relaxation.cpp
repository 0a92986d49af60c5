#include "tiles/polyominoes/polyomino_table.hpp"

#include "base/geometry/relative_radius.hpp"
#include "tiles/polyominoes/pair_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace poissonlab {
namespace {

constexpr double enough = 1.6; ///< pairs within this reach, in spacings, count whatever ancestors they have

/// Entries of the table that have points near each other, and the pose of their tiles.
struct PosedPair
{
    std::uint32_t first;
    std::uint32_t second;
    Pose pose;
    PairVector difference; ///< the difference of the middles, in cells
    double weight;         ///< the frequency of the pair

    auto key() const { return std::tie(first, second, pose); }
};

class RowPairs
{
public:
    RowPairs(const KeptTiles& tiles, const std::vector<double>& frequencies) : tiles_(tiles), frequencies_(frequencies)
    {
        const auto cells = static_cast<double>(cells_of(tiles.neighbourhoods.rule.shape).size());
        spacing_ = max_min_distance(1, 2) * std::sqrt(cells * static_cast<double>(tiles.numbers()) / tiles.kept);
        find_pairs();
    }

    SharedPoints points()
    {
        SharedPoints shared;
        for (const PosedPair& pair : pairs_)
            shared.pairs.push_back({pair.first, pair.second, pair.pose.turn, pair.difference, pair.weight});
        pairs_ = {};
        for (Turn turn = 0; turn < turns; ++turn) {
            const LatticePlace x = turned(turn, LatticePlace{1, 0}), y = turned(turn, LatticePlace{0, 1});
            shared.orientations.push_back({static_cast<double>(x.x), static_cast<double>(y.x), static_cast<double>(x.y),
                                           static_cast<double>(y.y)});
        }
        for (std::size_t i = 0; i < tiles_.neighbourhoods.collars.size(); ++i)
            shared.frequencies.insert(shared.frequencies.end(), tiles_.kept, frequencies_[i]);
        shared.spacing = spacing_;
        return shared;
    }

private:
    void find_pairs()
    {
        const double reach = (soft_reach + 2 * longest_correction) * spacing_;
        const Neighbourhoods& all = tiles_.neighbourhoods;
        const std::uint64_t numbers = tiles_.numbers();
        const double parts = 2 * static_cast<double>(cells_of(all.rule.shape).size());
        const LatticePlace centroid = centroid_sum(all.rule.shape);
        std::uint32_t levels = tiles_.depth;
        double part = 1; // entries are tiles of the table's ancestors
        for (double gap = 2 * std::sqrt(static_cast<double>(numbers)); gap < enough * spacing_; ++levels) {
            gap *= static_cast<double>(all.rule.factor);
            part /= static_cast<double>(all.rule.children.size());
        }
        const auto entry = [&](const TableTile& tile) {
            return static_cast<std::uint32_t>(tile.entry / numbers * tiles_.kept + tile.entry % numbers);
        };
        PairSearch(tiles_, levels, reach).run([&](const TableTile& a, const TableTile& b, std::size_t origin) {
            const std::uint32_t first = entry(a), second = entry(b);
            const Pose pose = seen_from(a.pose, b.pose);
            const auto order = std::tuple(second, first, inverse(pose)) <=> std::tuple(first, second, pose);
            if (order < 0) return; // the other side
            const LatticePlace shift = turned(pose.turn, centroid) - centroid;
            pairs_.push_back({first,
                              second,
                              pose,
                              {static_cast<double>(shift.x) / parts + static_cast<double>(pose.shift.x),
                               static_cast<double>(shift.y) / parts + static_cast<double>(pose.shift.y)},
                              frequencies_[origin] * (order == 0 ? part / 2 : part)});
            if (pairs_.size() > 2 * unique_pairs_ + 100'000) join_equal_pairs();
        });
        join_equal_pairs();
    }

    void join_equal_pairs()
    {
        std::ranges::sort(pairs_, {}, &PosedPair::key);
        std::size_t last = 0;
        for (std::size_t i = 1; i < pairs_.size(); ++i) {
            if (pairs_[i].key() == pairs_[last].key())
                pairs_[last].weight += pairs_[i].weight;
            else
                pairs_[++last] = pairs_[i];
        }
        pairs_.resize(std::min(pairs_.size(), last + 1));
        unique_pairs_ = pairs_.size();
    }

    KeptTiles tiles_;
    const std::vector<double>& frequencies_;
    double spacing_ = 0; ///< of the densest packing with as many points, in cells
    std::vector<PosedPair> pairs_;
    std::size_t unique_pairs_ = 0;
};

}

std::vector<Correction> relaxed_row(const KeptTiles& tiles, const std::vector<double>& frequencies)
{
    std::vector<Correction> rounded;
    for (const PairVector& v : relaxed_points(RowPairs(tiles, frequencies).points()))
        rounded.push_back({static_cast<std::int16_t>(std::lround(v.x * cell_units)),
                           static_cast<std::int16_t>(std::lround(v.y * cell_units))});
    return rounded;
}

}
