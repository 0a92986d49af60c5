#include "base/particles/snapshot_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace poissonlab {
namespace {

/// Whole numbers of an attribute of the header, one for each type of particles.
std::optional<ParticleCounts> counts_in_header(hid_t file, const char* name)
{
    const auto numbers = group_numbers(file, "Header", name);
    if (!numbers) return std::nullopt;
    if (numbers->size() < 2)
        throw InputError(
            fmt::format("the attribute Header/{} is one number: must have one for each type of particles", name));
    ParticleCounts counts{};
    for (std::size_t i = 0; i < numbers->size(); ++i) {
        const double number = (*numbers)[i];
        if (!(number >= 0 && number < 0x1p63) || number != std::floor(number))
            throw InputError(fmt::format("the attribute Header/{} has {}: must be numbers of particles", name, number));
        if (i < counts.size()) counts[i] = static_cast<std::uint64_t>(number);
    }
    return counts;
}

/// The total of all files. Where it is larger than 2^32 its upper half may be apart.
std::optional<ParticleCounts> total_in_header(hid_t file)
{
    auto total = counts_in_header(file, "NumPart_Total");
    const auto high = counts_in_header(file, "NumPart_Total_HighWord");
    if (!total || !high) return total;
    constexpr std::uint64_t low_word = 0xffffffff;
    for (std::size_t type = 0; type < particle_types; ++type)
        if ((*high)[type] > 0) (*total)[type] = ((*high)[type] << 32) | ((*total)[type] & low_word);
    return total;
}

std::uint64_t files_in_header(hid_t file)
{
    const auto number = group_numbers(file, "Header", "NumFilesPerSnapshot");
    if (!number) return 1;
    if (number->size() != 1 || !(number->front() >= 1 && number->front() <= 1e6) ||
        number->front() != std::floor(number->front()))
        throw InputError(fmt::format("the attribute Header/NumFilesPerSnapshot is {}: must be a number of files",
                                     fmt::join(*number, ", ")));
    return static_cast<std::uint64_t>(number->front());
}

/// Rows of the coordinates that are there; other shapes are refused when they are read.
std::uint64_t rows_of_type(hid_t file, std::size_t type)
{
    if (!has_link(file, fmt::format("PartType{}", type)) || !has_link(file, coordinates_of_type(type))) return 0;
    const std::string name = coordinates_of_type(type);
    const Hdf5Object set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name.c_str());
    const Hdf5Object space(H5Dget_space(set), H5Sclose, name.c_str());
    std::array<hsize_t, H5S_MAX_RANK> extent{};
    return H5Sget_simple_extent_dims(space, extent.data(), nullptr) < 1 ? 0 : extent[0];
}

/// Does this file have all particles, however many files its header names? SWIFT writes such a file beside the parts.
bool is_whole(const SnapshotPart& part) { return part.total && *part.total == part.rows; }

/// NAME.3.hdf5 for the part of that number; `named` is the number in the name that is there.
std::filesystem::path name_of_part(const std::filesystem::path& path, const std::string& named, std::uint64_t number)
{
    const std::string stem = path.stem().string();
    const std::string begin = stem.substr(0, stem.size() - named.size());
    const auto name = [&](const std::string& digits) {
        return path.parent_path() / (begin + digits + path.extension().string());
    };
    const auto padded = name(fmt::format("{:0{}}", number, named.size()));
    return std::filesystem::exists(padded) ? padded : name(std::to_string(number));
}

/// The digits behind the last point of NAME.3.hdf5.
std::string number_in_name(const std::filesystem::path& path)
{
    const std::string stem = path.stem().string();
    const std::size_t point = stem.rfind('.');
    const std::string digits = point == stem.npos ? "" : stem.substr(point + 1);
    return digits.find_first_not_of("0123456789") == digits.npos && digits.size() < 8 ? digits : "";
}

SnapshotPart open_part(const std::filesystem::path& path)
{
    const Hdf5Object file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
    return read_snapshot_part(path, file);
}

/// Sees that a file belongs to the snapshot of the first one.
void check_part(const SnapshotPart& part, const SnapshotPart& first)
{
    const char* differs = part.files != first.files           ? "Header/NumFilesPerSnapshot"
                          : part.total != first.total         ? "Header/NumPart_Total"
                          : part.box.sides != first.box.sides ? "BoxSize"
                                                              : nullptr;
    if (differs)
        throw InputError(
            fmt::format("is of another snapshot than {}: {} differs", printable(first.path.string()), differs));
}

void check_rows(const SnapshotPart& part, std::size_t type)
{
    if (part.said && (*part.said)[type] != part.rows[type])
        throw InputError::at({part.path.string()},
                             fmt::format("{} has {} rows, and Header/NumPart_ThisFile says {}",
                                         coordinates_of_type(type), part.rows[type], (*part.said)[type]));
}

/// "PartType0 (4096 particles)" for all types that are there or named by the header.
std::vector<std::string> types_in_words(const ParticleCounts& rows, const ParticleCounts& total)
{
    std::vector<std::string> words;
    for (std::size_t type = 0; type < particle_types; ++type)
        if (rows[type] > 0 || total[type] > 0) words.push_back(fmt::format("PartType{} ({})", type, rows[type]));
    return words;
}

}

std::string coordinates_of_type(std::size_t type) { return fmt::format("PartType{}/Coordinates", type); }

BoxSides read_box(hid_t file)
{
    for (const std::string group : {"Header", "Parameters", "Cosmology"}) try {
            if (const auto sides = group_numbers(file, group, "BoxSize")) return {*sides, group + "/BoxSize"};
        } catch (const InputError& error) {
            return {{}, group + "/BoxSize", error.what()};
        }
    return {};
}

SnapshotPart read_snapshot_part(const std::filesystem::path& path, hid_t file)
{
    SnapshotPart part{.path = path};
    for (std::size_t type = 0; type < particle_types; ++type) part.rows[type] = rows_of_type(file, type);
    part.said = counts_in_header(file, "NumPart_ThisFile");
    part.total = total_in_header(file);
    part.files = files_in_header(file);
    part.box = read_box(file);
    return part;
}

std::pair<std::vector<std::filesystem::path>, std::filesystem::path> names_of_parts(const SnapshotPart& part)
{
    const std::string number = number_in_name(part.path);
    if (part.files == 1 || is_whole(part) || number.empty()) return {{part.path}, {}};
    std::vector<std::filesystem::path> names;
    for (std::uint64_t i = 0; i < part.files; ++i) {
        names.push_back(name_of_part(part.path, number, i));
        if (!std::filesystem::exists(names.back())) return {{part.path}, names.back()};
    }
    return {names, {}};
}

std::vector<SnapshotPart> read_snapshot(const std::filesystem::path& path)
{
    const SnapshotPart named = open_part(path);
    if (named.files == 1 || is_whole(named)) return {named};
    const auto [names, missing] = names_of_parts(named);
    if (!missing.empty())
        throw InputError::at({path.string()}, fmt::format("is one of {} files of a snapshot, and {} is missing",
                                                          named.files, printable(missing.string())));
    if (names.size() == 1)
        throw InputError::at({path.string()},
                             fmt::format("is one of {} files of a snapshot, and its name does not say which: must end "
                                         "in .0.hdf5 to .{}.hdf5",
                                         named.files, named.files - 1));
    std::vector<SnapshotPart> parts;
    for (const auto& name : names) {
        try {
            parts.push_back(open_part(name));
            check_part(parts.back(), parts.front());
        } catch (const Hdf5Failure& failure) {
            throw InputError::at({name.string()}, "cannot be read as HDF5: " + failure.cause());
        } catch (const InputError& error) {
            throw InputError::at({name.string()}, error.what());
        }
    }
    return parts;
}

std::size_t type_of_points(const std::vector<SnapshotPart>& parts, const PointReading& how)
{
    ParticleCounts rows{};
    for (const SnapshotPart& part : parts)
        for (std::size_t type = 0; type < particle_types; ++type) rows[type] += part.rows[type];
    const ParticleCounts total = parts.front().total.value_or(ParticleCounts{});
    const std::vector<std::string> present = types_in_words(rows, total);
    const auto is_there = [&](std::size_t type) { return rows[type] > 0 || total[type] > 0; };
    std::size_t chosen = particle_types;
    if (how.particles) {
        chosen = *how.particles < 0 ? particle_types : static_cast<std::size_t>(*how.particles);
        if (chosen >= particle_types || !is_there(chosen))
            throw InputError(fmt::format("has no particles of type {}; it has {}", *how.particles,
                                         present.empty() ? "none" : fmt::format("{}", fmt::join(present, ", "))));
    } else {
        if (present.empty()) throw InputError("no points: must be at least 1");
        if (present.size() > 1)
            throw InputError(
                fmt::format("has several types of particles, {}: one must be chosen{}", fmt::join(present, ", "),
                            *how.options.particles == '\0'
                                ? ""
                                : ", as by " + fmt::format(fmt::runtime(how.options.particles), present.front()[8])));
        for (chosen = 0; !is_there(chosen);) ++chosen;
    }
    for (const SnapshotPart& part : parts) check_rows(part, chosen);
    if (parts.front().total && rows[chosen] != total[chosen])
        throw InputError(fmt::format("{} has {} rows{}, and Header/NumPart_Total says {}", coordinates_of_type(chosen),
                                     rows[chosen], parts.size() > 1 ? " in all files" : "", total[chosen]));
    return chosen;
}

}
