#include "host/aperiodic_tiling/beatty_generator.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <algorithm>
#include <stdexcept>

namespace poissonlab {
namespace {

constexpr std::size_t tiles_of_piece = std::size_t{1} << 23;

std::size_t rows_of_piece(std::uint64_t width)
{
    return static_cast<std::size_t>(std::max<std::uint64_t>(1, tiles_of_piece / width));
}

contract::beatty_tiling::Machine machine_of(const BeattyMachine& machine)
{
    return {static_cast<std::uint32_t>(machine.factor), static_cast<std::uint32_t>(machine.divisor),
            static_cast<std::uint32_t>(machine.shift)};
}

std::vector<contract::beatty_tiling::Row> stored_rows(std::span<const BeattyRow> rows)
{
    std::vector<contract::beatty_tiling::Row> stored;
    for (const BeattyRow& row : rows)
        stored.push_back({row.slope.high, row.slope.low, row.offset.high, row.offset.low, row.machine});
    return stored;
}

}

NeededBuffers BeattyGenerator::Buffers::needed(std::size_t width, std::size_t piece_rows)
{
    return {{table, beatty_table_size}, {rows, piece_rows + 1}, {tiles, width * piece_rows}};
}

BeattyGenerator::BeattyGenerator(Device device, const BeattyTiling& tiling, std::size_t work_group_size)
    : device_(std::move(device)), tiling_(tiling),
      work_group_size_(work_group_size == 0 ? default_work_group_size : work_group_size),
      make_tiles_(device_.kernel(kernel_program("beatty_tiling.cl", {}), "make_tiles"))
{}

DeviceMemory BeattyGenerator::memory(const TileWindow& window)
{
    const auto rows = std::min<std::uint64_t>(rows_of_piece(window.width), window.height);
    return memory_of(Buffers{}.needed(static_cast<std::size_t>(window.width), static_cast<std::size_t>(rows)));
}

void BeattyGenerator::stream(const TileWindow& window,
                             const std::function<void(std::span<const std::uint8_t> tiles)>& sink)
{
    check_beatty_window(window);
    if (window.width >= std::uint64_t{1} << 31) throw InputError("a row of 2^31 tiles or more does not fit");
    const auto width = static_cast<std::size_t>(window.width);
    const std::size_t piece = rows_of_piece(window.width);
    reserve(device_, buffers_.needed(width, std::min<std::size_t>(piece, window.height)));
    buffers_.table.write(std::span<const std::uint8_t>(tiling_.table()));
    constexpr std::size_t run = contract::beatty_tiling::RUN_TILES();
    std::vector<std::uint8_t> tiles;
    for (std::uint64_t done = 0; done < window.height; done += piece) {
        stop_if_interrupted();
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(piece, window.height - done));
        const auto y = window.y + static_cast<std::int64_t>(window.height - 1 - done);
        buffers_.rows.write(stored_rows(tiling_.rows(y, count + 1)));
        const contract::beatty_tiling::Part part{static_cast<std::uint64_t>(window.x),
                                                 static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(count),
                                                 machine_of(tiling_.machines()[0]), machine_of(tiling_.machines()[1])};
        make_tiles_.run(count * ((width + run - 1) / run), work_group_size_, part, buffers_.table, buffers_.rows,
                        buffers_.tiles);
        tiles.resize(width * count);
        buffers_.tiles.read(std::span(tiles));
        if (std::ranges::find(tiles, no_beatty_tile) != tiles.end())
            throw std::logic_error("a tile by Beatty sequences is not in its set");
        for (std::size_t row = 0; row < count; ++row) sink(std::span(tiles).subspan(row * width, width));
    }
}

}
