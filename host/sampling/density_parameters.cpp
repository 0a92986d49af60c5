#include "host/sampling/density_parameters.hpp"

#include "base/densities/density_text.hpp"
#include "base/densities/density_values.hpp"
#include "base/files/file_kind.hpp"
#include "base/files/xxh64_bytes.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace poissonlab {
namespace {

constexpr const char* density_key = "density";
constexpr const char* channel_key = "density_from";

/// The path from the config's folder, where that is a file.
std::string resolved_density(const Parameters& given)
{
    const std::string& text = given.text(density_key);
    const SourceLocation& where = given.location(density_key);
    if (where.is_argument) return text;
    const std::string path = (std::filesystem::path(where.file).parent_path() / text).string();
    return is_file_name(path) ? path : text;
}

}

std::vector<ParameterSpec> density_parameters()
{
    using Kind = ParameterSpec::Kind;
    return {{.key = density_key,
             .kind = Kind::text,
             .help = "the density that points follow: a picture, or a formula in x and y from -1 to 1",
             .unless_given = "the same everywhere"},
            {.key = channel_key,
             .kind = Kind::text,
             .help = "light, ink or a channel of a picture",
             .otherwise = std::string("light")}};
}

std::optional<Density> given_density(const Parameters& given)
{
    if (!given.is_given(density_key)) {
        if (given.is_given(channel_key)) throw given.error(channel_key, "is for a density, and none is given");
        return std::nullopt;
    }
    const std::string text = resolved_density(given), channel = given.text(channel_key);
    if (given.is_given(channel_key) && channel != "light" && !is_file_name(text))
        throw given.error(channel_key,
                          fmt::format("is for pictures, and density = \"{}\" is none", shortened(printable(text))));
    try {
        Density density = density_of_text(text, channel, 1, 1);
        if (density.width != density.height)
            throw InputError(fmt::format("has {} x {} pixels: must be square", density.width, density.height));
        return density;
    } catch (const UnknownChannel& error) {
        throw given.error(channel_key, error.what());
    } catch (const InputError& error) {
        throw given.error(density_key, error.what());
    }
}

std::uint64_t density_hash(const Parameters& given)
{
    const auto density = given_density(given);
    if (!density) return 0;
    Xxh64 hash(static_cast<std::uint64_t>(density->width));
    hash.add({reinterpret_cast<const char*>(density->weights.data()), // NOLINT: bytes of this machine's results
              density->weights.size() * sizeof(std::uint64_t)});
    return hash.value();
}

}
