// The sampler "command": any program that writes a point set to a file.
#pragma once

#include "host/sampling/sampler.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

SamplerSpec command_sampler();

/// The values of the fields {points}, {dimension}, {seed}, {realization} and {out} of a command.
struct CommandValues
{
    std::size_t points = 0;
    int dimension = 2;
    std::uint32_t seed = 0;
    std::uint32_t realization = 0;
    std::string out;
};

/// The words of a command with fields replaced, {{word}} by {word}. Throws InputError, a sentence without a
/// place: no words, quotes without an end, unknown fields, no {out}.
std::vector<std::string> command_words(const std::string& command, const CommandValues& values);

/// The seed that a program is given: 1 to 2^31 - 1, so that every language's generator takes it.
std::uint32_t command_seed(std::uint64_t seed, std::uint32_t realization);

}
