#include "host/distribution/distribution_run.hpp"

#include "base/densities/density_text.hpp"
#include "base/errors/errors.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>

namespace poissonlab {
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
