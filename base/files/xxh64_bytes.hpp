// XXH64 of byte strings of any length, in one or several parts: the checksum of tile set files.
//
// Collet, xxHash, https://github.com/Cyan4973/xxHash, doc/xxhash_spec.md. It is as fast as memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace poissonlab {

class Xxh64
{
public:
    explicit Xxh64(std::uint64_t seed = 0);

    /// Appends bytes to those that the hash is of.
    void add(std::string_view bytes);

    /// The hash of all bytes so far.
    std::uint64_t value() const;

private:
    static constexpr std::size_t stripe_size = 32;

    void add_stripe(const char* stripe);

    std::uint64_t seed_;
    std::array<std::uint64_t, 4> lanes_;
    std::array<char, stripe_size> rest_{}; ///< what does not fill a stripe yet
    std::uint64_t length_ = 0;
};

/// XXH64 of one byte string.
std::uint64_t xxh64_bytes(std::string_view bytes, std::uint64_t seed = 0);

}
