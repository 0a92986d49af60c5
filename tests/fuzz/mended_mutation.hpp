// Mutation of formats with a checksum: without a right one, inputs get no further than its check.
#pragma once

#include <cstddef>

extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t max_size);

namespace poissonlab::fuzz {

/// Changes an input as libFuzzer does and, but for one in eight, gives it a right checksum: mend(data, size, max_size)
/// returns the new size.
template <class Mend>
std::size_t mutated(unsigned char* data, std::size_t size, std::size_t max_size, unsigned int seed, const Mend& mend)
{
    size = LLVMFuzzerMutate(data, size, max_size);
    return seed % 8 == 0 ? size : mend(data, size, max_size);
}

}
