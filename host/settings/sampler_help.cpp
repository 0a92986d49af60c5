#include "host/settings/sampler_help.hpp"

#include "host/settings/parameter_values.hpp"

#include <fmt/format.h>

#include <cctype>

namespace poissonlab {

std::string default_text(const ParameterSpec& spec)
{
    const SamplerChoice* sampler = as_sampler(*spec.otherwise);
    return sampler ? sampler->spec->name : to_string(*spec.otherwise);
}

std::string meaning_of(const ParameterSpec& spec)
{
    return spec.unit.empty() ? spec.help : fmt::format("{}, in {}", spec.help, spec.unit);
}

std::string option_help(const ParameterSpec& spec)
{
    std::string text = fmt::format("{}: {}", meaning_of(spec), allowed_values(spec));
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    return spec.otherwise ? fmt::format("{}; default: {}", text, default_text(spec)) : text;
}

}
