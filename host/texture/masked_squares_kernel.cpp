// Masked sums of squares by the kernel, kernels/masked_squares.cl.
#include "host/device/device.hpp"
#include "host/device/kernel_program.hpp"
#include "host/texture/masked_squares.hpp"
#include "kernels/common/fields/masked_squares.h"

#include <stdexcept>

namespace poissonlab {

SquareSums masked_squares_on(Device& device, const PngPixels& exemplar, const PieceMask& mask, const PngPixels& piece)
{
    if (mask.width > exemplar.width || mask.height > exemplar.height)
        throw std::logic_error("a piece that is larger than its exemplar");
    SquareSums result{exemplar.width - mask.width + 1, exemplar.height - mask.height + 1, {}};
    result.sums.resize(static_cast<std::size_t>(result.columns) * static_cast<std::size_t>(result.rows));

    Buffer<std::uint8_t> pixels = device.buffer<std::uint8_t>(exemplar.values.size());
    Buffer<std::uint8_t> counts = device.buffer<std::uint8_t>(mask.counts.size());
    Buffer<std::uint8_t> window = device.buffer<std::uint8_t>(piece.values.size());
    const Buffer<std::uint64_t> sums = device.buffer<std::uint64_t>(result.sums.size());
    pixels.write(exemplar.values);
    counts.write(mask.counts);
    window.write(piece.values);
    const contract::masked_squares::MaskedSquaresSizes sizes{exemplar.width, mask.width,     mask.height,
                                                             piece.channels, result.columns, result.rows};
    Kernel kernel = device.kernel(kernel_program("masked_squares.cl", {}), "sum_masked_squares");
    kernel.run(result.sums.size(), default_work_group_size, pixels, counts, window, sizes, sums);
    sums.read(result.sums);
    return result;
}

}
