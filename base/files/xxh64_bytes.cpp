#include "base/files/xxh64_bytes.hpp"

#include "base/files/byte_order.hpp"

#include <algorithm>
#include <bit>

namespace poissonlab {
namespace {

constexpr std::uint64_t prime_1 = 0x9E3779B185EBCA87;
constexpr std::uint64_t prime_2 = 0xC2B2AE3D27D4EB4F;
constexpr std::uint64_t prime_3 = 0x165667B19E3779F9;
constexpr std::uint64_t prime_4 = 0x85EBCA77C2B2AE63;
constexpr std::uint64_t prime_5 = 0x27D4EB2F165667C5;

template <class Word>
std::uint64_t word_at(const char* bytes)
{
    return load<Word>({bytes, sizeof(Word)}, std::endian::little);
}

constexpr std::uint64_t round(std::uint64_t lane, std::uint64_t word)
{
    return std::rotl(lane + word * prime_2, 31) * prime_1;
}

std::uint64_t merged(const std::array<std::uint64_t, 4>& lanes)
{
    std::uint64_t hash =
        std::rotl(lanes[0], 1) + std::rotl(lanes[1], 7) + std::rotl(lanes[2], 12) + std::rotl(lanes[3], 18);
    for (const std::uint64_t lane : lanes) hash = (hash ^ round(0, lane)) * prime_1 + prime_4;
    return hash;
}

/// The bytes that do not fill a stripe: words of eight, then of four, then single ones.
std::uint64_t with_rest(std::uint64_t hash, std::string_view rest)
{
    for (; rest.size() >= 8; rest.remove_prefix(8)) {
        hash ^= round(0, word_at<std::uint64_t>(rest.data()));
        hash = std::rotl(hash, 27) * prime_1 + prime_4;
    }
    if (rest.size() >= 4) {
        hash ^= word_at<std::uint32_t>(rest.data()) * prime_1;
        hash = std::rotl(hash, 23) * prime_2 + prime_3;
        rest.remove_prefix(4);
    }
    for (const char byte : rest) {
        hash ^= static_cast<unsigned char>(byte) * prime_5;
        hash = std::rotl(hash, 11) * prime_1;
    }
    return hash;
}

constexpr std::uint64_t avalanched(std::uint64_t hash)
{
    hash = (hash ^ hash >> 33) * prime_2;
    hash = (hash ^ hash >> 29) * prime_3;
    return hash ^ hash >> 32;
}

}

Xxh64::Xxh64(std::uint64_t seed) : seed_(seed), lanes_{seed + prime_1 + prime_2, seed + prime_2, seed, seed - prime_1}
{}

void Xxh64::add_stripe(const char* stripe)
{
    for (std::size_t i = 0; i < lanes_.size(); ++i)
        lanes_[i] = round(lanes_[i], word_at<std::uint64_t>(stripe + 8 * i));
}

void Xxh64::add(std::string_view bytes)
{
    std::size_t held = length_ % stripe_size;
    length_ += bytes.size();
    if (held > 0) {
        const std::size_t taken = std::min(stripe_size - held, bytes.size());
        std::ranges::copy(bytes.substr(0, taken), rest_.begin() + static_cast<std::ptrdiff_t>(held));
        bytes.remove_prefix(taken);
        held += taken;
        if (held < stripe_size) return;
        add_stripe(rest_.data());
    }
    for (; bytes.size() >= stripe_size; bytes.remove_prefix(stripe_size)) add_stripe(bytes.data());
    std::ranges::copy(bytes, rest_.begin());
}

std::uint64_t Xxh64::value() const
{
    const std::uint64_t hash = length_ >= stripe_size ? merged(lanes_) : seed_ + prime_5;
    return avalanched(with_rest(hash + length_, {rest_.data(), length_ % stripe_size}));
}

std::uint64_t xxh64_bytes(std::string_view bytes, std::uint64_t seed)
{
    Xxh64 hash(seed);
    hash.add(bytes);
    return hash.value();
}

}
