// Advice in words, and as JSON.
#pragma once

#include "host/texture/advice/texture_advice.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// OpenAdvice marks the choices that the user left open: advice covers only these.
struct OpenAdvice
{
    bool colors = true;
    bool joint = true;
    bool straighten = true;
    bool flatten = true;
    bool is_light_said = false; ///< texture build says by itself what it flattens
};

/// Sentences that say what to do with the picture, and why; the first one is about whether to tile it.
std::vector<std::string> advice_lines(const TextureAdvice& advice, const OpenAdvice& open = {});

/// The advice as a JSON object.
std::string advice_json(const TextureAdvice& advice);

/// A line that says where a request is against the advice; empty where it is not.
std::string advice_note(const TextureAdvice& advice, const TextureRequest& request, const OpenAdvice& open = {});

}
