// Runs kernels/relaxation_dart_throwing.cl: rounds of one batch of darts each. Where the algorithm is stays
// on the device; the host looks every few rounds, and chooses the size of batches, which decides about the
// cost only.
#include "host/sampling/relaxation_dart_throwing.hpp"

#include "base/geometry/lattice.hpp"
#include "base/geometry/torus.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/region_buffers.hpp"
#include "kernels/common/darts/relaxation_dart_throwing.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace poissonlab {
namespace {

/// Rounds that are enqueued before the host looks again.
constexpr std::uint64_t rounds_at_once = 4;

/// Darts in a batch: at first, at least, and at most. Multiples of DARTS_A_WORD.
constexpr std::uint64_t first_batch = 256;
constexpr std::uint64_t smallest_batch = 1024;
constexpr std::uint64_t largest_batch = std::uint64_t{1} << 18;

/// Candidates in a batch that are worth a round: they are settled one after the other, while the other
/// kernels run in parallel and cost a launch each.
constexpr double candidates_a_batch = 300;

/// Darts are thrown one after the other, by a single work-item of a CPU, while at least one of so many becomes a point:
/// then batches of so few candidates take more time to launch than to throw.
constexpr std::uint64_t darts_a_point_in_order = 40;

/// Darts of the first such launch and, as they grow, at most: multiples of what kernels draw at once.
constexpr std::uint64_t first_darts_in_order = 1024;
constexpr std::uint64_t most_darts_in_order = std::uint64_t{1} << 14;

/// Work-items of cover_cells on a CPU. Each looks at all new points, which are a few hundred a batch: an item for each
/// row of cells would look at the points of a set as often as there are rows, which is not linear in its size.
constexpr std::size_t cover_items_of_cpu = 64;

/// A batch is looked at for a radius that is smaller by this factor at most, or by as many levels at least:
/// the smaller, the more candidates fail.
constexpr double least_radius_ahead = 0.98;
constexpr std::uint64_t least_levels_ahead = 3;

/// The grids of the kernel file: for the table 2^grid_bits cells along each axis, and 2^cover_bits parts of each; for
/// points so many cells along each axis.
struct GridLimits
{
    int most_grid_bits;
    int cover_bits;
    std::uint32_t most_cells;
    std::uint32_t number_bits; ///< of folded cells of points; 0: they are not folded
};

/// Folded cells along each axis at most: they are at least as wide as distances, which have more positions than this
/// leaves.
constexpr std::uint32_t most_folded_cells = 1u << 28;

/// Folded cells have twice as many numbers as there are points, or some more.
std::uint32_t folded_bits(std::size_t points) { return static_cast<std::uint32_t>(std::bit_width(points)) + 1; }

/// Cells of points are made narrower when so many times as many along each axis are wide enough: they have some two
/// points at most, however many points there are.
constexpr double finer_grid = 1.25;

/// Cells of the table's grid, a point of the whole set, at most: a grid that would be made for less than the last
/// quarter of the points costs more, with all points to be entered anew, than darts that it decides.
constexpr double table_cells_a_point = 1.5;

/// Parts of the table: more leave fewer darts undecided, and fit the caches less.
constexpr int most_table_bits = 29;

GridLimits grid_limits(const RelaxationDartThrowingRequest& request)
{
    const std::size_t points = request.points;
    const int dimension = request.dimension;
    if (request.is_in_squares()) return {0, dimension == 2 ? 3 : 2, most_folded_cells, folded_bits(points)};
    const auto most_cells_of_table = static_cast<std::uint64_t>(table_cells_a_point * static_cast<double>(points));
    const int for_points = (static_cast<int>(std::bit_width(most_cells_of_table)) - 1) / dimension;
    const int most_grid_bits = std::clamp(for_points, 0, most_table_bits / dimension - 2);
    const int cover_bits = dimension == 2 ? 3 : 2;
    const double most_cells = std::pow(static_cast<double>(points), 1.0 / dimension);
    return {most_grid_bits, std::min(cover_bits, most_table_bits / dimension - most_grid_bits),
            std::max(1u, static_cast<std::uint32_t>(most_cells)), 0};
}

/// Numbers of cells of points.
std::size_t cell_numbers(const GridLimits& limits, std::uint32_t grid_size, int dimension)
{
    return limits.number_bits > 0 ? std::size_t{1} << limits.number_bits : lattice_cells(grid_size, dimension);
}

/// Sizes of what the kernels work on, in elements.
struct GridSizes
{
    std::size_t cells;
    std::size_t parts;
};

GridSizes grid_sizes(const GridLimits& limits, int dimension)
{
    return {cell_numbers(limits, limits.most_cells, dimension),
            std::size_t{1} << dimension * (limits.most_grid_bits + limits.cover_bits)};
}

/// Blocks of the largest batch, padded to whole work-groups.
std::size_t most_blocks(int dimension, std::size_t group_size)
{
    return largest_batch / contract::relaxation_dart_throwing::DARTS_A_BLOCK(dimension) +
           contract::relaxation_dart_throwing::BLOCKS_A_FLAG_ITEM * group_size;
}

/// The most levels beyond the present one that a batch is looked at for.
std::uint64_t most_levels_ahead(const RelaxationDartThrowingRequest& request)
{
    const double levels = std::log(least_radius_ahead) / std::log(request.factor);
    return std::clamp(static_cast<std::uint64_t>(std::min(levels, 1e3)), least_levels_ahead, std::uint64_t{1000});
}

/// Levels that the next rounds can reach, and those that the table of thresholds has.
std::uint64_t levels_in_reach(const RelaxationDartThrowingRequest& request)
{
    return (rounds_at_once + 1) * (most_levels_ahead(request) + 1);
}
std::uint64_t levels_of_table(const RelaxationDartThrowingRequest& request) { return 8 * levels_in_reach(request); }

}

std::uint64_t RadiusLevels::squared_min_distance() const
{
    return std::max<std::uint64_t>(1, squared_threshold(2 * radius_));
}

struct RelaxationDartBuffers
{
    Buffer<std::uint64_t> state, thresholds;
    Buffer<std::uint8_t> flags;       ///< a block of darts each
    Buffer<std::uint64_t> candidates; ///< a word of darts each
    Buffer<std::uint16_t> table;      ///< a part of a grid cell each
    Buffer<std::uint32_t> cells;
    Buffer<std::uint32_t> points;
    Buffer<std::uint32_t> corners; ///< of squares
    LandBuffers land;

    NeededBuffers needed(const RelaxationDartThrowingRequest& request, std::size_t group_size)
    {
        const int d = request.dimension;
        const auto [cell_count, parts] = grid_sizes(grid_limits(request), d);
        NeededBuffers buffers{{state, contract::relaxation_dart_throwing::STATE_WORDS},
                              {thresholds, levels_of_table(request)},
                              {flags, most_blocks(d, group_size)},
                              {candidates, largest_batch / contract::relaxation_dart_throwing::DARTS_A_WORD},
                              {points, request.points * contract::relaxation_dart_throwing::POINT_WORDS(d)},
                              {cells, cell_count * contract::relaxation_dart_throwing::CELL_WORDS},
                              {table, parts}};
        if (request.squares) buffers.push_back({corners, 2 * request.squares->corners.size()});
        if (request.cubes) buffers.push_back({corners, 3 * request.cubes->corners.size()});
        for (const NeededBuffer& buffer : land.needed(request)) buffers.push_back(buffer);
        return buffers;
    }
};

namespace {

template <int D>
class RelaxationThrowing
{
public:
    RelaxationThrowing(Device& device, RelaxationDartBuffers& buffers, const RelaxationDartThrowingRequest& request,
                       std::size_t group_size)
        : buffers_(buffers), request_(request), group_size_(group_size), limits_(grid_limits(request)),
          is_cpu_(device.info().type == "CPU"), is_in_order_(is_cpu_), window_(request)
    {
        const KernelProgram program = kernel_program(
            "relaxation_dart_throwing.cl", {{"DIMENSION", D},
                                            {"COVER_BITS", limits_.cover_bits},
                                            {"REGION", request.is_in_squares() ? 2 : int{has_land(request)}}});
        throw_ = device.kernel(program, "throw_darts");
        find_ = device.kernel(program, "find_candidates");
        settle_ = device.kernel(program, "settle_candidates");
        cover_ = device.kernel(program, "cover_cells");
        clear_table_ = device.kernel(program, "clear_table");
        clear_cells_ = device.kernel(program, "clear_cells");
        link_ = device.kernel(program, "link_points");
        fill_ = device.kernel(program, "fill_cells");
        throw_in_order_ = device.kernel(program, "throw_in_order");
        reserve(device, buffers_.needed(request, group_size));
        // Darts fall anywhere.
        ask_for_large_pages(buffers_.table.impl());
        ask_for_large_pages(buffers_.cells.impl());
        buffers_.land.write(request);
        if (request.squares) write_corners(*request.squares);
        if (request.cubes) write_corners(*request.cubes);
    }

    RelaxationDarts run()
    {
        fit_window();
        state_[LOW_THRESHOLD] = window_thresholds_[0];
        buffers_.state.write(state_);
        while (state_[POINTS] < request_.points) {
            fit_cells();
            fit_table();
            fit_window();
            if (is_in_order_) {
                throw_in_order();
            } else {
                for (std::uint64_t round = 0; round < rounds_at_once; ++round) throw_batch();
            }
            const StateWords before = state_;
            buffers_.state.read(state_);
            if (!is_in_order_) choose_batch(before);
            choose_order(before);
        }
        while (window_.level() < state_[LEVEL]) window_.reduce();
        return {accepted_points(), window_.radius(), state_[NEXT_DART]};
    }

private:
    using enum contract::relaxation_dart_throwing::State;
    using StateWords = std::array<std::uint64_t, STATE_WORDS>;
    static constexpr std::uint64_t darts_a_word = contract::relaxation_dart_throwing::DARTS_A_WORD;
    static constexpr std::size_t point_words = contract::relaxation_dart_throwing::POINT_WORDS(D);
    static constexpr std::size_t darts_a_throwing_item =
        contract::relaxation_dart_throwing::DARTS_A_BLOCK(D) * contract::relaxation_dart_throwing::BLOCKS_A_FLAG_ITEM;

    static std::uint32_t u32(std::uint64_t value) { return static_cast<std::uint32_t>(value); }

    contract::relaxation_dart_throwing::Settling settling(std::uint64_t words) const
    {
        return {.first_level = window_.level(),
                .attempts = request_.attempts,
                .words = u32(words),
                .key_x = request_.stream[0],
                .key_y = request_.stream[1],
                .target = u32(request_.points),
                .levels_ahead = u32(levels_ahead_),
                .cells = point_cells(),
                .unused = 0};
    }

    contract::relaxation_dart_throwing::PointCells point_cells() const { return {grid_size_, limits_.number_bits}; }

    template <typename Squares>
    void write_corners(const Squares& squares)
    {
        std::vector<std::uint32_t> words;
        for (const auto& corner : squares.corners) words.insert(words.end(), corner.begin(), corner.end());
        buffers_.corners.write(words);
    }

    template <typename Run, typename Squares>
    void run_in_squares(const Run& run, const Squares& squares) const
    {
        run(contract::relaxation_dart_throwing::DartSquares{u32(squares.corners.size()),
                                                            static_cast<std::uint32_t>(squares.shift)},
            buffers_.corners);
    }

    /// Runs a kernel with the box or the squares that darts fall into, if there are any.
    template <typename Run>
    void with_box(const Run& run) const
    {
        if (request_.squares) return run_in_squares(run, *request_.squares);
        if (request_.cubes) return run_in_squares(run, *request_.cubes);
        const auto run_in = [&](const auto& box) {
            contract::relaxation_dart_throwing::DartBox darts{};
            for (std::size_t k = 0; k < box.low.size(); ++k) {
                darts.low[k] = box.low[k];
                darts.size[k] = box.high[k] - box.low[k] + 1;
            }
            run(darts);
        };
        if (request_.region)
            run_in(request_.region->extent());
        else if (request_.space)
            run_in(request_.space->extent());
        else
            run();
    }

    /// Runs a kernel with that box and the region, if there is one.
    template <typename Run>
    void with_region(const Run& run) const
    {
        with_box([&](const auto&... box) {
            buffers_.land.run_with(request_, [&](const auto&... region) { run(box..., region...); });
        });
    }

    /// Ends at the level where grids become finer, and within the table of thresholds.
    void throw_in_order()
    {
        std::size_t end = state_[LEVEL] - window_.level() + 1;
        const std::size_t last = window_thresholds_.size() - levels_in_reach(request_);
        while (end < last && !needs_finer_cells(window_thresholds_[end])) ++end;
        with_region([&](const auto&... region) {
            throw_in_order_.run(1, 1, settling(darts_in_order_ / darts_a_throwing_item), window_.level() + end,
                                buffers_.state, buffers_.thresholds, buffers_.cells, buffers_.points, region...);
        });
        darts_in_order_ = std::min(most_darts_in_order, 4 * darts_in_order_);
    }

    /// Throws in order while many darts become points; the table, which is not needed until then, is made up for.
    void choose_order(const StateWords& before)
    {
        const std::uint64_t darts = state_[NEXT_DART] - before[NEXT_DART];
        const std::uint64_t points = state_[POINTS] - before[POINTS];
        const bool was_in_order = is_in_order_;
        is_in_order_ = is_cpu_ && points * darts_a_point_in_order >= darts;
        if (was_in_order && !is_in_order_) update_table();
    }

    void throw_batch()
    {
        RelaxationDartBuffers& b = buffers_;
        const std::uint32_t words = u32(batch_ / darts_a_word);
        const auto [key_x, key_y] = request_.stream;
        with_box([&](const auto&... box) {
            throw_.run(batch_ / darts_a_throwing_item, group_size_, b.state, b.table, grid_bits_, key_x, key_y, b.flags,
                       box...);
        });
        with_region([&](const auto&... region) {
            find_.run(words, std::min<std::size_t>(group_size_, 4), b.state, b.flags, words, b.cells, b.points,
                      point_cells(), key_x, key_y, b.candidates, region...);
        });
        with_box([&](const auto&... box) {
            settle_.run(1, 1, settling(words), b.state, b.candidates, b.thresholds, b.cells, b.points, box...);
        });
        update_table();
    }

    /// Enters the points that the table does not know.
    void update_table()
    {
        const std::size_t rows = std::size_t{1} << (D - 1) * grid_bits_;
        const std::size_t rows_an_item = is_cpu_ ? std::max<std::size_t>(1, rows / cover_items_of_cpu) : 1;
        cover_.run(rows / rows_an_item, std::min<std::size_t>(group_size_, D == 2 || rows_an_item > 1 ? 1 : 8),
                   buffers_.state, buffers_.points, grid_bits_, u32(rows_an_item), buffers_.table);
    }

    /// The widest cells below twice the minimum distance: 2^-bits >= distance, in squares of units of 2^-32.
    std::uint32_t grid_bits_for(std::uint64_t squared_min_distance) const
    {
        const int for_distance = std::countl_zero(squared_min_distance - 1) / 2;
        return u32(static_cast<std::uint64_t>(std::min(for_distance, limits_.most_grid_bits)));
    }

    std::uint64_t present_threshold() const { return window_thresholds_[state_[LEVEL] - window_.level()]; }

    /// The most cells along each axis that are as wide as a minimum distance.
    std::uint32_t cells_for(std::uint64_t squared_min_distance) const
    {
        const double most = (1 - 1e-9) * 0x1p32 / std::sqrt(static_cast<double>(squared_min_distance));
        return static_cast<std::uint32_t>(std::clamp(most, 1.0, static_cast<double>(limits_.most_cells)));
    }

    bool needs_finer_cells(std::uint64_t squared_min_distance) const
    {
        const std::uint32_t wanted = cells_for(squared_min_distance);
        return wanted > grid_size_ && (wanted == limits_.most_cells || wanted >= finer_grid * grid_size_);
    }

    /// Makes the cells of points about as narrow as the minimum distance allows.
    void fit_cells()
    {
        if (!needs_finer_cells(present_threshold())) return;
        grid_size_ = cells_for(present_threshold());
        RelaxationDartBuffers& b = buffers_;
        const std::size_t cells = cell_numbers(limits_, grid_size_, D);
        clear_cells_.run(cells, group_size_, b.cells, u32(cells));
        if (state_[POINTS] == 0) return;
        link_.run(state_[POINTS], group_size_, b.state, b.cells, b.points, point_cells());
        fill_.run(cells, group_size_, b.cells, u32(cells), b.points);
    }

    /// Makes the grid of the table as fine as the minimum distance allows.
    void fit_table()
    {
        const std::uint32_t bits = grid_bits_for(present_threshold());
        if (has_table_ && bits == grid_bits_) return;
        has_table_ = true;
        grid_bits_ = bits;
        RelaxationDartBuffers& b = buffers_;
        const std::size_t rows = std::size_t{1} << (D * bits + (D - 1) * static_cast<std::size_t>(limits_.cover_bits));
        b.land.run_with(request_, [&](const auto&... region) {
            clear_table_.run(rows, group_size_, b.state, b.table, u32(rows), bits, region...);
        });
        if (!is_in_order_) update_table();
    }

    /// Makes the table of thresholds hold all levels that the next rounds can reach.
    void fit_window()
    {
        const std::uint64_t reach = levels_in_reach(request_);
        if (state_[LEVEL] + reach < window_.level() + window_thresholds_.size()) return;
        while (window_.level() < state_[LEVEL]) window_.reduce();
        window_thresholds_.clear();
        RadiusLevels levels = window_;
        for (std::uint64_t i = 0; i < levels_of_table(request_); ++i, levels.reduce())
            window_thresholds_.push_back(levels.squared_min_distance());
        buffers_.thresholds.write(window_thresholds_);
    }

    /// Chooses as many darts as make about candidates_a_batch candidates, judged by the last rounds, but not more than
    /// go with the levels ahead; and enough levels for these darts.
    void choose_batch(const StateWords& before)
    {
        const auto darts = static_cast<double>(state_[NEXT_DART] - before[NEXT_DART]);
        const auto levels = static_cast<double>(state_[LEVEL] - before[LEVEL]);
        const auto found = static_cast<double>(state_[CANDIDATES] - before[CANDIDATES]);
        const double most_levels = static_cast<double>(most_levels_ahead(request_));
        double wanted = darts * candidates_a_batch / std::max(found, 1.0);
        if (levels > 0) wanted = std::min(wanted, darts * most_levels / levels);
        batch_ = std::clamp(static_cast<std::uint64_t>(wanted), std::max(smallest_batch, batch_ / 2),
                            std::min(largest_batch, 4 * batch_)) /
                 darts_a_word * darts_a_word;
        const double passing = levels * static_cast<double>(batch_) / std::max(darts, 1.0);
        levels_ahead_ = static_cast<std::uint64_t>(std::min(1.3 * passing + 0.5, most_levels));
    }

    PointSet accepted_points() const
    {
        const std::vector<std::uint32_t> words = buffers_.points.read(0, request_.points * point_words);
        std::vector<TorusPoint<D>> positions(request_.points);
        for (std::size_t i = 0; i < positions.size(); ++i)
            std::copy_n(&words[i * point_words], D, positions[i].begin());
        return to_point_set<D>(std::span<const TorusPoint<D>>(positions));
    }

    RelaxationDartBuffers& buffers_;
    const RelaxationDartThrowingRequest& request_;
    std::size_t group_size_;
    GridLimits limits_;
    bool is_cpu_, is_in_order_;
    Kernel throw_, find_, settle_, cover_, clear_table_, clear_cells_, link_, fill_, throw_in_order_;
    StateWords state_{}; ///< as the host saw it last
    std::uint64_t batch_ = first_batch, darts_in_order_ = first_darts_in_order;
    std::uint64_t levels_ahead_ = 1;
    bool has_table_ = false;
    std::uint32_t grid_bits_ = 0; ///< of the table
    std::uint32_t grid_size_ = 0; ///< cells of points along each axis
    RadiusLevels window_;         ///< the first level of the table of thresholds on the device
    std::vector<std::uint64_t> window_thresholds_;
};

}

RelaxationDartThrower::RelaxationDartThrower(Device device, std::size_t work_group_size)
    : DeviceMethod(std::move(device), work_group_size, std::make_shared<RelaxationDartBuffers>())
{}

RelaxationDarts RelaxationDartThrower::throw_darts(const RelaxationDartThrowingRequest& request)
{
    return request.dimension == 2 ? RelaxationThrowing<2>(device_, *buffers_, request, work_group_size_).run()
                                  : RelaxationThrowing<3>(device_, *buffers_, request, work_group_size_).run();
}

DeviceMemory RelaxationDartThrower::memory(const RelaxationDartThrowingRequest& request)
{
    return memory_of(RelaxationDartBuffers{}.needed(request, default_work_group_size));
}

}
