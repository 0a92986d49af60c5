// Runs kernels/relaxation_dart_throwing.cl: rounds of one batch of darts each. Where the algorithm is stays
// on the device; the host looks every few rounds, and chooses the size of batches, which decides about the
// cost only.
#include "host/sampling/relaxation_dart_throwing.hpp"

#include "base/geometry/torus.hpp"
#include "host/device/needed_buffers.hpp"
#include "host/sampling/cells/region_buffers.hpp"
#include "host/sampling/relaxing_grids.hpp"
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

/// Work-items of cover_cells for each compute unit where the table has blocks, and so many at most on other devices.
constexpr std::size_t cover_items_a_unit = 4;
constexpr std::size_t most_cover_items = 4096;

/// A batch is looked at for a radius that is smaller by this factor at most, or by as many levels at least:
/// the smaller, the more candidates fail.
constexpr double least_radius_ahead = 0.98;
constexpr std::uint64_t least_levels_ahead = 3;

/// Cells of points are made narrower when so many times as many along each axis are wide enough: they have some two
/// points at most, however many points there are.
constexpr double finer_grid = 1.25;

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

/// Returns the value of REGION for kernels: 2 if darts fall into squares, 1 in other regions, 0 on the torus.
int region_kind(const RelaxationDartThrowingRequest& request)
{
    return request.is_in_squares() ? 2 : int{has_land(request)};
}

std::size_t point_words_of(const RelaxationDartThrowingRequest& request)
{
    return contract::relaxation_dart_throwing::POINT_WORDS(static_cast<std::size_t>(request.dimension),
                                                           static_cast<std::size_t>(region_kind(request)));
}

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
    Buffer<std::uint32_t> corners;                                   ///< of squares
    Buffer<std::uint32_t> first_parts, block_corners, blocks_around; ///< see TableBlocks
    LandBuffers land;

    NeededBuffers needed(const RelaxationDartThrowingRequest& request, std::size_t group_size)
    {
        const int d = request.dimension;
        const GridLimits limits = grid_limits(request);
        NeededBuffers buffers{
            {state, contract::relaxation_dart_throwing::STATE_WORDS},
            {thresholds, levels_of_table(request)},
            {flags, most_blocks(d, group_size)},
            {candidates, largest_batch / contract::relaxation_dart_throwing::DARTS_A_WORD},
            {points, request.points * point_words_of(request)},
            {cells, limits.cell_numbers(limits.most_cells, d) * contract::relaxation_dart_throwing::CELL_WORDS},
            {table, limits.parts}};
        if (request.is_in_squares())
            with_squares(request, [&](const auto& all) {
                const auto axes = static_cast<std::size_t>(d);
                const std::size_t count = all.corners.size();
                buffers.insert(buffers.end(), {{corners, axes * count},
                                               {first_parts, count},
                                               {block_corners, axes * count},
                                               {blocks_around, (d == 2 ? 9 : 27) * count}});
            });
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
          is_cpu_(device.info().type == "CPU"), compute_units_(device.info().compute_units), is_in_order_(is_cpu_),
          window_(request)
    {
        const KernelProgram program =
            kernel_program("relaxation_dart_throwing.cl",
                           {{"DIMENSION", D}, {"COVER_BITS", limits_.cover_bits}, {"REGION", region_kind(request)}});
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
        if (request.is_in_squares()) with_squares(request, [&](const auto& all) { write_corners(all); });
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

    /// Needs squares.
    contract::relaxation_dart_throwing::DartSquares dart_squares() const
    {
        const TableFineness fineness = fineness_of(request_, static_cast<int>(grid_bits_));
        return {with_squares(request_, [](const auto& all) { return u32(all.corners.size()); }),
                static_cast<std::uint32_t>(fineness.square_shift), static_cast<std::uint32_t>(fineness.block_bits())};
    }

    /// Runs a kernel with the box or the squares that darts fall into, if there are any.
    template <typename Run>
    void with_box(const Run& run) const
    {
        if (request_.is_in_squares()) return run(dart_squares(), buffers_.corners);
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
        if (was_in_order && !is_in_order_ && has_table_) update_table();
    }

    void throw_batch()
    {
        RelaxationDartBuffers& b = buffers_;
        const std::uint32_t words = u32(batch_ / darts_a_word);
        const auto [key_x, key_y] = request_.stream;
        const auto run_throw = [&](const auto&... box) {
            throw_.run(batch_ / darts_a_throwing_item, group_size_, b.state, b.table, grid_bits_, key_x, key_y, b.flags,
                       box...);
        };
        if (request_.is_in_squares())
            run_throw(dart_squares(), b.first_parts);
        else
            with_box(run_throw);
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
        if (request_.is_in_squares()) return update_blocks();
        const std::size_t rows = std::size_t{1} << (D - 1) * grid_bits_;
        const std::size_t rows_an_item = is_cpu_ ? std::max<std::size_t>(1, rows / cover_items_of_cpu) : 1;
        cover_.run(rows / rows_an_item, std::min<std::size_t>(group_size_, D == 2 || rows_an_item > 1 ? 1 : 8),
                   buffers_.state, buffers_.points, grid_bits_, u32(rows_an_item), buffers_.table);
    }

    void update_blocks()
    {
        const RelaxationDartBuffers& b = buffers_;
        const std::size_t items = is_cpu_ ? cover_items_a_unit * std::max(1u, compute_units_) : most_cover_items;
        const std::size_t blocks_an_item = (blocks_ + items - 1) / items;
        cover_.run((blocks_ + blocks_an_item - 1) / blocks_an_item, std::min<std::size_t>(group_size_, is_cpu_ ? 1 : 8),
                   b.state, b.points, grid_bits_, u32(blocks_an_item), b.table, dart_squares(), b.first_parts,
                   b.block_corners, b.blocks_around, u32(blocks_));
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
        const std::size_t cells = limits_.cell_numbers(grid_size_, D);
        clear_cells_.run(cells, group_size_, b.cells, u32(cells));
        if (state_[POINTS] == 0) return;
        link_.run(state_[POINTS], group_size_, b.state, b.cells, b.points, point_cells());
        fill_.run(cells, group_size_, b.cells, u32(cells), b.points);
    }

    /// Makes the grid of the table as fine as the minimum distance allows, where the table is needed.
    void fit_table()
    {
        if (is_in_order_) return;
        const std::uint32_t bits = grid_bits_for(present_threshold());
        if (has_table_ && bits == grid_bits_) return;
        has_table_ = true;
        grid_bits_ = bits;
        if (request_.is_in_squares())
            with_squares(request_, [&](const auto& squares) { clear_blocks(squares.corners); });
        else
            clear_torus();
        update_table();
    }

    void clear_torus()
    {
        RelaxationDartBuffers& b = buffers_;
        const std::size_t rows = std::size_t{1}
                                 << (D * grid_bits_ + (D - 1) * static_cast<std::size_t>(limits_.cover_bits));
        b.land.run_with(request_, [&](const auto&... region) {
            clear_table_.run(rows, group_size_, b.state, b.table, u32(rows), grid_bits_, region...);
        });
    }

    template <std::size_t Axes>
    void clear_blocks(const SquareCorners<Axes>& squares)
    {
        RelaxationDartBuffers& b = buffers_;
        const TableFineness fineness = fineness_of(request_, static_cast<int>(grid_bits_));
        const TableBlocks blocks = table_blocks(squares, fineness);
        b.first_parts.write(blocks.first_parts);
        b.block_corners.write(blocks.corners);
        b.blocks_around.write(blocks.around);
        blocks_ = blocks.corners.size() / Axes;
        const std::size_t cells = blocks_ << static_cast<int>(Axes) * (fineness.block_bits() - fineness.cover_bits);
        b.land.run_with(request_, [&](const auto&... region) {
            clear_table_.run(cells, std::min<std::size_t>(group_size_, 8), b.state, b.table, u32(cells), grid_bits_,
                             dart_squares(), b.block_corners, region...);
        });
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
        const std::size_t point_words = point_words_of(request_);
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
    bool is_cpu_;
    unsigned compute_units_;
    bool is_in_order_;
    Kernel throw_, find_, settle_, cover_, clear_table_, clear_cells_, link_, fill_, throw_in_order_;
    StateWords state_{}; ///< as the host saw it last
    std::uint64_t batch_ = first_batch, darts_in_order_ = first_darts_in_order;
    std::uint64_t levels_ahead_ = 1;
    bool has_table_ = false;
    std::uint32_t grid_bits_ = 0; ///< of the table
    std::size_t blocks_ = 0;      ///< of the table
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
