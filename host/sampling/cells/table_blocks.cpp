#include "host/sampling/cells/table_blocks.hpp"

#include "host/sampling/cells/cells_around.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

template <std::size_t D>
std::array<std::uint32_t, D> shifted(std::array<std::uint32_t, D> corner, int shift)
{
    for (std::uint32_t& c : corner) c >>= shift;
    return corner;
}

}

int TableFineness::block_bits() const { return std::max(square_shift + grid_bits + cover_bits - 32, cover_bits); }

template <std::size_t D>
std::size_t block_count(const SquareCorners<D>& squares, const TableFineness& fineness)
{
    const int shift = fineness.block_shift();
    if (shift == fineness.square_shift) return squares.size();
    std::size_t count = squares.empty() ? 0 : 1;
    for (std::size_t i = 1; i < squares.size(); ++i)
        count += shifted(squares[i], shift) != shifted(squares[i - 1], shift);
    return count;
}

template <std::size_t D>
TableBlocks table_blocks(const SquareCorners<D>& squares, const TableFineness& fineness)
{
    const int block_bits = fineness.block_bits(), shift = fineness.block_shift();
    const int part_shift = shift - block_bits;
    TableBlocks table;
    std::vector<std::array<std::uint32_t, D>> blocks;
    table.first_parts.reserve(squares.size());
    for (const auto& corner : squares) {
        const std::array<std::uint32_t, D> block = shifted(corner, shift);
        if (blocks.empty() || blocks.back() != block) blocks.push_back(block);
        auto part = static_cast<std::uint32_t>((blocks.size() - 1) << static_cast<int>(D) * block_bits);
        for (std::size_t k = 0; k < D; ++k)
            part += (corner[k] >> part_shift & ((1u << block_bits) - 1)) << static_cast<int>(k) * block_bits;
        table.first_parts.push_back(part);
    }
    for (const auto& block : blocks)
        for (const std::uint32_t c : block) table.corners.push_back(c << (block_bits - fineness.cover_bits));
    table.around = numbers_around(blocks);
    return table;
}

template std::size_t block_count<2>(const SquareCorners<2>&, const TableFineness&);
template std::size_t block_count<3>(const SquareCorners<3>&, const TableFineness&);
template TableBlocks table_blocks<2>(const SquareCorners<2>&, const TableFineness&);
template TableBlocks table_blocks<3>(const SquareCorners<3>&, const TableFineness&);

}
