// Best candidates in rounds, for sets of a million points: each candidate alone would wait for memory that is not in
// caches, ever longer as points grow. Rounds decide about the time only.
#include "base/random/random.hpp"
#include "host/sampling/classics/candidate_darts.hpp"
#include "host/sampling/classics/plain_spec.hpp"
#include "host/sampling/classics/torus_grid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

/// The candidates of a realization, one after the other: those of the first point, those of the second, ...
class Candidates
{
public:
    Candidates(const SampleRequest& request, std::uint64_t candidates, bool grows, std::uint32_t realization)
        : stream_(stream_key(request.seed, Purpose::best_candidate, realization)), dimension_(request.dimension),
          candidates_(candidates), grows_(grows)
    {}

    /// The number of the point that the candidate is for.
    std::uint32_t point() const { return point_; }

    /// The number of candidates for that point, and whether this one is the first or the last of them.
    std::uint64_t count() const { return grows_ ? candidates_ * std::max(1u, point_) : candidates_; }
    bool is_first() const { return number_ == 0; }
    bool is_last() const { return number_ + 1 == count(); }

    TorusPosition position() const
    {
        const auto low = static_cast<std::uint32_t>(number_), high = static_cast<std::uint32_t>(number_ >> 32);
        const auto words = philox({point_, low, high, 0}, stream_);
        return {words[0], words[1], dimension_ == 3 ? words[2] : 0};
    }

    void next()
    {
        const bool was_last = is_last();
        number_ = was_last ? 0 : number_ + 1;
        point_ += was_last;
    }

private:
    StreamKey stream_;
    int dimension_;
    std::uint64_t candidates_;
    bool grows_;
    std::uint32_t point_ = 0;
    std::uint64_t number_ = 0; ///< of the candidate, for its point
};

/// Chooses points from candidates in rounds. In each, those of some points that come next are looked up among the
/// points before the round, in the order of cells; then, one after the other, among the few points that the round has
/// added.
class BestCandidates
{
public:
    BestCandidates(const Candidates& candidates, std::size_t points, int dimension)
        : next_(candidates), count_(points), dimension_(dimension), sorted_({}, dimension)
    {}

    PointSet run()
    {
        while (points_.size() < count_) {
            sorted_ = SortedTorus(points_, dimension_);
            if (next_.is_first()) useless_ = useless_distance();
            const std::uint64_t points = 1 + points_.size() / rounds_to_double;
            look_up(static_cast<std::size_t>(std::min(most_at_once, points * next_.count())));
            choose(points);
        }
        return point_set_of(points_, dimension_);
    }

private:
    static constexpr std::size_t rounds_to_double = 16;
    static constexpr std::uint64_t most_at_once = std::uint64_t{1} << 20; ///< candidates, of 24 bytes

    /// A candidate with its number in the round.
    struct Placed
    {
        TorusPosition position;
        std::uint32_t number;
    };

    /// A squared distance that the best of the next point's candidates is hardly ever below: disks of it around points
    /// cover so much of the torus that all candidates are in them once in three hundred times. Those that are in them
    /// are not looked at closer.
    std::uint64_t useless_distance() const
    {
        const double covered = std::pow(1.0 / 300, 1 / static_cast<double>(next_.count()));
        const double ball = dimension_ == 2 ? std::numbers::pi : 4 * std::numbers::pi / 3;
        const auto points = static_cast<double>(std::max<std::size_t>(1, points_.size()));
        const double distance = 0x1p32 * std::pow(covered / ball / points, 1.0 / dimension_);
        return static_cast<std::uint64_t>(distance * distance);
    }

    /// The next candidates in the order of their cells, as far as caches need it.
    std::vector<Placed> next_candidates(std::size_t count) const
    {
        const TorusCells& cells = sorted_.cells();
        const std::size_t parts = std::min<std::size_t>(cells.count(), 4096);
        const auto part_of = [&](const TorusPosition& p) { return cells.number_of(p) * parts / cells.count(); };
        std::vector<std::size_t> places(parts + 1); // of the next candidate in each part
        Candidates candidate = next_;
        for (std::size_t i = 0; i < count; ++i, candidate.next()) ++places[part_of(candidate.position()) + 1];
        std::partial_sum(places.begin(), places.end(), places.begin());
        std::vector<Placed> placed(count);
        candidate = next_;
        for (std::uint32_t i = 0; i < count; ++i, candidate.next()) {
            const TorusPosition position = candidate.position();
            placed[places[part_of(position)]++] = {position, i};
        }
        return placed;
    }

    void look_up(std::size_t count)
    {
        const std::vector<Placed> candidates = next_candidates(count);
        nearest_.resize(count);
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 4096), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                nearest_[candidates[i].number] = sorted_.squared_nearest(candidates[i].position, useless_);
        });
    }

    /// Adds the points all of whose candidates were looked up. `points`: about how many these are.
    void choose(std::size_t points)
    {
        TorusGrid added(points, dimension_);
        for (std::size_t i = 0; i < nearest_.size() && points_.size() + added.size() < count_; ++i, next_.next()) {
            if (next_.is_first()) {
                first_ = next_;
                farthest_ = useless_;
            }
            if (nearest_[i] > farthest_) take_if_farther(added, next_.position(), nearest_[i]);
            if (!next_.is_last()) continue;
            if (farthest_ == useless_) choose_anew(added);
            added.add(best_);
        }
        for (std::size_t i = 0; i < added.size(); ++i) points_.push_back(added[i]);
    }

    /// A candidate whose squared distance to all points before the round is `nearest`.
    void take_if_farther(const TorusGrid& added, const TorusPosition& candidate, std::uint64_t nearest)
    {
        const std::uint64_t squared = added.squared_nearest_below(candidate, nearest);
        if (squared <= farthest_) return;
        best_ = candidate;
        farthest_ = squared;
    }

    /// Chooses among all candidates again, for a point that has useless ones only.
    void choose_anew(const TorusGrid& added)
    {
        best_ = first_.position();
        farthest_ = 0;
        for (Candidates candidate = first_;; candidate.next()) {
            const TorusPosition position = candidate.position();
            take_if_farther(added, position, sorted_.squared_nearest(position, farthest_));
            if (candidate.is_last()) return;
        }
    }

    Candidates next_;
    Candidates first_ = next_; ///< of the point whose candidates are looked at
    std::size_t count_;
    int dimension_;
    std::vector<TorusPosition> points_;  ///< before the round
    SortedTorus sorted_;                 ///< the same
    std::vector<std::uint64_t> nearest_; ///< squared distances from candidates to these, or anything that is useless
    std::uint64_t useless_ = 0;
    TorusPosition best_{};
    std::uint64_t farthest_ = 0; ///< the squared distance of the best one
};

class BestCandidateSampler final : public Sampler
{
public:
    BestCandidateSampler(const SampleRequest& request, std::int64_t candidates, bool grows)
        : request_(request), candidates_(static_cast<std::uint64_t>(candidates)), grows_(grows)
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const Candidates candidates(request_, candidates_, grows_, realization);
        return BestCandidates(candidates, request_.points, request_.dimension).run();
    }

private:
    SampleRequest request_;
    std::uint64_t candidates_;
    bool grows_;
};

}

SamplerSpec best_candidate_sampler()
{
    SamplerSpec spec =
        plain_spec("best-candidate", "Best candidate",
                   "each point is the candidate that is farthest from all points so far (Mitchell 1991)", {2, 3},
                   {{.key = "candidates",
                     .kind = ParameterSpec::Kind::integer,
                     .help = "candidates for a point or, if they grow, for each point that is there",
                     .minimum = 1,
                     .maximum = 1'000'000,
                     .symbol = "m",
                     .otherwise = std::int64_t{20}},
                    {.key = "grows",
                     .kind = ParameterSpec::Kind::boolean,
                     .help = "as many candidates for each point that is there, so that later points are as good",
                     .otherwise = false}});
    spec.create = [](const Parameters& parameters, const SampleRequest& request, Engine, const DeviceProvider&) {
        return std::make_unique<BestCandidateSampler>(request, parameters.integer("candidates"),
                                                      parameters.flag("grows"));
    };
    return spec;
}

}
