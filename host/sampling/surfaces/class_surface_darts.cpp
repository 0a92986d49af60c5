// The order of batches and refinements, which both engines share.
#include "host/sampling/surfaces/class_surface_darts.hpp"

#include "base/errors/errors.hpp"
#include "host/sampling/classes/class_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

namespace poissonlab {

using contract::class_surface::SurfaceSlot;
using contract::class_surface::TRIES;
using contract::surface::PIECE_OPEN;

namespace {

constexpr std::size_t least_slots = 16, first_slots = 64;

/// The part of the surface that a piece with a density has at most.
constexpr double least_dense_part = 0x1p-16;

/// Spreads bits, so that there are two between any two of them.
std::uint64_t spread_thrice(std::uint64_t x)
{
    for (const auto& [shift, mask] : {std::pair{32, 0x001F00000000FFFFull}, std::pair{16, 0x001F0000FF0000FFull},
                                      std::pair{8, 0x100F00F00F00F00Full}, std::pair{4, 0x10C30C30C30C30C3ull},
                                      std::pair{2, 0x1249249249249249ull}})
        x = (x | x << shift) & mask;
    return x;
}

/// The place of a piece's first corner in the order of cells, 2^21 along each axis.
std::uint64_t order_of(const FixedSurface& surface, const SurfacePiece& piece)
{
    const MeshPlace at = place_on(surface.triangles[piece.triangle], piece.shares[0], piece.shares[1]);
    std::uint64_t order = 0;
    for (std::size_t k = 0; k < 3; ++k)
        order |= spread_thrice(static_cast<std::uint64_t>(at[k]) >> (contract::surface::COORDINATE_BITS - 21)) << k;
    return order;
}

/// The place whose shares of a piece's corners are two thirds of corner i, and a sixth of each other one.
SurfacePoint inner_place(const FixedSurface& surface, const SurfacePiece& piece, std::size_t i)
{
    SurfacePoint at{};
    at.triangle = piece.triangle;
    for (std::size_t k = 0; k < 2; ++k) {
        std::uint64_t sum = 3 * std::uint64_t{piece.shares[2 * i + k]};
        for (std::size_t corner = 0; corner < 3; ++corner) sum += piece.shares[2 * corner + k];
        at.shares[k] = static_cast<std::uint32_t>(sum / 6);
    }
    const MeshPlace place = place_on(surface.triangles[at.triangle], at.shares[0], at.shares[1]);
    for (std::size_t k = 0; k < 3; ++k) at.place[k] = static_cast<std::int32_t>(place[k]);
    return at;
}

class ClassesOnSurface
{
public:
    ClassesOnSurface(const ClassSurfaceRequest& request, ClassSurfaceEngine& engine,
                     const std::function<void(std::size_t)>& on_points)
        : request_(request), engine_(engine), on_points_(on_points), order_(request.shares, request.points),
          open_(request.distances.classes())
    {
        made_.is_full.resize(open_.size());
    }

    ClassSurfaceDarts run()
    {
        restart(expected());
        start_anywhere();
        std::uint32_t skipped = 0;
        std::size_t wanted = first_slots;
        while (order_.next()) {
            const std::vector<SurfaceSlot> slots = next_slots(wanted);
            const std::size_t first = made_.points.size();
            if (first + slots.size() > capacity_) restart(first + slots.size() + capacity_ / 2);
            const ClassSurfaceEngine::Settled settled = engine_.settle(slots, first, skipped);
            for (std::size_t i = 0; i < settled.points.size(); ++i) {
                order_.add(slots[i].own);
                made_.points.push_back(settled.points[i]);
                made_.classes.push_back(slots[i].own);
            }
            if (on_points_) on_points_(made_.points.size());
            const bool has_stalled = settled.points.size() < slots.size();
            skipped = settled.points.empty() ? skipped : 0;
            if (has_stalled) skipped = refine(slots[settled.points.size()].own) ? skipped + TRIES : 0;
            // The number of slots of a batch changes nothing but time: those that meet each other are settled one by
            // one.
            const bool are_too_many = has_stalled || 4 * settled.redrawn > settled.points.size();
            wanted = are_too_many
                         ? std::max(least_slots, wanted / 2)
                         : std::clamp(made_.points.size() / 4, least_slots, std::min(2 * wanted, most_surface_slots));
        }
        for (std::uint32_t i = 0; i < open_.size(); ++i)
            made_.is_full[i] = order_.is_closed(i) && (!has_ends() || order_.counts()[i] < request_.points[i]);
        return std::move(made_);
    }

private:
    bool has_ends() const { return !request_.points.empty(); }

    /// The points of each class, about.
    std::vector<std::size_t> expected() const
    {
        if (has_ends()) return request_.points;
        std::vector<std::size_t> points;
        for (std::size_t i = 0; i < open_.size(); ++i)
            points.push_back(static_cast<std::size_t>(
                1.2 * saturated_count(request_.surface->area, made_.scale * request_.distances.at(i, i)) + 64));
        return points;
    }

    void restart(const std::vector<std::size_t>& points)
    {
        std::size_t capacity = most_surface_slots;
        for (const std::size_t count : points) capacity += count;
        restart(capacity);
    }

    void restart(std::size_t capacity)
    {
        capacity_ = capacity;
        engine_.restart(
            class_surface_rules(*request_.surface, request_.distances.scaled(made_.scale), request_.angle, expected()),
            made_, capacity_);
    }

    void start_anywhere()
    {
        const bool follows = !request_.densities.empty();
        const std::vector<SurfacePiece> all =
            follows ? small_pieces(*request_.surface) : whole_pieces(*request_.surface);
        for (std::size_t i = 0; i < open_.size(); ++i)
            if (!set_pieces(i, all)) throw InputError(fmt::format("the density of class {} is 0 everywhere", i));
    }

    /// Sets the pieces of a class. Returns whether there are any.
    bool set_pieces(std::size_t own, std::vector<SurfacePiece> pieces)
    {
        ClassPieces& open = open_[own];
        if (!request_.densities.empty() && !pieces.empty()) {
            WeightedPieces weighted = weighted_pieces(*request_.surface, pieces, request_.densities[own]);
            open.pieces = std::move(weighted.pieces);
            if (!open.pieces.empty()) open.choice = surface_piece_choice(weighted.weights);
            const std::size_t points = has_ends() ? request_.points[own] : 1;
            open.spread = 33 - static_cast<std::uint32_t>(std::bit_width(std::max<std::size_t>(1, points)));
        } else {
            open.pieces = std::move(pieces);
            if (!open.pieces.empty()) open.choice = surface_piece_choice(*request_.surface, open.pieces);
        }
        if (open.pieces.empty()) return false;
        engine_.set_pieces(open_, own);
        return true;
    }

    std::vector<SurfaceSlot> next_slots(std::size_t wanted) const
    {
        FillOrder order = order_;
        std::vector<SurfaceSlot> slots;
        for (auto next = order.next(); next && slots.size() < wanted; next = order.next()) {
            slots.push_back({*next, target_of(*next, order.counts()[*next], request_.stream)});
            order.add(*next);
        }
        return slots;
    }

    /// Returns whether there may still be room for the class.
    bool refine(std::uint32_t own)
    {
        RefinedPieces left = refined(*request_.surface, open_[own].pieces, engine_.cover(own));
        made_.small_area += left.small_area;
        const bool goes_on = set_pieces(own, std::move(left.pieces)) || shrink();
        if (!goes_on) order_.close(own);
        return goes_on;
    }

    /// Makes all distances smaller. Returns whether they may be.
    bool shrink()
    {
        if (!has_ends() || request_.factor >= 1) return false;
        made_.scale *= request_.factor;
        made_.small_area = 0;
        restart(capacity_);
        start_anywhere();
        return true;
    }

    const ClassSurfaceRequest& request_;
    ClassSurfaceEngine& engine_;
    const std::function<void(std::size_t)>& on_points_;
    FillOrder order_;
    std::size_t capacity_ = 0;
    std::vector<ClassPieces> open_;
    ClassSurfaceDarts made_;
};

}

std::vector<std::size_t> ClassSurfaceDarts::counts() const
{
    std::vector<std::size_t> counts(is_full.size());
    for (const std::uint32_t own : classes) ++counts[own];
    return counts;
}

std::vector<SurfacePoint> ClassSurfaceDarts::of_class(std::uint32_t wanted) const
{
    std::vector<SurfacePoint> some;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (classes[i] == wanted) some.push_back(points[i]);
    return some;
}

std::vector<SurfacePiece> small_pieces(const FixedSurface& surface)
{
    std::vector<SurfacePiece> small, large = whole_pieces(surface);
    while (!large.empty()) {
        std::vector<SurfacePiece> larger;
        for (const SurfacePiece& piece : large)
            (area_of(surface, piece) > least_dense_part * surface.area && !is_last(piece) ? larger : small)
                .push_back(piece);
        large = refined(surface, larger, std::vector<std::uint32_t>(larger.size(), PIECE_OPEN)).pieces;
    }
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    for (std::size_t i = 0; i < small.size(); ++i) order.emplace_back(order_of(surface, small[i]), i);
    std::ranges::sort(order);
    std::vector<SurfacePiece> pieces;
    for (const auto& [key, i] : order) pieces.push_back(small[i]);
    return pieces;
}

WeightedPieces weighted_pieces(const FixedSurface& surface, const std::vector<SurfacePiece>& pieces,
                               const SurfaceWeight& density)
{
    std::vector<double> means;
    double largest = 0, sum = 0, area = 0;
    for (const SurfacePiece& piece : pieces) {
        double mean = 0;
        for (std::size_t i = 0; i < 3; ++i) mean += density(inner_place(surface, piece, i)) / 3;
        means.push_back(mean);
        largest = std::max(largest, mean);
    }
    WeightedPieces weighted;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double own = area_of(surface, pieces[i]);
        area += own;
        if (!(means[i] > 0)) continue;
        weighted.pieces.push_back(pieces[i]);
        weighted.weights.push_back(own * (means[i] / largest));
        sum += weighted.weights.back();
    }
    weighted.fullness = area > 0 ? sum / area : 0;
    return weighted;
}

ClassSurfaceRules class_surface_rules(const FixedSurface& surface, const ClassDistances& distances, double angle,
                                      const std::vector<std::size_t>& points)
{
    const std::size_t classes = distances.classes();
    ClassSurfaceRules rules;
    std::vector<std::uint32_t> cells(classes), firsts(classes);
    std::uint32_t buckets = 0;
    for (std::size_t i = 0; i < classes; ++i) {
        firsts[i] = buckets;
        buckets += static_cast<std::uint32_t>(surface_bucket_count(points[i]));
        for (std::size_t j = 0; j < classes; ++j) {
            if (distances.at(i, j) < least_part_of_size * surface.size)
                throw InputError(
                    fmt::format("a distance of {:.4g} is too small for a mesh of this size: at least {:.4g}",
                                distances.at(i, j), least_part_of_size * surface.size));
            rules.push_back(surface_rule(surface, distances.at(i, j), angle));
            cells[j] = std::max(cells[j], rules.back().cell);
        }
    }
    for (std::size_t i = 0; i < classes; ++i)
        for (std::size_t j = 0; j < classes; ++j) {
            contract::surface::SurfaceRule& rule = rules[i * classes + j];
            rule.cell = cells[j];
            rule.bucket_mask = static_cast<std::uint32_t>(surface_bucket_count(points[j]) - 1);
            rule.first = firsts[j];
        }
    return rules;
}

ClassSurfaceDarts throw_class_surface_darts(const ClassSurfaceRequest& request, ClassSurfaceEngine& engine,
                                            const std::function<void(std::size_t points)>& on_points)
{
    return ClassesOnSurface(request, engine, on_points).run();
}

}
