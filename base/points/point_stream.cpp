#include "base/points/point_stream.hpp"

#include "base/errors/errors.hpp"
#include "base/files/mapped_file.hpp"
#include "base/files/text_lines.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/flat_points.hpp"
#include "base/points/hdf5_reading.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/programs/interrupt.hpp"
#include "base/text/plain_text.hpp"

#include <array>
#include <fstream>
#include <string>

namespace poissonlab {
namespace {

/// A point of text has two numbers, a blank and the end of a line, and mostly many digits.
constexpr std::uint64_t least_text_bytes = 16;

std::string begin_of(const std::filesystem::path& path)
{
    std::array<char, 8> bytes{};
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), bytes.size());
    return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

/// Does text hold one set: is there no line with # alone between points?
bool has_one_set(MappedFile& text)
{
    bool has_points = false, has_ended = false;
    for (LineReader lines(text.bytes()); lines.next();) {
        const std::string_view line = trimmed(lines.line());
        if (lines.number() % 65536 == 0) text.release_before(lines.rest().data());
        if (line == "#") {
            has_ended = has_points;
        } else if (!line.empty() && line.front() != '#') {
            if (has_ended) return false;
            has_points = true;
        }
    }
    return true;
}

}

bool can_be_streamed(const std::filesystem::path& path)
{
    if (is_no_lasting_file(path)) return false;
    const std::string begin = begin_of(path);
    if (begin.starts_with(hdf5_magic)) return true;
    if (begin.starts_with(utk_magic) || begin.starts_with(swapped_utk_magic)) return false;
    if (begin.starts_with(ply_magic) && begin.size() > 3 && (begin[3] == '\n' || begin[3] == '\r')) return false;
    MappedFile mapped(path);
    if (begin.starts_with(npy_magic)) return shape_of_npy_sets({path.string(), mapped.bytes()}).sets == 1;
    return has_one_set(mapped);
}

std::optional<KnownShape> known_shape(const std::filesystem::path& path, const PointReading& how)
{
    const std::string begin = begin_of(path);
    if (begin.starts_with(hdf5_magic)) {
        const Hdf5Head head = head_of_hdf5_points(path, how);
        return KnownShape{head.points, head.dimension};
    }
    if (!begin.starts_with(npy_magic)) return std::nullopt;
    const MappedFile mapped(path);
    const NpyShape shape = shape_of_npy_sets({path.string(), mapped.bytes()});
    return KnownShape{shape.points, shape.dimension};
}

std::uint64_t points_at_most(const std::filesystem::path& path, const PointReading& how)
{
    if (const auto shape = known_shape(path, how)) return shape->points;
    return std::filesystem::file_size(path) / least_text_bytes + 1;
}

PointStrips read_into_strips(const std::filesystem::path& path, const PointReading& how,
                             const std::filesystem::path& folder,
                             const std::function<void(std::span<const double> coordinates)>& told)
{
    const std::uint64_t expected = points_at_most(path, how);
    std::optional<PointStrips> strips;
    FlatAxes flat;
    const auto take = [&](int dimension, std::span<const double> coordinates) {
        stop_if_interrupted();
        if (!strips) strips.emplace(folder, dimension, expected);
        flat.add(dimension, coordinates);
        strips->add(coordinates);
        told(coordinates);
    };
    const auto check = [&](const PointDomain& domain) {
        if (domain.dimension() > 0)
            throw InputError::at({path.string()}, "declares a range for each axis; points that are read in pieces have "
                                                  "one for all axes");
    };
    const std::string begin = begin_of(path);
    if (begin.starts_with(hdf5_magic)) {
        check(head_of_hdf5_points(path, how).domain);
        stream_hdf5_points(path, how,
                           [&](int dimension, std::span<const double> piece, const char*) { take(dimension, piece); });
    } else {
        MappedFile mapped(path);
        const bool is_npy = begin.starts_with(npy_magic);
        check_no_particles(how, path);
        PointFileContent file{path.string(), mapped.bytes(), {}, how.told, how.options};
        if (!is_npy) file.bytes = plain_text(file.name, file.bytes);
        file.domain = how.domain ? *how.domain : is_npy ? PointDomain{} : declared_domain(file);
        check(file.domain);
        const auto sink = [&](int dimension, std::span<const double> piece, const char* done) {
            take(dimension, piece);
            mapped.release_before(done);
        };
        if (is_npy)
            stream_npy_points(file, sink);
        else
            stream_text_points(file, sink);
    }
    strips->finish();
    if (strips->size() > 1 && flat.axis())
        throw InputError::at({path.string()},
                             "all points have one coordinate in common: to be read in pieces, points of "
                             "the plane must have two");
    return std::move(*strips);
}

}
