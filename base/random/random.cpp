#include "base/random/random.hpp"

#include <Random123/philox.h>

namespace poissonlab {

std::array<std::uint32_t, 4> philox(const std::array<std::uint32_t, 4>& counter, const StreamKey& key)
{
    const philox4x32_ctr_t c = {{counter[0], counter[1], counter[2], counter[3]}};
    const philox4x32_key_t k = {{key[0], key[1]}};
    const philox4x32_ctr_t out = philox4x32(c, k);
    return {out.v[0], out.v[1], out.v[2], out.v[3]};
}

StreamKey stream_key(std::uint64_t seed, Purpose purpose, std::uint32_t realization, std::uint32_t attempt)
{
    const auto words = philox({static_cast<std::uint32_t>(purpose), realization, attempt, 0},
                              {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
    return {words[0], words[1]};
}

}
