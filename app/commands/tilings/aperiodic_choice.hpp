// The tile set that the commands of `aperiodic` speak of: a known one or a file, and a construction of it.
#pragma once

#include "app/commands/output_file.hpp"
#include "tiles/aperiodic/corner_constructions.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace poissonlab {

/// The help explains the argument that names a set by this.
inline constexpr auto aperiodic_set_help = "culik, kari, ammann, robinson, jeandel-rao, or the file of a set";

/// A set of Wang tiles; where it was made of corner tiles, also those.
struct ChosenTiles
{
    std::string name; ///< for people: "kari", "kari, vertical construction"
    WangList wang;
    std::optional<CornerList> corners{};
};

/// A set and a construction as they were typed, and where what is made of them goes.
struct AskedTiles
{
    std::string set;
    std::string construction; ///< empty: none
    std::uint32_t repeat = 1;
    std::filesystem::path out; ///< empty: nowhere
    bool as_json = false;
};

/// A known set, or that of a file, whose warnings go to standard error. Throws InputError.
ChosenTiles chosen_set(const std::string& command, const std::string& name);

/// Throws InputError for other words than those of corner_constructions; `command` is "aperiodic convert" and so on.
CornerConstruction chosen_construction(const std::string& command, const std::string& word);

inline constexpr std::uint32_t most_repetitions = 16; ///< of a construction

/// The tiles that the construction makes of the set, as often as is asked for; the set itself without one. Throws
/// InputError also for repetitions that are not from 1 to 16, and where the construction is ambiguous before the last
/// one.
ChosenTiles constructed_tiles(const std::string& command, const AskedTiles& asked);

/// Draws tiles of the set, `columns` in a row: a tiling, or, with gaps, a set. Throws StorageError.
void write_tile_picture(const std::filesystem::path& file, const ChosenTiles& chosen, std::span<const ListPlace> places,
                        std::size_t columns, bool has_gaps);

}
