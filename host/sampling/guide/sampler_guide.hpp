// Advice for choosing a method: where each comes from, when to use it, and when not.
#pragma once

#include <string>

namespace poissonlab {

struct SamplerGuide
{
    std::string sampler; ///< its name in configs
    std::string source;  ///< the paper or book that describes it
    std::string use;     ///< sentences: when to use it
    std::string avoid;   ///< sentences: when not, and what to take then
};

/// The guide to a sampler. Throws std::out_of_range for names without one; a test finds samplers that lack theirs.
const SamplerGuide& sampler_guide(const std::string& sampler);

/// The first sentence of a text.
std::string first_sentence(const std::string& text);

}
