// poissonlab texture tile: the picture of a window of a tiling with texture tiles.
#include "app/commands/command.hpp"
#include "app/commands/output_file.hpp"
#include "base/errors/errors.hpp"
#include "host/texture/exemplar.hpp"
#include "tiles/texture/texture_tiling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace poissonlab {
namespace {

constexpr auto texture_tile_notes =
    R"(The window is in tiles, its lower left one first. Windows of complete sets may lie anywhere, and those with the
same seed fit together; compact, omega and marked Wang tiles are laid in scanlines, and X and Y must be 0.
  poissonlab texture tile gravel --window -4 -4 12 8 --out plain.png)";

struct TextureTileOptions
{
    std::filesystem::path folder;
    std::vector<std::int64_t> window; ///< X Y W H
    std::uint64_t seed = 1;
    std::filesystem::path marks; ///< empty: corners are marked at random
    std::filesystem::path out;
};

TileWindow checked_texture_window(const std::vector<std::int64_t>& numbers)
{
    if (numbers.size() != 4)
        throw InputError(fmt::format("texture tile: --window {}: must be X Y W H", fmt::join(numbers, " ")));
    if (numbers[2] < 1 || numbers[3] < 1)
        throw InputError(fmt::format("texture tile: --window {}: sizes must be at least 1", fmt::join(numbers, " ")));
    return {numbers[0], numbers[1], static_cast<std::uint64_t>(numbers[2]), static_cast<std::uint64_t>(numbers[3])};
}

void tile_texture(const TextureTileOptions& options)
{
    const TileWindow window = checked_texture_window(options.window);
    const std::filesystem::path out = checked_output("texture tile", "--out", options.out, {{".png"}});
    const TextureSet set = read_texture_set(options.folder);
    try {
        const TextureWindow shown =
            options.marks.empty() ? texture_window(set, window, options.seed)
                                  : marked_texture_window(set, window, options.seed,
                                                          corner_marks(read_exemplar(options.marks, AlphaUse::covers),
                                                                       window.width, window.height));
        write_texture_window(out, set, shown);
    } catch (const InputError& error) {
        throw error.moved_to({"texture tile"});
    }
}

}

Command texture_tile_command()
{
    const auto o = std::make_shared<TextureTileOptions>();
    return {"tile",
            "Draw a window of a tiling with texture tiles",
            {{"DIR", &o->folder, "The folder of a texture set, from texture build"},
             {"--window", &o->window, "The tiles to draw: lower left one, width and height", "X Y W H", required, 4},
             {"--seed", &o->seed, "The seed of the tiling; default: 1", "S"},
             {"--marks", &o->marks,
              "For tiles with marked corners: a picture over the window, marked where it is light", "PICTURE"},
             {"--out", &o->out, "The picture (.png)", "PICTURE", required}},
            texture_tile_notes,
            action_on(o, tile_texture)};
}

}
