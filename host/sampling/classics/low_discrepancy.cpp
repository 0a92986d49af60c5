#include "host/sampling/classics/low_discrepancy.hpp"

#include "base/random/random.hpp"
#include "host/sampling/classics/plain_spec.hpp"

#include <array>

namespace poissonlab {
namespace {

constexpr std::array<std::uint32_t, 3> halton_bases{2, 3, 5};

/// The digits are as many as 32 bits have room for: numbers that are rounded up to these are still below 1.
constexpr std::array<int, 6> digits_of_base{0, 0, 32, 20, 0, 13};

/// The first digits of a number in [0, 1), most significant first.
using Digits = std::array<std::uint32_t, 32>;

/// The number with these digits, rounded up to 2^-32: so it stays in every box of the base that it is in.
std::uint32_t number_of(const Digits& digits, std::uint32_t base)
{
    const int count = digits_of_base[base];
    std::uint64_t numerator = 0, denominator = 1;
    for (int i = 0; i < count; ++i) {
        numerator = numerator * base + digits[static_cast<std::size_t>(i)];
        denominator *= base;
    }
    // Sixteen bits at a time: both have up to 32.
    const std::uint64_t high = (numerator << 16) / denominator, rest = (numerator << 16) % denominator;
    return static_cast<std::uint32_t>((high << 16) + ((rest << 16) + denominator - 1) / denominator);
}

Digits inverse_digits(std::uint32_t index, std::uint32_t base)
{
    Digits digits{};
    for (std::size_t i = 0; index > 0; ++i, index /= base) digits[i] = index % base;
    return digits;
}

/// Permutes each digit by a permutation that the digits before it choose.
Digits scrambled(const Digits& digits, std::uint32_t base, int axis, const StreamKey& stream)
{
    Digits result{};
    std::uint64_t before = 1; // the digits so far, after a 1
    for (int i = 0; i < digits_of_base[base]; ++i) {
        const auto place = static_cast<std::size_t>(i);
        const auto words = philox({static_cast<std::uint32_t>(before), static_cast<std::uint32_t>(before >> 32),
                                   static_cast<std::uint32_t>(axis), 0},
                                  stream);
        std::array<std::uint32_t, 5> permutation{0, 1, 2, 3, 4};
        for (std::uint32_t k = base; k > 1; --k)
            std::swap(permutation[k - 1], permutation[static_cast<std::uint64_t>(words[k - 2]) * k >> 32]);
        result[place] = permutation[digits[place]];
        before = before * base + digits[place];
    }
    return result;
}

/// The columns of the generator matrices as numbers of 32 bits: the direction numbers times 2^-i.
using Directions = std::array<std::uint32_t, 32>;

/// A primitive polynomial has a degree and the inner coefficients `a`; its directions follow from its first odd numbers
/// m.
template <std::size_t Degree>
Directions directions_of(std::uint32_t a, const std::array<std::uint32_t, Degree>& m)
{
    Directions v{};
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (i < Degree) {
            v[i] = m[i] << (31 - i);
            continue;
        }
        v[i] = v[i - Degree] ^ v[i - Degree] >> Degree;
        for (std::size_t k = 1; k < Degree; ++k)
            if (a >> (Degree - 1 - k) & 1) v[i] ^= v[i - k];
    }
    return v;
}

const std::array<Directions, 3>& sobol_directions()
{
    static const std::array<Directions, 3> all = [] {
        Directions first{};
        for (std::size_t i = 0; i < 32; ++i) first[i] = 0x80000000U >> i;
        return std::array{first, directions_of<1>(0, {1}), directions_of<2>(1, {1, 3})};
    }();
    return all;
}

Digits bits_of(std::uint32_t number)
{
    Digits digits{};
    for (std::size_t i = 0; i < 32; ++i) digits[i] = number >> (31 - i) & 1;
    return digits;
}

constexpr auto nested = "nested";

/// The coordinates of a sequence, scrambled or not.
class SequenceSampler final : public Sampler
{
public:
    SequenceSampler(const SampleRequest& request, bool is_sobol, bool is_scrambled)
        : request_(request), is_sobol_(is_sobol), is_scrambled_(is_scrambled)
    {}

    PointSet sample(std::uint32_t realization) override
    {
        const StreamKey stream = stream_key(request_.seed, Purpose::digit_scrambling, realization);
        PointSet set{request_.dimension, {}};
        for (std::uint32_t i = 0; i < request_.points; ++i)
            for (int axis = 0; axis < request_.dimension; ++axis)
                set.coordinates.push_back(coordinate(i, axis, stream) / 4294967296.0);
        return set;
    }

private:
    std::uint32_t coordinate(std::uint32_t index, int axis, const StreamKey& stream) const
    {
        const std::uint32_t base = is_sobol_ ? 2 : halton_bases[static_cast<std::size_t>(axis)];
        const Digits digits = is_sobol_ ? bits_of(sobol_coordinate(index, axis)) : inverse_digits(index, base);
        return number_of(is_scrambled_ ? scrambled(digits, base, axis, stream) : digits, base);
    }

    SampleRequest request_;
    bool is_sobol_, is_scrambled_;
};

SamplerSpec sequence_sampler(bool is_sobol)
{
    SamplerSpec spec = plain_spec(is_sobol ? "sobol" : "halton", is_sobol ? "Sobol sequence" : "Halton sequence",
                                  is_sobol ? "the Sobol sequence, a low discrepancy net for powers of two"
                                           : "the Halton sequence, radical inverses in the bases 2, 3 (and 5)",
                                  {2, 3},
                                  {{.key = "scrambling",
                                    .kind = ParameterSpec::Kind::choice,
                                    .help = "random permutations of digits, nested as Owen's, or the sequence itself",
                                    .choices = {nested, "none"},
                                    .otherwise = std::string(nested)}});
    spec.is_deterministic = [](const Parameters& parameters) { return parameters.text("scrambling") != nested; };
    spec.create = [is_sobol](const Parameters& parameters, const SampleRequest& request, Engine,
                             const DeviceProvider&) {
        return std::make_unique<SequenceSampler>(request, is_sobol, parameters.text("scrambling") == nested);
    };
    return spec;
}

}

std::uint32_t sobol_coordinate(std::uint32_t index, int axis)
{
    const Directions& directions = sobol_directions()[static_cast<std::size_t>(axis)];
    std::uint32_t result = 0;
    for (std::size_t i = 0; index > 0; ++i, index >>= 1)
        if (index & 1) result ^= directions[i];
    return result;
}

SamplerSpec sobol_sampler() { return sequence_sampler(true); }
SamplerSpec halton_sampler() { return sequence_sampler(false); }

}
