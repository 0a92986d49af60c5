// XXH64 of byte strings of any length, in one or several parts: the checksum of tile set files and finished work.
//
// By libxxhash. The hash of lattice points, tiles/tilings/tile_lattice.hpp, is the same function of a few words.
#pragma once

#include <cstdint>
#include <memory>
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
    struct State;
    std::unique_ptr<State, void (*)(State*)> state_;
};

/// XXH64 of one byte string.
std::uint64_t xxh64_bytes(std::string_view bytes, std::uint64_t seed = 0);

}
