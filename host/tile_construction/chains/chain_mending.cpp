#include "host/tile_construction/chains/chain_mending.hpp"

#include "tiles/poisson/chain_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace poissonlab {
namespace {

constexpr int max_passes = 400;

using Position = std::array<double, 2>;

Position position_of(const UnitPosition& point)
{
    return {static_cast<double>(point[0]), static_cast<double>(point[1])};
}

std::int32_t even(double x) { return 2 * static_cast<std::int32_t>(std::nearbyint(x / 2)); }

class Mending
{
public:
    Mending(const LooseChain& chain, std::int64_t squared_distance)
        : chain_(chain), squared_distance_(squared_distance),
          distance_(std::sqrt(static_cast<double>(squared_distance)))
    {
        points_.push_back(position_of(chain.ends[0]));
        points_.insert(points_.end(), chain.points.begin(), chain.points.end());
        points_.push_back(position_of(chain.ends[1]));
    }

    std::optional<Chain> run()
    {
        for (int pass = 0; pass < max_passes; ++pass) {
            Chain chain = rounded();
            if (is_sound(chain)) return chain;
            step();
        }
        return {};
    }

private:
    std::size_t last() const { return points_.size() - 1; }

    Chain rounded() const
    {
        Chain chain;
        for (std::size_t i = 1; i < last(); ++i) chain.push_back({even(points_[i][0]), even(points_[i][1]), 0});
        return chain;
    }

    bool is_sound(const Chain& chain) const
    {
        std::vector<UnitPosition> all{chain_.ends[0]};
        all.insert(all.end(), chain.begin(), chain.end());
        all.push_back(chain_.ends[1]);
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t j = i + 1; j < all.size(); ++j)
                if (squared_length(all[i], all[j]) < squared_distance_) return false;
            if (i > 0 && !is_short_link(squared_length(all[i - 1], all[i]), squared_distance_)) return false;
        }
        return std::ranges::all_of(chain, [&](const UnitPosition& point) {
            return is_in_cone(point, chain_.ends[0], chain_.direction, 1, squared_distance_) &&
                   is_in_cone(point, chain_.ends[1], chain_.direction, -1, squared_distance_) &&
                   is_near_edge(point, chain_.direction, squared_distance_);
        });
    }

    /// All movements at once.
    void step()
    {
        moves_.assign(points_.size(), {0, 0});
        for (std::size_t i = 0; i < last(); ++i)
            for (std::size_t j = i + 1; j <= last(); ++j) {
                keep_length(i, j, distance_ + chain_rounding, true);
                if (j == i + 1) keep_length(i, j, std::sqrt(3.0) * distance_ - chain_rounding, false);
            }
        for (std::size_t i = 1; i < last(); ++i) {
            push_into_cone(i, points_.front(), 1);
            push_into_cone(i, points_.back(), -1);
            push_to_edge(i);
        }
        for (std::size_t i = 1; i < last(); ++i)
            for (std::size_t k = 0; k < 2; ++k) points_[i][k] += moves_[i][k];
    }

    bool is_end(std::size_t i) const { return i == 0 || i == last(); }

    /// Moves two points apart to at least (or together to at most) this length, half each, or one all of it.
    void keep_length(std::size_t i, std::size_t j, double wanted, bool is_least)
    {
        const Position difference{points_[j][0] - points_[i][0], points_[j][1] - points_[i][1]};
        const double length = std::hypot(difference[0], difference[1]);
        if (length == 0 || (is_least ? length >= wanted : length <= wanted)) return;
        const double part = (wanted - length) / length * (is_end(i) || is_end(j) ? 1 : 0.5);
        for (std::size_t k = 0; k < 2; ++k) {
            if (!is_end(i)) moves_[i][k] -= part * difference[k];
            if (!is_end(j)) moves_[j][k] += part * difference[k];
        }
    }

    void push_into_cone(std::size_t i, const Position& corner, int outward)
    {
        const std::size_t d = chain_.direction;
        const double along = outward * (points_[i][d] - corner[d]), across = points_[i][1 - d] - corner[1 - d];
        const double lacking =
            (distance_ / 2 + chain_rounding - (along - std::abs(across)) / std::sqrt(2.0)) / std::sqrt(2.0);
        if (lacking <= 0) return;
        moves_[i][d] += outward * lacking;
        moves_[i][1 - d] -= across > 0 ? lacking : -lacking;
    }

    void push_to_edge(std::size_t i)
    {
        const double across = points_[i][1 - chain_.direction];
        const double beyond = std::abs(across) - (tile_units - distance_) / 2 + chain_rounding;
        if (beyond > 0) moves_[i][1 - chain_.direction] -= across > 0 ? beyond : -beyond;
    }

    const LooseChain& chain_;
    std::int64_t squared_distance_;
    double distance_;
    std::vector<Position> points_, moves_;
};

}

std::optional<Chain> mended(const LooseChain& chain, std::int64_t squared_distance)
{
    return Mending(chain, squared_distance).run();
}

}
