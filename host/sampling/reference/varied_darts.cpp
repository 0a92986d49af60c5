// Dart throwing with distances that vary, plain and sequential: what the kernels must reproduce.
#include "host/sampling/varied/varied_darts.hpp"

#include "host/sampling/varied/varied_cells.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <map>

namespace poissonlab::reference {
namespace {

using contract::varied_darts::OpenCell;

/// Points by the power of two below their distance, and in each by squares of twice its side.
class VariedGrid
{
public:
    explicit VariedGrid(bool is_mean) : is_mean_(is_mean) {}

    void add(const VariedPlace& point)
    {
        const int octave = std::bit_width(point.distance) - 1;
        squares_[octave][{point.place[0] >> (octave + 1), point.place[1] >> (octave + 1)}].push_back(point);
    }

    /// Is a square of places, where no distance is less, nearer than what is kept to one point, all of it?
    bool covers(const TorusPoint<2>& low, std::uint32_t extent, std::uint32_t least, std::uint32_t scale) const
    {
        for (const auto& [octave, squares] : squares_) {
            const int bits = octave + 1;
            const std::uint64_t reach = (twice_kept(scaled(least, scale), scaled(2u << octave, scale)) + 1) / 2;
            const std::uint64_t side = std::uint64_t{1} << bits, turn = std::uint64_t{1} << 32;
            std::array<std::uint64_t, 2> first{}, count{};
            for (std::size_t k = 0; k < 2; ++k) {
                const std::uint64_t from = low[k] + turn - reach;
                first[k] = from / side;
                count[k] = std::min((low[k] + turn + extent + reach) / side - first[k] + 1, turn / side);
            }
            for (std::uint64_t j = 0; j < count[1]; ++j)
                for (std::uint64_t i = 0; i < count[0]; ++i) {
                    const auto found = squares.find({static_cast<std::uint32_t>((first[0] + i) % (turn / side)),
                                                     static_cast<std::uint32_t>((first[1] + j) % (turn / side))});
                    if (found != squares.end() && covers(found->second, low, extent, scaled(least, scale), scale))
                        return true;
                }
        }
        return false;
    }

private:
    static std::uint32_t scaled(std::uint32_t distance, std::uint32_t scale)
    {
        return static_cast<std::uint32_t>(std::uint64_t{distance} * scale >> contract::varied_darts::SCALE_BITS);
    }

    std::uint64_t twice_kept(std::uint32_t a, std::uint32_t b) const
    {
        return is_mean_ ? std::uint64_t{a} + b : 2 * std::uint64_t{std::min(a, b)};
    }

    bool covers(const std::vector<VariedPlace>& points, const TorusPoint<2>& low, std::uint32_t extent,
                std::uint32_t least, std::uint32_t scale) const
    {
        return std::ranges::any_of(points, [&](const VariedPlace& point) {
            const std::uint64_t twice = twice_kept(least, scaled(point.distance, scale));
            const std::uint64_t squared = squared_farthest(point.place, low, extent);
            return squared < std::uint64_t{1} << 62 && 4 * squared < twice * twice;
        });
    }

    static std::uint64_t squared_farthest(const TorusPoint<2>& point, const TorusPoint<2>& low, std::uint32_t extent)
    {
        std::uint64_t sum = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            const std::uint32_t forward = point[k] - low[k], beyond = forward - extent;
            const bool has_antipode = (forward ^ 0x80000000u) <= extent;
            const std::uint64_t farthest =
                has_antipode ? 0x80000000u : std::max(std::min(forward, 0u - forward), std::min(beyond, 0u - beyond));
            sum += farthest * farthest;
        }
        return sum;
    }

    bool is_mean_;
    std::map<int, std::map<TorusPoint<2>, std::vector<VariedPlace>>> squares_; ///< by octave
};

class VariedThrowing
{
public:
    explicit VariedThrowing(const VariedDartRequest& request) : request_(request), grid_(request.is_mean) { refine(); }

    VariedDarts run()
    {
        VariedDarts darts;
        while (!cells_.cells().empty() && darts.points.size() < request_.points.value_or(SIZE_MAX)) {
            const std::optional<VariedPlace> point = first_free(static_cast<std::uint32_t>(darts.points.size()));
            if (!point) break;
            grid_.add(*point);
            darts.points.push_back(point->place);
        }
        darts.is_full = cells_.cells().empty();
        darts.scale = scale_ * 0x1p-31;
        return darts;
    }

private:
    /// Returns nothing where there is no room.
    std::optional<VariedPlace> first_free(std::uint32_t slot)
    {
        for (std::uint64_t number = 0;;) {
            for (std::uint32_t i = 0; i < tries_of(request_); ++i, ++number) {
                const std::optional<VariedPlace> dart = varied_dart(request_, cells_, slot, number);
                if (dart && !grid_.covers(dart->place, 0, dart->distance, scale_)) return dart;
            }
            if (request_.attempts > 0)
                scale_ = reduced_scale(scale_, request_.factor);
            else
                refine();
            if (cells_.cells().empty()) return {};
        }
    }

    void refine()
    {
        cells_.refine([&](std::vector<OpenCell>& cells) {
            for (OpenCell& cell : cells) cell.least = least_in(cell);
        });
    }

    std::uint32_t least_in(const OpenCell& cell) const
    {
        const std::uint32_t least = least_distance_in(request_, cell);
        return least > 0 && grid_.covers({cell.x, cell.y}, (1u << cell.bits) - 1, least, scale_) ? 0 : least;
    }

    const VariedDartRequest& request_;
    VariedGrid grid_;
    VariedCells cells_;
    std::uint32_t scale_ = 1u << contract::varied_darts::SCALE_BITS;
};

}

VariedDarts throw_varied_darts(const VariedDartRequest& request) { return VariedThrowing(request).run(); }

}
