// Tiles on standard output: rows of indices as words, or as one JSON object.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>
#include <string>

namespace poissonlab {

/// Prints rows from north to south, some tiles at a time, so that windows may be larger than memory.
class TileRows
{
public:
    /// `blocks` is what JSON calls lists of several tables, "layers"; empty: there is one, "tiles".
    explicit TileRows(bool as_json, const std::string& blocks = "");

    /// The next tiles of a row. Throws Interrupted, and StorageError where standard output takes no more.
    template <class Tile>
    void add(std::span<const Tile> tiles, bool ends_row)
    {
        add_words(fmt::format("{}", fmt::join(tiles, as_json_ ? ", " : " ")), ends_row);
    }

    /// The next rows are those of another table.
    void next_block();

    /// Ends the output. It is called after the last row.
    void finish();

private:
    void add_words(const std::string& words, bool ends_row);
    void write(const std::string& text) const;

    bool as_json_;
    bool has_blocks_;
    bool is_first_row_ = true;  ///< of its table
    bool is_row_begun_ = false; ///< some of its tiles are printed
};

}
