// The words of a stream one after another, for work that needs a number of them that is not known before.
#pragma once

#include "base/random/random.hpp"

#include <array>
#include <cstdint>

namespace poissonlab {

class RandomWords
{
public:
    /// Counters of Philox are (0, table, 0, 0), (1, table, 0, 0), ...
    RandomWords(const StreamKey& key, std::uint32_t table) : key_(key), table_(table) {}

    std::uint32_t next()
    {
        if (used_ == 4) {
            block_ = philox({count_++, table_, 0, 0}, key_);
            used_ = 0;
        }
        return block_[used_++];
    }

    /// Uniform in 0, 1, ..., end - 1, without bias: of 2^32 products, as many for each number are kept
    /// (Lemire: Fast random integer generation in an interval, ACM TOMACS 29, 2019).
    std::uint32_t below(std::uint32_t end)
    {
        const std::uint32_t rejected = (0u - end) % end;
        for (;;) {
            const std::uint64_t product = std::uint64_t{next()} * end;
            if (static_cast<std::uint32_t>(product) >= rejected) return static_cast<std::uint32_t>(product >> 32);
        }
    }

private:
    StreamKey key_;
    std::uint32_t table_;
    std::uint32_t count_ = 0;
    std::array<std::uint32_t, 4> block_{};
    unsigned used_ = 4;
};

}
