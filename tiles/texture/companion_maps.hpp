// Companions of a texture set: pictures that lie over its exemplar, which its tiles show at the same sources.
//
// A renderer wants the normals, heights and roughness of a surface beside its colours, cut along the same curves. Their
// numbers are copied, never converted, so that each pixel of an atlas has the bits of the picture's pixel.
#pragma once

#include "tiles/texture/texture_set.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

/// A companion called `name`: its files are exemplar-NAME and atlas-NAME, with the ending of its numbers.
CompanionMap companion_map(const std::string& name, RawPicture picture, bool is_original = false);

/// Gives a companion another picture, of the same numbers.
void set_picture(CompanionMap& companion, RawPicture picture);

/// The pixels of the picture at the sources of all tiles, which lie as in atlas.png; 0 where there is no tile.
RawPicture companion_atlas(const TextureSet& set, const RawPicture& picture);

/// Writes the two files of each companion, where `place` says for their names. Throws StorageError.
void write_companions(const std::function<std::filesystem::path(const std::string& name)>& place,
                      const TextureSet& set);

/// Removes the files of companions that a set stored in the folder has and `set` has not: they would be those of other
/// sources. Files that cannot be read or removed stay.
void remove_other_companions(const std::filesystem::path& folder, const TextureSet& set);

/// Proves that each pixel of a stored atlas has the bits of the stored picture at its source, and returns how many
/// pixels those are. Throws InputError that names the first file or pixel of which it is not so.
std::size_t certify_companion(const std::filesystem::path& folder, const TextureSet& set, const CompanionMap& map);

}
