#include "app/commands/tilings/tile_rows.hpp"

#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"

#include <cstdio>

namespace poissonlab {

TileRows::TileRows(bool as_json, const std::string& blocks) : as_json_(as_json), has_blocks_(!blocks.empty())
{
    if (as_json_) write(has_blocks_ ? fmt::format("{{\"{}\": [[", blocks) : "{\"tiles\": [");
}

void TileRows::write(const std::string& text) const
{
    stop_if_interrupted();
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
        throw StorageError("cannot write to standard output");
}

void TileRows::add_words(const std::string& words, bool ends_row)
{
    if (!as_json_) return write(words + (ends_row ? "\n" : " "));
    const std::string before = is_row_begun_ ? ", " : is_first_row_ ? "\n[" : ",\n[";
    write(before + words + (ends_row ? "]" : ""));
    is_row_begun_ = !ends_row;
    is_first_row_ = false;
}

void TileRows::next_block()
{
    write(as_json_ ? "\n],\n[" : "\n");
    is_first_row_ = true;
}

void TileRows::finish()
{
    if (as_json_) write(has_blocks_ ? "\n]]}\n" : "\n]}\n");
}

}
