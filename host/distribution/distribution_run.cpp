#include "host/distribution/distribution_run.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "results/file_names.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

namespace poissonlab {
namespace {

/// Calls the function of a config's kind.
struct MakeKind
{
    const DistributionConfig& config;
    const DistributionPlace& place;
    DistributionFiles& files;

    DistributionResult operator()(const WarpSettings& settings) const
    {
        return make_warped(settings, config.seed, place, files);
    }
    DistributionResult operator()(const ObjectSettings& settings) const
    {
        return make_objects(settings, config.seed, place, files);
    }
    DistributionResult operator()(const SelfSimilarSettings& settings) const
    {
        return make_self_similar_tile(settings, place, files);
    }
    DistributionResult operator()(const RankSettings& settings) const { return make_ranked(settings, files); }
};

std::string numbers_text(const std::vector<DistributionNumber>& numbers)
{
    std::string text = "key,value\n";
    for (const DistributionNumber& number : numbers) text += fmt::format("{},{}\n", number.key, number.value);
    return text;
}

}

void DistributionFiles::add_marks(const std::string& name, const MarkPicture& picture, const std::string& caption,
                                  DistributionResult& result)
{
    write_whole_file(add(name), mark_picture_json(picture));
    result.pictures.push_back({name, caption});
}

DistributionResult make_distribution(const DistributionConfig& config, const DistributionPlace& place,
                                     DistributionFiles& files)
{
    try {
        DistributionResult result = std::visit(MakeKind{config, place, files}, config.settings);
        write_whole_file(files.add(file_names::distribution_numbers), numbers_text(result.numbers));
        result.files.push_back(file_names::distribution_numbers);
        return result;
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        throw InputError::at(config.where, fmt::format("[[distribution]]: {}", error.what()));
    }
}

Density chosen_density(const DensityChoice& choice) { return density_of_text(choice.text, choice.from, 1, 1); }

EvenMethod chosen_method(const EvenMethodChoice& choice)
{
    if (choice.sampler) return *choice.sampler;
    if (choice.tiles.empty()) return default_even_method();
    return read_tile_set(choice.tiles);
}

std::string method_words(const EvenMethodChoice& choice)
{
    if (choice.sampler) return choice.sampler->spec->title;
    return choice.tiles.empty() ? "corner tiles of 3 colours, 32 points" : choice.tiles.filename().string();
}

}
