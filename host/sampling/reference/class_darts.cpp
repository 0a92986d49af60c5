// Dart throwing with classes, plain and sequential: what the kernels must reproduce.
#include "host/sampling/classes/class_darts.hpp"

#include "base/geometry/torus.hpp"
#include "host/sampling/classes/class_cells.hpp"

#include <algorithm>

namespace poissonlab::reference {
namespace {

using contract::class_darts::ClassGrid;
using contract::class_darts::ClassPair;

/// Coordinates low, low + 1, ..., low + extent along each axis.
template <int D>
struct ClassBox
{
    TorusPoint<D> low;
    std::uint32_t extent;
};

/// The squared distance from a point to the farthest point of a box.
template <int D>
std::uint64_t squared_farthest_of(const TorusPoint<D>& point, const ClassBox<D>& box)
{
    std::uint64_t sum = 0;
    for (int k = 0; k < D; ++k) {
        const std::uint32_t forward = point[k] - box.low[k], beyond = forward - box.extent;
        const bool has_antipode = (forward ^ 0x80000000u) <= box.extent;
        const std::uint64_t farthest =
            has_antipode ? 0x80000000u : std::max(std::min(forward, 0u - forward), std::min(beyond, 0u - beyond));
        sum += farthest * farthest;
    }
    return sum;
}

template <int D>
class ThrowingInSlots
{
public:
    explicit ThrowingInSlots(const ClassDartRequest& request)
        : request_(request), order_({}, {}), distances_(request.distances),
          pairs_(class_pairs(distances_, request.shares)), open_(request.distances.classes())
    {
        for (const ClassGrid& grid : class_grids(request).grids) {
            bits_.push_back(grid.bits);
            cells_.emplace_back(std::size_t{1} << D * grid.bits);
        }
    }

    ClassedPoints run()
    {
        ClassedPoints result{{D, {}}, {}, std::vector<bool>(open_.size())};
        for (std::size_t i = 0; i < part_count(request_); ++i) {
            const ClassPart part = part_of(request_, i);
            const std::size_t first = points_.size();
            fill(part, result);
            if (request_.on_filled && !part.densities.empty())
                request_.on_filled(i, part,
                                   {to_point_set<D>(std::span<const TorusPoint<D>>(points_).subspan(first)),
                                    {result.classes.begin() + static_cast<std::ptrdiff_t>(first), result.classes.end()},
                                    result.is_full});
        }
        result.points = to_point_set<D>(std::span<const TorusPoint<D>>(points_));
        result.scale = scale_;
        return result;
    }

private:
    void fill(const ClassPart& part, ClassedPoints& result)
    {
        part_ = &part;
        order_ = FillOrder(part.shares, part.points);
        start_anywhere();
        for (auto own = order_.next(); own; own = order_.next()) {
            const auto slot = static_cast<std::uint32_t>(points_.size());
            const std::optional<TorusPoint<D>> dart = first_free_dart(slot, *own);
            if (!dart) {
                order_.close(*own);
                continue;
            }
            order_.add(*own);
            cells_[*own][cell_of(*dart, bits_[*own])].push_back(*dart);
            points_.push_back(*dart);
            result.classes.push_back(*own);
        }
        for (std::uint32_t i = 0; i < open_.size(); ++i)
            if (order_.is_closed(i) && order_.counts()[i] < part.most_of(i)) result.is_full[i] = true;
        result.part_ends.push_back(points_.size());
    }

    void start_anywhere()
    {
        for (std::uint32_t i = 0; i < open_.size(); ++i) {
            open_[i] = start_cells(*part_, D, distances_, i);
            if (open_[i].cells.empty()) order_.close(i);
        }
    }

    /// Is all of the box outside of the region? A position is known to be, a larger box that may cross it is not.
    bool is_outside(const ClassBox<D>& box) const
    {
        if constexpr (D == 2) {
            if (!part_->region) return false;
            if (box.extent == 0) return !part_->region->contains(box.low);
            const TorusPoint<2> high{box.low[0] + box.extent, box.low[1] + box.extent};
            return part_->region->side_of({box.low, high}) == RegionSide::outside;
        }
        return false;
    }

    /// Returns nothing where the class is full.
    std::optional<TorusPoint<D>> first_free_dart(std::uint32_t slot, std::uint32_t own)
    {
        for (std::uint32_t number = 0;;) {
            for (std::uint32_t i = 0; i < contract::class_darts::TRIES; ++i, ++number) {
                const TorusPoint<D> dart = draw(slot, number, own);
                if (!is_outside({dart, 0}) && !is_covered({dart, 0}, own)) return dart;
            }
            if (!refine(own, number / contract::class_darts::TRIES - 1)) continue;
            if (open_[own].cells.empty() && !shrink()) return {};
        }
    }

    /// Makes all distances smaller. Returns whether they may be.
    bool shrink()
    {
        if (part_->points.empty() || request_.factor >= 1) return false;
        scale_ *= request_.factor;
        distances_ = request_.distances.scaled(scale_);
        pairs_ = class_pairs(distances_, request_.shares);
        start_anywhere();
        return true;
    }

    TorusPoint<D> draw(std::uint32_t slot, std::uint32_t number, std::uint32_t own) const
    {
        const auto words = philox({slot, number, own, 0}, request_.stream);
        const OpenCells& list = open_[own];
        std::size_t chosen = std::uint64_t{words[0]} * list.count(D) >> 32;
        using contract::class_darts::TRIES, contract::class_darts::TRIES_BEFORE;
        if (!list.masses.empty() && number < 2 * TRIES) {
            const std::size_t points = part_->points.empty() ? 1 : part_->points[own];
            const std::uint32_t wider = spread_of(list, points) + 2 * (number / TRIES_BEFORE),
                                bits = number < TRIES - TRIES_BEFORE ? std::min(32u, wider) : 32;
            const auto random = static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
            const std::uint32_t target = target_of(own, order_.counts()[own], request_.stream);
            const auto after = std::ranges::upper_bound(list.starts, (target & ~random) | (words[0] & random));
            chosen = static_cast<std::size_t>(after - list.starts.begin()) - 1;
        }
        TorusPoint<D> dart;
        for (std::size_t k = 0; k < D; ++k) {
            const std::uint64_t low = std::uint64_t{list.cells[chosen * D + k]} << (32 - list.level);
            dart[k] = static_cast<std::uint32_t>(low + (std::uint64_t{words[k + 1]} >> list.level));
        }
        return dart;
    }

    /// Returns whether cells were looked at.
    bool refine(std::uint32_t own, std::uint32_t failed)
    {
        if (open_[own].level == 0) open_[own] = all_cells(first_level(distances_, own) - 1, D);
        const OpenCells& list = open_[own];
        const std::size_t points = order_.counts()[own];
        const auto below =
            level_after(list, distances_, own, failed, points, part_->points.empty() ? 0 : part_->points[own]);
        if (!below) return false;
        const std::uint32_t level = *below;
        const bool is_split = list.level < level;
        std::vector<std::uint32_t> kept(list.count(D));
        for (std::size_t i = 0; i < kept.size(); ++i)
            for (std::uint32_t child = 0; child < (is_split ? 1u << D : 1u); ++child) {
                ClassBox<D> box{{}, static_cast<std::uint32_t>((std::uint64_t{1} << (32 - level)) - 1)};
                for (std::size_t k = 0; k < D; ++k) {
                    const std::uint64_t cell = list.cells[i * D + k];
                    box.low[k] =
                        static_cast<std::uint32_t>((is_split ? 2 * cell + (child >> k & 1) : cell) << (32 - level));
                }
                if (!is_outside(box) && !is_covered(box, own)) kept[i] |= 1u << child;
            }
        open_[own] = refined(list, kept, D, level);
        open_[own].covered_at = points;
        return true;
    }

    static std::size_t cell_of(const TorusPoint<D>& point, std::uint32_t bits)
    {
        std::size_t cell = 0;
        for (int k = D - 1; k >= 0; --k) cell = cell << bits | std::uint64_t{point[k]} >> (32 - bits);
        return cell;
    }

    /// Is the box nearer to one point than its class and class `own` are to be, all of it?
    bool is_covered(const ClassBox<D>& box, std::uint32_t own) const
    {
        for (std::size_t number = 0; number < open_.size(); ++number) {
            const ClassPair& pair = pairs_[own * open_.size() + number];
            if (any_near(box, pair.reach, pair.other,
                         [&](const TorusPoint<D>& point) { return squared_farthest_of<D>(point, box) < pair.squared; }))
                return true;
        }
        return false;
    }

    /// Looks at the points of a class in all cells that a box with a border of `reach` meets.
    template <typename Predicate>
    bool any_near(const ClassBox<D>& box, std::uint64_t reach, std::size_t other, Predicate&& predicate) const
    {
        const std::uint32_t bits = bits_[other];
        const std::uint64_t side = std::uint64_t{1} << (32 - bits), turn = std::uint64_t{1} << 32;
        std::array<std::uint64_t, D> first, count, at{};
        for (std::size_t k = 0; k < D; ++k) {
            first[k] = (box.low[k] + turn - reach) / side;
            count[k] = std::min((box.low[k] + turn + box.extent + reach) / side - first[k] + 1, turn / side);
        }
        for (;;) {
            std::size_t cell = 0;
            for (std::size_t k = D; k-- > 0;) cell = cell << bits | (first[k] + at[k]) % (turn / side);
            if (std::ranges::any_of(cells_[other][cell], predicate)) return true;
            std::size_t k = 0;
            while (k < D && ++at[k] == count[k]) at[k++] = 0;
            if (k == D) return false;
        }
    }

    const ClassDartRequest& request_;
    const ClassPart* part_ = nullptr; ///< the one that is filled
    FillOrder order_;
    double scale_ = 1;
    ClassDistances distances_; ///< those of the request, scaled
    std::vector<ClassPair> pairs_;
    std::vector<OpenCells> open_;
    std::vector<std::uint32_t> bits_;                            ///< of each class' grid
    std::vector<std::vector<std::vector<TorusPoint<D>>>> cells_; ///< of each class: the points in each cell
    std::vector<TorusPoint<D>> points_;
};

}

ClassedPoints throw_class_darts(const ClassDartRequest& request)
{
    return request.dimension == 2 ? ThrowingInSlots<2>(request).run() : ThrowingInSlots<3>(request).run();
}

}
