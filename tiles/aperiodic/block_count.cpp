#include "tiles/aperiodic/block_count.hpp"

#include "base/errors/errors.hpp"
#include "tiles/aperiodic/row_graph.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::uint64_t count_blocks(const WangList& list, std::size_t width, std::size_t height)
{
    const RowGraph graph = open_rows(list, width);
    std::vector<std::uint64_t> blocks(graph.words.size(), 1); // that end with each word on the south; one that is empty
    for (std::size_t rows = 0; rows < height; ++rows) {
        std::vector<std::uint64_t> taller(graph.words.size());
        for (std::size_t i = 0; i < graph.rows(); ++i)
            if (__builtin_add_overflow(taller[graph.south[i]], blocks[graph.north[i]], &taller[graph.south[i]]))
                throw InputError(fmt::format("more than 2^64 rectangles of {} x {} tiles fit", width, height));
        blocks = std::move(taller);
    }
    std::uint64_t sum = 0;
    for (const std::uint64_t count : blocks)
        if (__builtin_add_overflow(sum, count, &sum))
            throw InputError(fmt::format("more than 2^64 rectangles of {} x {} tiles fit", width, height));
    return sum;
}

}
