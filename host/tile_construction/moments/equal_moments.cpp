#include "host/tile_construction/moments/equal_moments.hpp"

#include "base/errors/errors.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>

namespace poissonlab {
namespace {

/// Steps of nulling when moments are near: bringing them there moves points, and the mean tile with them. With fewer,
/// peaks beyond the first ring are higher than without equal moments; with more, the power between the peaks is.
constexpr std::uint32_t nulling_steps = 9;

class MomentMaking
{
public:
    using Tiles = EvenableTiles::Tiles;

    MomentMaking(const EvenableTiles& tiles, const std::function<void(std::size_t, std::size_t)>& progress)
        : tiles_(tiles), progress_(progress)
    {}

    /// Gives tiles the mean moments up to an order: nearly, then, while peaks are nulled, exactly. Returns those that
    /// cannot have them.
    Tiles without(const Tiles& all, std::uint32_t order, bool nulls_peaks) const
    {
        const MomentTargets targets(tiles_.set(), order);
        std::uint32_t round = 0;
        Tiles open = tiles_.settle(targets, all);
        for (; round < tiles_.rounds && !open.empty(); ++round) {
            open = tiles_.settle_anew(targets, open, round);
            if (progress_) progress_(all.size() - open.size(), all.size());
        }
        if (!open.empty()) return open;
        if (nulls_peaks) null_again(targets, all);
        open = inexact(targets, all, {});
        for (; round < tiles_.rounds && !open.empty(); ++round)
            open = inexact(targets, open, tiles_.settle_anew(targets, open, round));
        return open;
    }

private:
    /// Steps of nulling that leave moments near. Tiles that one does not suit stay as they are.
    void null_again(const MomentTargets& targets, const Tiles& all) const
    {
        for (std::uint32_t i = 0; i < nulling_steps; ++i) {
            const auto before = tiles_.insides;
            tiles_.null_peaks();
            for (const std::uint32_t tile : tiles_.settle(targets, all)) tiles_.insides[tile] = before[tile];
        }
    }

    /// Makes moments exact in tiles that did not fail. Returns the others, and those where it cannot be done.
    Tiles inexact(const MomentTargets& targets, const Tiles& all, const Tiles& failed) const
    {
        std::vector<char> is_good(all.size());
        tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
            is_good[i] = !std::ranges::binary_search(failed, all[i]) && tiles_.make_exact(targets, all[i]);
        });
        Tiles left;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (!is_good[i]) left.push_back(all[i]);
        return left;
    }

    const EvenableTiles& tiles_;
    const std::function<void(std::size_t, std::size_t)>& progress_;
};

}

void make_moments_equal(const PoissonTileParameters& p, const EvenableTiles& tiles,
                        const std::function<void(std::size_t, std::size_t)>& progress)
{
    const MomentMaking making(tiles, progress);
    EvenableTiles::Tiles all(p.tiles);
    std::iota(all.begin(), all.end(), 0u);
    EvenableTiles::Tiles failed;
    do {
        failed = making.without(all, p.equal_moments, p.null_peaks && tiles.null_peaks);
        if (failed.empty()) return;
    } while (tiles.give_way(failed));
    std::uint32_t most = p.equal_moments - 1;
    while (most > 0 && !making.without(failed, most, false).empty()) --most;
    // Tiles that fail at an order between may have it where all of them are made for it from the beginning.
    const std::string allowed = most + 1 == p.equal_moments
                                    ? fmt::format("must be at most {}", most)
                                    : fmt::format("must be less than {}, where {} can be had,", p.equal_moments, most);
    throw invalid_value(
        {}, "equal_moments", fmt::format("{}", p.equal_moments),
        fmt::format("{} with these parameters: {} of {} tiles cannot have equal moments up to this order", allowed,
                    failed.size(), p.tiles));
}

}
