#include "host/distribution/distribution_run.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/kinds.hpp"
#include "host/schemes/scheme_run.hpp"
#include "results/file_names.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Calls the function of a config's kind.
struct MakeKind
{
    const DistributionConfig& config;
    const DistributionPlace& place;
    DistributionFiles& files;

    DistributionResult operator()(const KindSettings& settings) const
    {
        return find_kind("distribution", config.kind)->make(settings, config.seed, place, files);
    }
    DistributionResult operator()(const SchemeSettings& settings) const
    {
        return make_scheme(settings, config.seed, files);
    }
    DistributionResult operator()(const TextureSettings& settings) const
    {
        return make_texture(settings, place, files);
    }
    DistributionResult operator()(const PackingSettings& settings) const { return make_packing(settings, files); }
};

/// Throws InputError for a number that results cannot hold: settings far out may lead there.
void check_numbers(const std::vector<DistributionNumber>& numbers)
{
    for (const DistributionNumber& number : numbers)
        if (!std::isfinite(number.value) || !std::isfinite(number.standard_error.value_or(0)))
            throw InputError(fmt::format("\"{}\" is {}, and must be a finite number", number.title, number.value));
}

std::string numbers_text(const std::vector<DistributionNumber>& numbers)
{
    std::string text = "key,value\n";
    for (const DistributionNumber& number : numbers) text += fmt::format("{},{}\n", number.key, number.value);
    return text;
}

}

DistributionResult make_distribution(const DistributionConfig& config, const DistributionPlace& place,
                                     DistributionFiles& files)
{
    try {
        DistributionResult result = std::visit(MakeKind{config, place, files}, config.settings);
        check_numbers(result.numbers);
        write_whole_file(files.add(file_names::distribution_numbers), numbers_text(result.numbers));
        result.files.push_back(file_names::distribution_numbers);
        return result;
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        const bool has_own_table = config.kind == "texture" || config.kind == "packing";
        const std::string table = config.is_scheme() ? "scheme" : has_own_table ? config.kind : "distribution";
        throw InputError::at(config.where, fmt::format("[[{}]]: {}", table, error.what()));
    }
}

Density chosen_density(const DensityChoice& choice) { return density_of_text(choice.text, choice.from, 1, 1); }

EvenMethod chosen_method(const EvenMethodChoice& choice)
{
    if (choice.sampler) return *choice.sampler;
    if (choice.tiles.empty()) return default_even_method();
    PoissonTileSet tiles = read_tile_set(choice.tiles);
    if (tiles.parameters.dimension != 2)
        throw InputError(fmt::format("{}: are tiles in space; must be in the plane", choice.tiles.string()));
    return tiles;
}

std::string method_words(const EvenMethodChoice& choice)
{
    if (choice.sampler) return choice.sampler->spec->title;
    return choice.tiles.empty() ? "corner tiles of 3 colours, 32 points" : choice.tiles.filename().string();
}

}
