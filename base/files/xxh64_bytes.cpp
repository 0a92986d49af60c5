#include "base/files/xxh64_bytes.hpp"

// It comes from the header alone: one library less to load at every start.
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace poissonlab {

struct Xxh64::State
{
    XXH64_state_t xxh;
};

Xxh64::Xxh64(std::uint64_t seed) : state_(new State, [](State* state) { delete state; })
{
    XXH64_reset(&state_->xxh, seed);
}

void Xxh64::add(std::string_view bytes) { XXH64_update(&state_->xxh, bytes.data(), bytes.size()); }

std::uint64_t Xxh64::value() const { return XXH64_digest(&state_->xxh); }

std::uint64_t xxh64_bytes(std::string_view bytes, std::uint64_t seed)
{
    return XXH64(bytes.data(), bytes.size(), seed);
}

}
