// The order of batches, refinements and distances, which both engines share.
#include "host/sampling/surfaces/surface_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::size_t least_surface_batch = 256, most_surface_batch = std::size_t{1} << 19;

/// Pieces are refined where fewer than one in so many darts is accepted.
constexpr std::size_t worthwhile_darts = 16;
constexpr std::size_t growth_of_batches = 4;

/// Refining pieces takes as long as so many darts for each point.
constexpr double dear_darts = 4;

/// Pieces are not refined without further darts where there are more than so many for each point.
constexpr std::size_t many_pieces = 4;

class ThrowingOnSurface
{
public:
    ThrowingOnSurface(const SurfaceDartRequest& request, SurfaceDartEngine& engine, std::size_t most,
                      const std::function<void(std::size_t)>& on_points)
        : request_(request), engine_(engine), most_(most), on_points_(on_points)
    {
        result_.min_distance = request.min_distance;
        result_.points = request.start;
    }

    SurfaceDarts run()
    {
        for (;;) {
            result_.small_area = 0;
            restart(expected_points());
            set_pieces(whole_pieces(*request_.surface));
            fill();
            if (is_full() || request_.shrinking == 1) break;
            result_.min_distance *= request_.shrinking;
        }
        result_.is_saturated = pieces_.empty();
        return std::move(result_);
    }

private:
    bool is_full() const { return request_.points > 0 && result_.points.size() >= request_.points; }

    /// Returns the points that the engine has.
    std::size_t held() const { return request_.obstacles.size() + result_.points.size(); }

    std::size_t expected_points() const
    {
        if (request_.points > 0) return request_.points + request_.obstacles.size();
        return request_.obstacles.size() + request_.start.size() +
               static_cast<std::size_t>(1.2 * saturated_count(request_.surface->area, result_.min_distance)) +
               least_surface_batch;
    }

    void restart(std::size_t capacity)
    {
        if (result_.min_distance < least_part_of_size * request_.surface->size)
            throw InputError(fmt::format("the distance is too small for a mesh of this size: at least {:.4g}",
                                         least_part_of_size * request_.surface->size));
        capacity_ = std::max(capacity, held());
        std::vector<SurfacePoint> all = request_.obstacles;
        all.insert(all.end(), result_.points.begin(), result_.points.end());
        engine_.restart(surface_rule(*request_.surface, result_.min_distance, request_.angle), all, capacity_);
    }

    void set_pieces(std::vector<SurfacePiece> pieces)
    {
        pieces_ = std::move(pieces);
        has_choice_ = false;
        if (!pieces_.empty()) engine_.set_pieces(pieces_);
    }

    double area_of_pieces() const { return area_of(*request_.surface, pieces_); }

    /// Throws darts until there are enough points, or no piece is left.
    void fill()
    {
        bool is_refined = false;
        double poor = 0; // darts of which few were accepted, since pieces were refined
        for (std::size_t darts = least_surface_batch; !pieces_.empty() && !is_full();) {
            if (request_.points > 0)
                darts = std::min(
                    darts, std::max(least_surface_batch, worthwhile_darts * (request_.points - result_.points.size())));
            const std::size_t accepted = throw_batch(darts), grown = growth_of_batches * darts;
            if (accepted * worthwhile_darts < darts) {
                const double uncovered = static_cast<double>(accepted + 1) / static_cast<double>(darts);
                poor += static_cast<double>(darts);
                if (poor + expected_darts(uncovered) > dear_darts * static_cast<double>(capacity_)) {
                    refine(uncovered);
                    is_refined = true;
                    poor = 0;
                }
            }
            const std::size_t most = std::max(is_refined ? 0 : result_.points.size() / 2, pieces_.size() / 4);
            darts = std::min(grown, std::clamp(most, least_surface_batch, most_surface_batch));
        }
    }

    /// The darts that are left to throw where such a part of them is accepted.
    double expected_darts(double accepted) const
    {
        if (request_.points == 0) return INFINITY;
        return static_cast<double>(request_.points - std::min(request_.points, result_.points.size())) / accepted;
    }

    /// Refines pieces until darts are worthwhile, where `uncovered` of their area is uncovered now.
    void refine(double uncovered)
    {
        const double enough = worthwhile_darts * uncovered * area_of_pieces();
        bool is_finer = true;
        do {
            RefinedPieces left = refined(*request_.surface, pieces_, engine_.cover(), std::move(spare_));
            spare_ = std::move(pieces_);
            result_.small_area += left.small_area;
            is_finer = left.is_finer;
            set_pieces(std::move(left.pieces));
        } while (is_finer && !pieces_.empty() && pieces_.size() < many_pieces * capacity_ && area_of_pieces() > enough);
    }

    std::size_t throw_batch(std::size_t darts)
    {
        const std::size_t wanted = request_.points > 0 ? request_.points : most_ + 1;
        const std::size_t room = std::min(darts, wanted - result_.points.size());
        if (!has_choice_) engine_.set_choice(surface_piece_choice(*request_.surface, pieces_));
        has_choice_ = true;
        if (held() + room > capacity_) restart(held() + room + capacity_ / 2);
        const auto accepted = engine_.throw_darts(result_.darts, static_cast<std::uint32_t>(darts), room);
        result_.darts += darts;
        result_.points.insert(result_.points.end(), accepted.begin(), accepted.end());
        if (result_.points.size() > most_)
            throw InputError(fmt::format("the surface has room for more than {} points", most_));
        if (on_points_) on_points_(result_.points.size());
        return accepted.size();
    }

    const SurfaceDartRequest& request_;
    SurfaceDartEngine& engine_;
    std::size_t most_;
    const std::function<void(std::size_t)>& on_points_;
    std::size_t capacity_ = 0;
    std::vector<SurfacePiece> pieces_;
    std::vector<SurfacePiece> spare_; ///< memory for the next pieces: first touches of it take long
    bool has_choice_ = false;         ///< the engine has that of the pieces
    SurfaceDarts result_;
};

}

SurfaceBucketOrder surface_bucket_order(const std::vector<SurfacePoint>& points, std::uint32_t cell, std::uint32_t mask)
{
    SurfaceBucketOrder order{std::vector<std::uint32_t>(points.size()),
                             std::vector<std::uint32_t>(std::size_t{mask} + 2)};
    for (const SurfacePoint& p : points) ++order.starts[surface_bucket(p, cell, mask) + 1];
    std::partial_sum(order.starts.begin(), order.starts.end(), order.starts.begin());
    std::vector<std::uint32_t> next(order.starts.begin(), order.starts.end() - 1);
    for (std::uint32_t i = 0; i < points.size(); ++i) order.ids[next[surface_bucket(points[i], cell, mask)]++] = i;
    return order;
}

contract::surface::SurfaceRule surface_rule(const FixedSurface& surface, double min_distance, double angle)
{
    const double units = surface.units_of(min_distance);
    const auto sure = static_cast<std::uint64_t>(std::floor(units)) - contract::surface::SLACK;
    return {.squared = squared_threshold(units * 0x1p-32),
            .covered = sure * sure,
            .least_cosine = least_cosine(angle),
            .cell = static_cast<std::uint32_t>(std::floor(2 * units)) + 2,
            .bucket_mask = 0,
            .first = 0};
}

SurfaceDarts throw_surface_darts(const SurfaceDartRequest& request, SurfaceDartEngine& engine, std::size_t most,
                                 const std::function<void(std::size_t points)>& on_points)
{
    return ThrowingOnSurface(request, engine, most, on_points).run();
}

double saturated_count(double area, double min_distance)
{
    return saturation_covered_fraction(2) * area / (std::numbers::pi / 4 * min_distance * min_distance);
}

}
