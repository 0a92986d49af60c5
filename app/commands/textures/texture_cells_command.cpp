// poissonlab texture cells: a window of an endless map of cells, for editors of maps as well.
#include "app/commands/kind_options.hpp"
#include "base/files/whole_file.hpp"
#include "host/distribution/cells/cell_files.hpp"
#include "host/kinds/kinds.hpp"

namespace poissonlab {
namespace {

constexpr auto texture_cells_notes =
    R"(ALPHABET is a TOML file with a drawing for each combination of the colours of a cell's corners, or a rule that draws
them: docs/cells.md. Two colours are the 16 tiles of marching squares. A hash of each corner's place and the seed gives its
colour, so that any window of the endless map can be made, and those with the same seed fit together.
--out, as often as you like:
  .png  the picture
  .tmx  a map of Tiled; FILE-tiles.png beside it has the cells, which Tiled knows as a terrain of corners
  .csv  the cells' numbers in that picture, from 0, a line a row
  poissonlab texture cells configs/alphabets/dungeon.toml --window 0 0 60 34 --out dungeon.png --out dungeon.tmx)";

struct TextureCellsOptions : KindOptions
{
    using KindOptions::KindOptions;
};

std::filesystem::path picture_beside(const std::filesystem::path& map)
{
    return map.parent_path() / (map.stem().string() + "-tiles.png");
}

/// Refuses files of which one would take the place of another's picture.
void check_pictures(const std::vector<std::string>& files)
{
    for (const std::filesystem::path map : files)
        for (const std::filesystem::path other : files)
            if (map.extension() == ".tmx" && other.lexically_normal() == picture_beside(map).lexically_normal())
                throw InputError(fmt::format("texture cells: --out {}: is the name of the picture of {}",
                                             other.string(), map.string()));
}

void draw_cells(const TextureCellsOptions& o)
{
    const KindSettings read = o.settings();
    o.outs.check(o.command());
    check_pictures(o.outs.names);
    const DrawnCells drawn = drawn_cells(read.as<CellSettings>(), o.seed());
    for (const std::filesystem::path& file : o.outs.files()) {
        if (file.extension() == ".png") write_cell_map(file, drawn.alphabet, drawn.map);
        if (file.extension() == ".csv") write_whole_file(file, cell_numbers(drawn.alphabet, drawn.map));
        if (file.extension() != ".tmx") continue;
        const std::filesystem::path picture = picture_beside(file);
        write_cell_map(picture, drawn.alphabet, packed_cells(drawn.alphabet.colors()));
        write_whole_file(file, tiled_map(drawn.alphabet, drawn.map, picture.filename().string()));
    }
    if (o.prints_json()) print_numbers(cell_counts(drawn));
}

}

Command texture_cells_command()
{
    const auto o = std::make_shared<TextureCellsOptions>(
        *find_kind("distribution", "cells"), OutputFiles{{{".png", ".tmx", ".csv"}, false, false, ".tmx"}}, "alphabet");
    return kind_command(o, {o->outs.option()}, texture_cells_notes, draw_cells);
}

}
