// The order of batches, refinements and distances, which both engines share.
#include "host/sampling/surfaces/surface_darts.hpp"

#include "base/errors/errors.hpp"
#include "base/geometry/relative_radius.hpp"
#include "base/geometry/torus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace poissonlab {
namespace {

constexpr std::size_t least_surface_batch = 256, most_surface_batch = std::size_t{1} << 19;

/// Pieces are refined where fewer than one in so many darts is accepted.
constexpr std::size_t worthwhile_darts = 4;

class ThrowingOnSurface
{
public:
    ThrowingOnSurface(const SurfaceDartRequest& request, SurfaceDartEngine& engine, std::size_t most,
                      const std::function<void(std::size_t)>& on_points)
        : request_(request), engine_(engine), most_(most), on_points_(on_points)
    {
        result_.min_distance = request.min_distance;
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

    std::size_t expected_points() const
    {
        if (request_.points > 0) return request_.points;
        return static_cast<std::size_t>(1.2 * saturated_count(request_.surface->area, result_.min_distance)) +
               least_surface_batch;
    }

    void restart(std::size_t capacity)
    {
        if (result_.min_distance < least_part_of_size * request_.surface->size)
            throw InputError(fmt::format("the distance is too small for a mesh of this size: at least {:.4g}",
                                         least_part_of_size * request_.surface->size));
        capacity_ = std::max(capacity, result_.points.size());
        engine_.restart(surface_rule(*request_.surface, result_.min_distance, request_.angle), result_.points,
                        capacity_);
    }

    void set_pieces(std::vector<SurfacePiece> pieces)
    {
        pieces_ = std::move(pieces);
        if (!pieces_.empty()) engine_.set_pieces(pieces_, surface_piece_choice(*request_.surface, pieces_));
    }

    /// Throws darts until there are enough points, or no piece is left.
    void fill()
    {
        while (!pieces_.empty() && !is_full()) {
            const std::size_t darts = std::clamp(std::max(result_.points.size() / 2, pieces_.size() / 4),
                                                 least_surface_batch, most_surface_batch);
            if (throw_batch(darts) * worthwhile_darts >= darts) continue;
            RefinedPieces left = refined(*request_.surface, pieces_, engine_.cover());
            result_.small_area += left.small_area;
            set_pieces(std::move(left.pieces));
        }
    }

    std::size_t throw_batch(std::size_t darts)
    {
        const std::size_t wanted = request_.points > 0 ? request_.points : most_ + 1;
        const std::size_t room = std::min(darts, wanted - result_.points.size());
        if (result_.points.size() + room > capacity_) restart(result_.points.size() + room + capacity_ / 2);
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
    SurfaceDarts result_;
};

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
            .unused = 0};
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
