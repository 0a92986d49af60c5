#include "host/texture/exemplar_pictures.hpp"

#include "base/errors/errors.hpp"
#include "host/texture/exemplar.hpp"
#include "host/texture/flattening.hpp"
#include "host/texture/regular/straightening.hpp"
#include "tiles/texture/companion_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

/// True if 8 bits do not hold the numbers of an exemplar, and they can be kept.
bool is_deep(const PictureHeader& header) { return is_kept_raw(header) && *header.type != SampleType::byte; }

std::string companion_name(const fs::path& file) { return file.stem().string(); }

void add_note(std::vector<std::string>& notes, const std::string& note)
{
    if (!note.empty()) notes.push_back(note);
}

/// Both originals side by side as the exemplars are; nothing where they have different numbers or channels.
std::optional<RawPicture> originals_side_by_side(const RawPicture& first, const RawPicture& second)
{
    if (first.type != second.type || first.channels != second.channels) return {};
    RawPicture both{first.width + second.width, std::min(first.height, second.height), first.type, first.channels, {}};
    for (int row = 0; row < both.height; ++row)
        for (const RawPicture* one : {&first, &second})
            both.bytes.insert(both.bytes.end(), one->bytes.begin() + static_cast<std::ptrdiff_t>(one->at(0, row)),
                              one->bytes.begin() + static_cast<std::ptrdiff_t>(one->at(0, row + 1)));
    return both;
}

/// Numbers of more than 8 bits that no file of a set holds: nothing is said of others.
std::string lost_depth_note(const fs::path& file, const PictureHeader& header)
{
    if (is_kept_raw(header) || header.type == SampleType::byte) return "";
    return fmt::format("{}: tiles have 8 bits: only of 16 bits in at most 4 channels, float16 and float32 more is kept",
                       printable(file.filename().string()));
}

/// The exemplar's own numbers, where they have more than 8 bits.
void add_original(const fs::path& exemplar, const fs::path& marked, ExemplarPictures& pictures)
{
    const PictureHeader header = read_picture_header(exemplar);
    add_note(pictures.notes, lost_depth_note(exemplar, header));
    const bool is_first_deep = is_deep(header);
    const bool is_second_deep = !marked.empty() && is_deep(read_picture_header(marked));
    std::optional<RawPicture> original;
    if (is_first_deep && marked.empty()) original = read_raw_picture(exemplar);
    if (is_first_deep && is_second_deep)
        original = originals_side_by_side(read_raw_picture(exemplar), read_raw_picture(marked));
    if (original)
        pictures.companions.push_back(companion_map(companion_name(exemplar), std::move(*original), true));
    else if (is_first_deep || is_second_deep)
        pictures.notes.push_back(fmt::format("{} and {} have different numbers or channels: tiles have 8 bits",
                                             printable(exemplar.filename().string()),
                                             printable(marked.filename().string())));
}

}

void check_companions(const fs::path& exemplar, const std::vector<fs::path>& also)
{
    const PictureHeader asked = read_picture_header(exemplar);
    std::map<std::string, fs::path> files;
    if (is_deep(asked)) files[companion_name(exemplar)] = exemplar;
    for (const fs::path& file : also) {
        const PictureHeader header = read_picture_header(file);
        const auto [same, is_new] = files.emplace(companion_name(file), file);
        if (!is_new)
            throw InputError(fmt::format("{}: is called as {} is: both would be atlas-{}", printable(file.string()),
                                         printable(same->second.string()), printable(same->first)));
        if (header.width != asked.width || header.height != asked.height)
            throw InputError(fmt::format("{}: {} x {} pixels: must have {} x {}, as {} has", printable(file.string()),
                                         header.width, header.height, asked.width, asked.height,
                                         printable(exemplar.string())));
        if (!is_kept_raw(header))
            throw InputError(fmt::format("{}: must have numbers of 8 or 16 bits in at most 4 channels, or of float16 "
                                         "or float32",
                                         printable(file.string())));
    }
}

ExemplarPictures read_exemplar_pictures(const fs::path& exemplar, const fs::path& marked_exemplar,
                                        const std::vector<fs::path>& also)
{
    ExemplarPictures pictures;
    std::string note;
    pictures.exemplar = read_exemplar(exemplar, note);
    add_note(pictures.notes, note);
    if (!marked_exemplar.empty()) {
        pictures.split = pictures.exemplar.width;
        pictures.exemplar = side_by_side(pictures.exemplar, read_exemplar(marked_exemplar, note));
        add_note(pictures.notes, note);
    }
    add_original(exemplar, marked_exemplar, pictures);
    if (!also.empty()) check_companions(exemplar, also);
    for (const fs::path& file : also)
        pictures.companions.push_back(companion_map(companion_name(file), read_raw_picture(file)));
    return pictures;
}

void straighten(ExemplarPictures& pictures, int size)
{
    const Straightening map = straightening_for(pictures.exemplar, size);
    pictures.exemplar = straightened(pictures.exemplar, map);
    for (CompanionMap& companion : pictures.companions) set_picture(companion, straightened(companion.picture, map));
    pictures.notes.push_back(straightening_note(map));
}

void flatten(ExemplarPictures& pictures, int size, std::optional<bool> is_asked)
{
    // Pictures of marked corners have a light of their own, and those that are smaller than a tile make no tiles.
    if (pictures.split > 0 || std::min(pictures.exemplar.width, pictures.exemplar.height) < size) return;
    const UnevenLight light = uneven_light(pictures.exemplar, size);
    if (!light.is_uneven() && !is_asked.value_or(false)) return;
    const std::string differs =
        fmt::format("the light differs over more than a tile: {:.0f} % of its variation", 100 * light.share);
    if (!is_asked.value_or(true)) {
        pictures.notes.push_back(differs + "; bright and dark parts show as a pattern (--flatten evens them)");
        return;
    }
    std::size_t clipped = 0;
    pictures.exemplar = flattened(pictures.exemplar, size, clipped);
    bool has_others = false;
    for (CompanionMap& companion : pictures.companions) {
        if (companion.is_original) set_picture(companion, flattened(companion.picture, size, clipped));
        has_others = has_others || !companion.is_original;
    }
    pictures.notes.push_back(fmt::format("{}; it is evened{}{}{}", differs, is_asked ? "" : " (--flatten off keeps it)",
                                         clipped > 0 ? fmt::format("; {} values are clipped", clipped) : "",
                                         has_others ? "; companions stay as they are" : ""));
    pictures.is_flattened = true;
}

}
