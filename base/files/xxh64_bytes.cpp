#include "base/files/xxh64_bytes.hpp"

#include <xxhash.h>

#include <new>

namespace poissonlab {

Xxh64::Xxh64(std::uint64_t seed) : state_(XXH64_createState(), [](XXH64_state_s* state) { XXH64_freeState(state); })
{
    if (!state_) throw std::bad_alloc();
    XXH64_reset(state_.get(), seed);
}

void Xxh64::add(std::string_view bytes) { XXH64_update(state_.get(), bytes.data(), bytes.size()); }

std::uint64_t Xxh64::value() const { return XXH64_digest(state_.get()); }

std::uint64_t xxh64_bytes(std::string_view bytes, std::uint64_t seed)
{
    return XXH64(bytes.data(), bytes.size(), seed);
}

}
