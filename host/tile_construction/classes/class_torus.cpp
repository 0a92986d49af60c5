#include "host/tile_construction/classes/class_torus.hpp"

#include "host/tile_construction/moments/moment_step.hpp"
#include "kernels/common/tiles/class_tiles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace poissonlab {
namespace {

constexpr int axes = 2; ///< points of the plane have classes

/// The part of the least distance that points may move before neighbours are found again.
constexpr double slack_part = 0.25;

constexpr std::uint32_t most_part = contract::class_tiles::MOST_PART;

std::uint32_t part_of(std::uint32_t squared, std::uint32_t wanted)
{
    const std::uint64_t part = (std::uint64_t{squared} << contract::class_tiles::PART_BITS) / wanted;
    return static_cast<std::uint32_t>(std::min<std::uint64_t>(part, most_part));
}

/// Brings the points of each class to its moments.
class MomentCorrection
{
public:
    MomentCorrection(const ClassMoments& moments, std::size_t classes) : own_(classes)
    {
        const std::size_t count = moments.monomials.size();
        for (std::size_t of = 0; of < classes; ++of)
            steps_.emplace_back(moments.monomials, moments.wanted.subspan(of * count, count));
    }

    bool are_near(std::span<const TilePosition> active)
    {
        measure(active);
        return std::ranges::all_of(steps_, [](const MomentStep& step) { return step.is_near(); });
    }

    std::vector<TilePosition> movements(std::span<const TilePosition> active, const ClassFillSettings& settings)
    {
        measure(active);
        for (MomentStep& step : steps_) step.find();
        std::vector<TilePosition> movements;
        for (const TilePosition& point : active) {
            const auto of = static_cast<std::size_t>(point[2]);
            const double limit = settings.pushed[of * settings.classes() + of];
            movements.push_back(limited_movement(steps_[of].movement(from_middle_of(point)), limit, axes));
        }
        return movements;
    }

private:
    static FromMiddle from_middle_of(const TilePosition& point)
    {
        return {shortest(point[0] - tile_units / 2), shortest(point[1] - tile_units / 2), 0};
    }

    void measure(std::span<const TilePosition> active)
    {
        for (auto& own : own_) own.clear();
        for (const TilePosition& point : active)
            own_[static_cast<std::size_t>(point[2])].push_back(from_middle_of(point));
        for (std::size_t of = 0; of < own_.size(); ++of) steps_[of].measure(own_[of]);
    }

    std::vector<std::vector<FromMiddle>> own_; ///< the points of each class
    std::vector<MomentStep> steps_;
};

}

std::int32_t ClassTorus::difference(std::int32_t a, std::int32_t b) const
{
    if (!is_one_tile_) return shortest(a - b);
    return ((a - b + tile_units / 2) & (tile_units - 1)) - tile_units / 2;
}

/// Lengths along an axis count as FAR_LENGTH at most, so that the result has 32 bits.
std::uint32_t ClassTorus::squared_between(const TilePosition& a, const TilePosition& b) const
{
    std::uint32_t sum = 0;
    for (std::size_t k = 0; k < axes; ++k) {
        const std::int32_t length =
            std::min<std::int32_t>(std::abs(difference(a[k], b[k])), contract::tile_filling::FAR_LENGTH);
        sum += static_cast<std::uint32_t>(length) * static_cast<std::uint32_t>(length);
    }
    return sum;
}

std::uint32_t ClassTorus::part_kept(const TilePosition& position, std::size_t self) const
{
    std::uint32_t least = most_part;
    for (std::size_t j = 0; j < points_.size(); ++j)
        if (j != self)
            least = std::min(
                least, part_of(squared_between(position, points_[j]), settings_.wanted[pair(position, points_[j])]));
    return least;
}

std::uint32_t ClassTorus::push(const ClassMoments* moments)
{
    std::optional<MomentCorrection> correction;
    if (moments) correction.emplace(*moments, settings_.classes());
    std::uint32_t best = 0;
    std::vector<TilePosition> kept;
    for (std::uint32_t pass = 0;; ++pass) {
        if (are_neighbours_stale()) find_neighbours();
        const std::uint32_t part = !correction || correction->are_near(active()) ? part_among_neighbours() : 0;
        if (pass == 0 || part > best) {
            best = part;
            kept = points_;
        }
        if (part >= whole_part || pass == settings_.passes) break;
        std::vector<TilePosition> movements;
        for (std::size_t i = active_begin_; i < points_.size(); ++i) movements.push_back(movement(i));
        move(movements);
        if (correction) move(correction->movements(active(), settings_));
    }
    points_ = kept;
    if (best < whole_part) return best;
    best = most_part; // points that are not neighbours count as well
    for (std::size_t i = active_begin_; i < points_.size(); ++i) best = std::min(best, part_kept(points_[i], i));
    return best;
}

bool ClassTorus::are_neighbours_stale() const
{
    if (listed_at_.size() != points_.size()) return true;
    const double limit = slack_ * slack_;
    for (std::size_t i = active_begin_; i < points_.size(); ++i)
        if (squared_between(points_[i], listed_at_[i]) > limit) return true;
    return false;
}

void ClassTorus::find_neighbours()
{
    slack_ = slack_part * *std::ranges::min_element(settings_.pushed);
    std::vector<double> reaches; // squared, of each pair of classes
    for (const double distance : settings_.pushed) reaches.push_back((distance + 2 * slack_) * (distance + 2 * slack_));
    neighbours_.clear();
    first_neighbour_.assign(1, 0);
    for (std::size_t i = active_begin_; i < points_.size(); ++i) {
        for (std::size_t j = 0; j < points_.size(); ++j)
            if (i != j && squared_between(points_[i], points_[j]) <= reaches[pair(points_[i], points_[j])])
                neighbours_.push_back(static_cast<std::uint32_t>(j));
        first_neighbour_.push_back(neighbours_.size());
    }
    listed_at_ = points_;
}

std::span<const std::uint32_t> ClassTorus::neighbours(std::size_t active) const
{
    return std::span(neighbours_)
        .subspan(first_neighbour_[active], first_neighbour_[active + 1] - first_neighbour_[active]);
}

std::uint32_t ClassTorus::part_among_neighbours() const
{
    std::uint32_t least = most_part;
    for (std::size_t i = active_begin_; i < points_.size(); ++i)
        for (const std::uint32_t j : neighbours(i - active_begin_))
            least = std::min(least, part_of(squared_between(points_[i], points_[j]),
                                            settings_.wanted[pair(points_[i], points_[j])]));
    return least;
}

/// Away from all points that are too near, by what they lack of the distance, half of it where the other one moves.
TilePosition ClassTorus::movement(std::size_t i) const
{
    std::array<double, 3> sum{};
    double limit = 0; // the largest distance of those that push
    for (const std::uint32_t j : neighbours(i - active_begin_)) {
        const double distance = settings_.pushed[pair(points_[i], points_[j])];
        const std::uint32_t squared = squared_between(points_[i], points_[j]);
        if (squared > static_cast<std::uint32_t>(distance * distance)) continue;
        limit = std::max(limit, distance);
        const double length = std::sqrt(static_cast<double>(squared));
        const double push = (j >= active_begin_ ? 0.5 : 1) * (distance - length);
        if (squared == 0) {
            sum[0] += i < j ? -push : push;
            continue;
        }
        for (std::size_t k = 0; k < axes; ++k) sum[k] -= difference(points_[j][k], points_[i][k]) / length * push;
    }
    return limited_movement(sum, limit, axes);
}

/// Moves all active points at once.
void ClassTorus::move(const std::vector<TilePosition>& movements)
{
    for (std::size_t i = active_begin_; i < points_.size(); ++i)
        points_[i] = allowed_end(zone_, points_[i], movements[i - active_begin_], true);
}

}
