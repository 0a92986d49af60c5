#include "tiles/polyominoes/pair_relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace poissonlab {
namespace {

constexpr double wanted_relative_radius = 0.8;
constexpr int soft_iterations = 80;
constexpr int hard_iterations = 80;
constexpr double soft_step = 0.3;
constexpr double hard_reach = 1.4; ///< in spacings; pairs within it may come too near while points are pushed apart

class PairRelaxation
{
public:
    explicit PairRelaxation(SharedPoints points)
        : pairs_(std::move(points.pairs)), orientations_(std::move(points.orientations)),
          frequencies_(std::move(points.frequencies)), spacing_(points.spacing), entries_(frequencies_.size()),
          corrections_(entries_), pushes_(entries_), weights_(entries_)
    {}

    std::vector<PairVector> run()
    {
        for (int i = 0; i < soft_iterations; ++i) spread();
        forget_far_pairs();
        std::vector<PairVector> best = corrections_;
        double best_distance = least_distance();
        for (int i = 0; i < hard_iterations; ++i) {
            push_apart();
            if (const double distance = least_distance(); distance > best_distance) {
                best_distance = distance;
                best = corrections_;
            }
        }
        return best;
    }

private:
    /// The way from the first point to the second, in the first one's frame.
    PairVector difference(const EntryPair& pair) const
    {
        const PairVector& first = corrections_[pair.first];
        const PairVector second = turned(orientations_[pair.orientation], corrections_[pair.second]);
        return {pair.difference.x + second.x - first.x, pair.difference.y + second.y - first.y};
    }

    double least_distance() const
    {
        double least = 4 * spacing_ * spacing_;
        for (const EntryPair& pair : pairs_) {
            const PairVector d = difference(pair);
            least = std::min(least, d.x * d.x + d.y * d.y);
        }
        return std::sqrt(least);
    }

    void push(std::uint32_t entry, const PairVector& by, double weight)
    {
        pushes_[entry].x += weight * by.x;
        pushes_[entry].y += weight * by.y;
        weights_[entry] += weight;
    }

    void push_both(const EntryPair& pair, const PairVector& by, double weight)
    {
        push(pair.first, -by, weight);
        push(pair.second, turned_back(orientations_[pair.orientation], by), weight);
    }

    /// A step down the energy.
    void spread()
    {
        const double reach = soft_reach * spacing_;
        std::ranges::fill(pushes_, PairVector{});
        for (const EntryPair& pair : pairs_) {
            const PairVector d = difference(pair);
            const double squared = d.x * d.x + d.y * d.y;
            if (squared >= reach * reach) continue;
            const double rest = 1 - std::sqrt(squared) / reach, force = rest * rest * rest;
            push_both(pair, {force * d.x, force * d.y}, pair.weight);
        }
        for (std::size_t i = 0; i < entries_; ++i) move(corrections_[i], pushes_[i], soft_step / frequencies_[i]);
    }

    void forget_far_pairs()
    {
        const double reach = hard_reach * spacing_;
        std::erase_if(pairs_, [&](const EntryPair& pair) {
            const PairVector d = difference(pair);
            return d.x * d.x + d.y * d.y > reach * reach;
        });
    }

    void push_apart()
    {
        const double wanted = wanted_relative_radius * spacing_;
        std::ranges::fill(pushes_, PairVector{});
        std::ranges::fill(weights_, 0.0);
        for (const EntryPair& pair : pairs_) {
            const PairVector d = difference(pair);
            const double squared = d.x * d.x + d.y * d.y;
            if (squared >= wanted * wanted || squared == 0) continue;
            const double distance = std::sqrt(squared), lack = wanted - distance;
            const double part = 0.5 * lack / distance, weight = lack / wanted * (lack / wanted);
            push_both(pair, {part * d.x, part * d.y}, weight);
        }
        for (std::size_t i = 0; i < entries_; ++i)
            if (weights_[i] > 0) move(corrections_[i], pushes_[i], 1 / weights_[i]);
    }

    void move(PairVector& correction, const PairVector& by, double factor) const
    {
        correction.x += factor * by.x;
        correction.y += factor * by.y;
        const double length = std::sqrt(correction.x * correction.x + correction.y * correction.y);
        const double longest = longest_correction * spacing_;
        if (length <= longest) return;
        correction.x *= longest / length;
        correction.y *= longest / length;
    }

    std::vector<EntryPair> pairs_;
    std::vector<Orientation> orientations_;
    std::vector<double> frequencies_;
    double spacing_; ///< the distance in the densest packing with as many points
    std::size_t entries_;
    std::vector<PairVector> corrections_, pushes_;
    std::vector<double> weights_;
};

}

std::vector<PairVector> relaxed_points(SharedPoints points) { return PairRelaxation(std::move(points)).run(); }

}
