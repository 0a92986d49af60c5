#include "tiles/polyominoes/polyomino_table.hpp"

#include "base/geometry/relative_radius.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace poissonlab {
namespace {

constexpr double wanted_relative_radius = 0.8;
constexpr int soft_iterations = 80;
constexpr int hard_iterations = 80;
constexpr double soft_step = 0.3;

// These lengths are in distances of the densest packing.
constexpr double longest_correction = 0.5;
constexpr double soft_reach = 2.2;
constexpr double hard_reach = 1.4; ///< of pairs that may come too near while points are pushed apart
constexpr double enough = 1.6;     ///< of pairs that are taken into account whatever ancestors they have

struct Vector
{
    double x = 0;
    double y = 0;

    Vector operator-() const { return {-x, -y}; }
};

/// Two entries of the table that have points near each other: the second one as seen from the first one's tile.
struct EntryPair
{
    std::uint32_t first;
    std::uint32_t second;
    Pose pose;
    Vector difference; ///< of the middles, in cells
    double weight;     ///< how often it occurs

    auto key() const { return std::tie(first, second, pose); }
};

class RowRelaxation
{
public:
    RowRelaxation(const KeptTiles& tiles, const std::vector<double>& frequencies)
        : tiles_(tiles), frequencies_(frequencies), entries_(tiles.neighbourhoods.collars.size() * tiles.kept),
          corrections_(entries_), pushes_(entries_), weights_(entries_)
    {
        const auto cells = static_cast<double>(cells_of(tiles.neighbourhoods.rule.shape).size());
        spacing_ = max_min_distance(1, 2) * std::sqrt(cells * static_cast<double>(tiles.numbers()) / tiles.kept);
        find_pairs();
    }

    std::vector<Correction> run()
    {
        for (int i = 0; i < soft_iterations; ++i) spread();
        forget_far_pairs();
        std::vector<Vector> best = corrections_;
        double best_distance = least_distance();
        for (int i = 0; i < hard_iterations; ++i) {
            push_apart();
            if (const double distance = least_distance(); distance > best_distance) {
                best_distance = distance;
                best = corrections_;
            }
        }
        std::vector<Correction> rounded;
        for (const Vector& v : best)
            rounded.push_back({static_cast<std::int16_t>(std::lround(v.x * cell_units)),
                               static_cast<std::int16_t>(std::lround(v.y * cell_units))});
        return rounded;
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
        std::ranges::sort(pairs_, {}, &EntryPair::key);
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

    /// The way from the first point to the second, in the first one's frame.
    Vector difference(const EntryPair& pair) const
    {
        const Vector& first = corrections_[pair.first];
        const Vector second = turned(pair.pose.turn, corrections_[pair.second]);
        return {pair.difference.x + second.x - first.x, pair.difference.y + second.y - first.y};
    }

    double least_distance() const
    {
        double least = 4 * spacing_ * spacing_;
        for (const EntryPair& pair : pairs_) {
            const Vector d = difference(pair);
            least = std::min(least, d.x * d.x + d.y * d.y);
        }
        return std::sqrt(least);
    }

    void push(std::uint32_t entry, const Vector& by, double weight)
    {
        pushes_[entry].x += weight * by.x;
        pushes_[entry].y += weight * by.y;
        weights_[entry] += weight;
    }

    void push_both(const EntryPair& pair, const Vector& by, double weight)
    {
        push(pair.first, -by, weight);
        push(pair.second, turned(inverse(pair.pose.turn), by), weight);
    }

    /// A step down the energy.
    void spread()
    {
        const double reach = soft_reach * spacing_;
        std::ranges::fill(pushes_, Vector{});
        for (const EntryPair& pair : pairs_) {
            const Vector d = difference(pair);
            const double squared = d.x * d.x + d.y * d.y;
            if (squared >= reach * reach) continue;
            const double rest = 1 - std::sqrt(squared) / reach, force = rest * rest * rest;
            push_both(pair, {force * d.x, force * d.y}, pair.weight);
        }
        for (std::size_t i = 0; i < entries_; ++i)
            move(corrections_[i], pushes_[i], soft_step / frequencies_[i / tiles_.kept]);
    }

    void forget_far_pairs()
    {
        const double reach = hard_reach * spacing_;
        std::erase_if(pairs_, [&](const EntryPair& pair) {
            const Vector d = difference(pair);
            return d.x * d.x + d.y * d.y > reach * reach;
        });
    }

    void push_apart()
    {
        const double wanted = wanted_relative_radius * spacing_;
        std::ranges::fill(pushes_, Vector{});
        std::ranges::fill(weights_, 0.0);
        for (const EntryPair& pair : pairs_) {
            const Vector d = difference(pair);
            const double squared = d.x * d.x + d.y * d.y;
            if (squared >= wanted * wanted || squared == 0) continue;
            const double distance = std::sqrt(squared), lack = wanted - distance;
            const double part = 0.5 * lack / distance, weight = lack / wanted * (lack / wanted);
            push_both(pair, {part * d.x, part * d.y}, weight);
        }
        for (std::size_t i = 0; i < entries_; ++i)
            if (weights_[i] > 0) move(corrections_[i], pushes_[i], 1 / weights_[i]);
    }

    void move(Vector& correction, const Vector& by, double factor) const
    {
        correction.x += factor * by.x;
        correction.y += factor * by.y;
        const double length = std::sqrt(correction.x * correction.x + correction.y * correction.y);
        const double longest = longest_correction * spacing_;
        if (length <= longest) return;
        correction.x *= longest / length;
        correction.y *= longest / length;
    }

    KeptTiles tiles_;
    const std::vector<double>& frequencies_;
    std::size_t entries_;
    double spacing_ = 0; ///< of the densest packing with as many points, in cells
    std::vector<EntryPair> pairs_;
    std::size_t unique_pairs_ = 0;
    std::vector<Vector> corrections_, pushes_;
    std::vector<double> weights_;
};

}

std::vector<Correction> relaxed_row(const KeptTiles& tiles, const std::vector<double>& frequencies)
{
    return RowRelaxation(tiles, frequencies).run();
}

}
