#include "host/texture/joint/joint_patches.hpp"

#include "base/random/random.hpp"
#include "host/texture/joint/window_search.hpp"
#include "host/texture/regular/regular_waves.hpp"
#include "host/texture/salience.hpp"
#include "tiles/texture/texture_set.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

/// Within so many pixels along an axis there are `needed` places, one after another, of each phase of all waves.
int room_for_phases(const std::vector<RegularWave>& waves, std::size_t needed)
{
    double longest = 0;
    for (const RegularWave& wave : waves) longest = std::max(longest, 1 / std::max(std::abs(wave.x), std::abs(wave.y)));
    return static_cast<int>(std::ceil(longest * static_cast<double>(needed)));
}

/// The largest smaller tiles that waves fit and of which a picture has enough windows; 0 where there are none.
int largest_size(const PngPixels& exemplar, const std::vector<RegularWave>& waves, int size, std::size_t needed)
{
    const int room = std::min(exemplar.width, exemplar.height) - room_for_phases(waves, needed);
    for (int smaller = std::min(size - 2, room / 2 * 2); smaller >= least_tile_pixels; smaller -= 2)
        if (std::ranges::all_of(waves, [&](const RegularWave& wave) { return fits_tiles(wave, smaller); }))
            return smaller;
    return 0;
}

/// A line for a picture of which so few windows of T x T pixels lie alike in its waves that `needed` corners have no
/// different ones, with the largest tiles of which it has enough, if there are any, and the pictures that have enough
/// for T.
std::string phase_note(const PngPixels& exemplar, const std::vector<RegularWave>& waves, int size, std::size_t needed)
{
    std::string periods = fmt::format("{:.1f}", waves.front().period());
    if (waves.size() > 1) periods += fmt::format(" and {:.1f}", waves.back().period());
    const int side = size + room_for_phases(waves, needed), smaller = largest_size(exemplar, waves, size, needed);
    return fmt::format(
        "the picture repeats every {} pixels, but too little of its {} x {} is beside a tile of {} for {} "
        "windows that lie alike in that: joints do not run through; they do with a picture of {} x {}{}",
        periods, exemplar.width, exemplar.height, size, needed, side, side,
        smaller > 0 ? fmt::format(", or with --size {}", smaller) : "");
}

/// Patches that are drawn, and those that look like one of them, which are looked at as well: what has structure fits
/// better to the same structure.
constexpr int drawn_patches = 24, alike_patches = 2;

/// Numbers of pairs of patches.
class PairTable
{
public:
    explicit PairTable(std::size_t count) : count_(count), values_(count * count) {}

    double& at(std::size_t first, std::size_t second) { return values_[first * count_ + second]; }
    double at(std::size_t first, std::size_t second) const { return values_[first * count_ + second]; }

private:
    std::size_t count_;
    std::vector<double> values_;
};

/// Half of the side of the square around a corner in which tiles show its patch more than others.
int shown_reach(const TextureRequest& request) { return std::max(2, request.size / 5); }

/// Windows that stand out little, and for each some that look alike, all as the rule has it.
std::vector<ExemplarWindow> patch_pool(const PngPixels& exemplar, const PngPixels& features,
                                       const TextureRequest& request, int distance, const PhaseRule& rule)
{
    const Salience salience(exemplar, {0, exemplar.width}, request.size, shown_reach(request));
    RandomWords words(stream_key(request.seed, Purpose::texture_windows, 4), 0);
    const UsedWindows none(0);
    std::vector<ExemplarWindow> pool;
    for (int i = 0; i < drawn_patches; ++i) {
        const ExemplarWindow drawn = plain_window(none, exemplar, {0, exemplar.width}, salience, request.size, words);
        const ExemplarWindow near = rule.nearest(drawn, exemplar, 0, 0);
        if (rule.holds(near, 0, 0)) pool.push_back(near);
    }
    if (pool.empty()) return pool;
    const WindowSearch search(features, request.size);
    std::vector<std::vector<ExemplarWindow>> alike(pool.size());
    tbb::parallel_for(std::size_t{0}, pool.size(), [&](std::size_t i) {
        UsedWindows used(distance);
        used.add(pool[i]);
        alike[i] = search.best(window_pixels(features, pool[i]), used, {}, alike_patches, window_test(rule, 0, 0));
    });
    for (const std::vector<ExemplarWindow>& windows : alike) pool.insert(pool.end(), windows.begin(), windows.end());
    return pool;
}

/// The part of a piece around the middle of an edge that goes on with the patch at one end: the half towards it, but
/// for the eighth next to the middle.
PieceMask half_mask(int width, int height, bool is_along_x, bool is_first)
{
    PieceMask mask{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int along = is_along_x ? x : y, length = is_along_x ? width : height;
            mask.counts.push_back(is_first ? along < length * 3 / 8 : along >= length - length * 3 / 8);
        }
    return mask;
}

/// The costs of pieces around edges, T x T/2 pixels at a quarter of the resolution, beside patches of a pool.
class EdgeFit
{
public:
    EdgeFit(const PngPixels& features, const std::vector<ExemplarWindow>& pool)
        : coarse_(halved(halved(features))), side_(pool[0].size / 4), pool_(pool)
    {}

    /// The least sum of squares, for a pair of patches at the ends of a vertical or horizontal edge, in parts of the
    /// number of values that are compared.
    PairTable costs(bool is_horizontal) const
    {
        const int width = is_horizontal ? side_ : side_ / 2, height = is_horizontal ? side_ / 2 : side_;
        std::array<std::vector<SquareSums>, 2> maps;
        double values = 0;
        for (const bool is_first : {true, false}) {
            const PieceMask mask = half_mask(width, height, is_horizontal, is_first);
            values += static_cast<double>(std::ranges::count(mask.counts, 1) * coarse_.channels);
            const MaskedSquares squares(coarse_, mask);
            std::vector<SquareSums>& its = maps[is_first ? 0 : 1];
            its.resize(pool_.size());
            tbb::parallel_for(std::size_t{0}, pool_.size(), [&](std::size_t i) {
                its[i] = squares.sums(beside(pool_[i], width, height, is_horizontal, is_first));
            });
        }
        PairTable table(pool_.size());
        tbb::parallel_for(std::size_t{0}, pool_.size(), [&](std::size_t i) {
            for (std::size_t j = 0; j < pool_.size(); ++j)
                table.at(i, j) = static_cast<double>(least_sum(maps[0][i].sums, maps[1][j].sums)) / values;
        });
        return table;
    }

private:
    static std::uint64_t least_sum(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b)
    {
        std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
        for (std::size_t i = 0; i < a.size(); ++i) least = std::min(least, a[i] + b[i]);
        return least;
    }

    /// A picture of a piece's size that shows the patch of its first or last end where it lies.
    PngPixels beside(const ExemplarWindow& patch, int width, int height, bool is_horizontal, bool is_first) const
    {
        // The middle of the patch is an end of the piece's middle line.
        const int middle_x = (patch.x + patch.size / 2) / 4, middle_y = (patch.y + patch.size / 2) / 4;
        const int left = is_horizontal ? (is_first ? 0 : -width) : -width / 2;
        const int top = is_horizontal ? -height / 2 : (is_first ? 0 : -height);
        PngPixels picture{width, height, coarse_.channels, {}};
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < coarse_.channels; ++c)
                    picture.values.push_back(
                        coarse_.values[coarse_.at(std::clamp(middle_x + left + x, 0, coarse_.width - 1),
                                                  std::clamp(middle_y + top + y, 0, coarse_.height - 1), c)]);
        return picture;
    }

    PngPixels coarse_;
    int side_;
    const std::vector<ExemplarWindow>& pool_;
};

/// The products of the middles' differences from the exemplar's means, means over their values.
PairTable common_power(const PngPixels& exemplar, const PhaseMeans& means, const std::vector<ExemplarWindow>& pool,
                       int reach)
{
    std::vector<std::vector<double>> middles(pool.size());
    for (std::size_t i = 0; i < pool.size(); ++i)
        for (int y = pool[i].y + pool[i].size / 2 - reach; y < pool[i].y + pool[i].size / 2 + reach; ++y)
            for (int x = pool[i].x + pool[i].size / 2 - reach; x < pool[i].x + pool[i].size / 2 + reach; ++x)
                for (int c = 0; c < exemplar.channels; ++c)
                    middles[i].push_back(exemplar.values[exemplar.at(x, y, c)] - means.at(x, y, c));
    PairTable table(pool.size());
    for (std::size_t i = 0; i < pool.size(); ++i)
        for (std::size_t j = 0; j < pool.size(); ++j) {
            double sum = 0;
            for (std::size_t k = 0; k < middles[i].size(); ++k) sum += middles[i][k] * middles[j][k];
            table.at(i, j) = sum / static_cast<double>(middles[i].size());
        }
    return table;
}

/// Which patches of a pool are taken together: costs of all ordered pairs are added up.
class PatchSet
{
public:
    PatchSet(const std::vector<ExemplarWindow>& pool, const PairTable& costs, std::size_t count, int distance)
        : pool_(pool), costs_(costs), count_(count), distance_(distance)
    {}

    /// Sets that begin with each patch, grow by the best one each and are improved one by one: the best of them.
    std::vector<std::size_t> best() const
    {
        std::vector<std::size_t> best;
        double least = std::numeric_limits<double>::max();
        for (std::size_t first = 0; first < pool_.size(); ++first) {
            std::vector<std::size_t> chosen{first};
            while (chosen.size() < count_) {
                const auto next = best_beside(chosen);
                if (next == pool_.size()) break;
                chosen.push_back(next);
            }
            if (chosen.size() < count_) continue;
            improve(chosen);
            if (const double its = cost(chosen); its < least) {
                least = its;
                best = chosen;
            }
        }
        return best;
    }

private:
    double cost(const std::vector<std::size_t>& chosen) const
    {
        double sum = 0;
        for (const std::size_t a : chosen)
            for (const std::size_t b : chosen) sum += costs_.at(a, b);
        return sum;
    }

    /// The patch that costs least with those that are there, and is far enough from them; the pool's size: none is.
    std::size_t best_beside(const std::vector<std::size_t>& chosen) const
    {
        UsedWindows used(distance_);
        for (const std::size_t i : chosen) used.add(pool_[i]);
        std::size_t best = pool_.size();
        double least = std::numeric_limits<double>::max();
        for (std::size_t i = 0; i < pool_.size(); ++i) {
            if (!used.is_free(pool_[i])) continue;
            double its = costs_.at(i, i);
            for (const std::size_t other : chosen) its += costs_.at(i, other) + costs_.at(other, i);
            if (its >= least) continue;
            least = its;
            best = i;
        }
        return best;
    }

    void improve(std::vector<std::size_t>& chosen) const
    {
        for (bool is_better = true; is_better;) {
            is_better = false;
            for (std::size_t k = 0; k < chosen.size(); ++k) {
                std::vector<std::size_t> others = chosen;
                others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
                const std::size_t other = best_beside(others);
                if (other == pool_.size()) continue;
                others.insert(others.begin() + static_cast<std::ptrdiff_t>(k), other);
                if (cost(others) >= cost(chosen)) continue;
                chosen = others;
                is_better = true;
            }
        }
    }

    const std::vector<ExemplarWindow>& pool_;
    const PairTable& costs_;
    std::size_t count_;
    int distance_;
};

/// Returns the costs of all ordered pairs of patches: the pieces around both kinds of edges, and their common power.
PairTable pair_costs(const PngPixels& exemplar, const PngPixels& features, const std::vector<ExemplarWindow>& pool,
                     int reach, const std::vector<RegularWave>& waves)
{
    const EdgeFit fit(features, pool);
    PairTable costs = fit.costs(true);
    const PairTable vertical = fit.costs(false),
                    power = common_power(exemplar, PhaseMeans(exemplar, waves), pool, reach);
    for (std::size_t i = 0; i < pool.size(); ++i)
        for (std::size_t j = 0; j < pool.size(); ++j) costs.at(i, j) += vertical.at(i, j) + power.at(i, j);
    return costs;
}

}

JointPatches joint_patches(const PngPixels& exemplar, const PngPixels& features, const TextureRequest& request,
                           const SetParts& parts, int distance, const std::vector<RegularWave>& waves)
{
    JointPatches joint{{}, PhaseRule(exemplar, waves, request.size), ""};
    const std::vector<ExemplarWindow> pool = patch_pool(exemplar, features, request, distance, joint.rule);
    std::vector<std::size_t> best;
    if (!pool.empty()) {
        const PairTable costs = pair_costs(exemplar, features, pool, shown_reach(request), waves);
        best = PatchSet(pool, costs, parts.corners, distance).best();
        if (best.empty() && !waves.empty()) best = PatchSet(pool, costs, parts.corners, 1).best();
    }
    for (const std::size_t i : best) joint.patches.push_back(pool[i]);
    if (!best.empty()) return joint;
    // Where the pool has no set that is far enough apart, patches are those that are chosen for themselves.
    return {chosen_patches(exemplar, request, distance),
            {},
            waves.empty() ? "" : phase_note(exemplar, waves, request.size, parts.corners)};
}

}
