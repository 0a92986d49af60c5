#include "base/points/placed_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/output_place.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/hdf5_points.hpp"
#include "base/points/point_file_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>

#include <fcntl.h>
#include <unistd.h>

namespace poissonlab {
namespace {

bool has_npy_name(const std::filesystem::path& path) { return path.extension() == ".npy"; }

[[noreturn]] void fail_to_write(const std::filesystem::path& target, int error)
{
    throw StorageError(fmt::format("{}: cannot be written: {}", printable(target.string()), std::strerror(error)));
}

std::vector<PlacedColumn> columns_of(const std::filesystem::path& file, const std::filesystem::path& target,
                                     const PointFileHead& head)
{
    if (!has_npy_name(target)) return hdf5_columns(file, target, head);
    return {{.rows_per_chunk = std::numeric_limits<std::uint64_t>::max(),
             .chunks = {npy_header(head.points, head.dimension).size()}}};
}

std::uint64_t bytes_per_point(const std::filesystem::path& path, int dimension)
{
    const bool has_numbers = path.extension() == ".hdf5";
    return sizeof(double) * static_cast<std::uint64_t>(dimension + (has_numbers ? 1 : 0));
}

}

bool is_hdf5_name(const std::filesystem::path& path) { return path.extension() == ".h5" || is_particle_file(path); }

bool is_particle_file(const std::filesystem::path& path)
{
    return path.extension() == ".hdf5" || path.extension() == ".h5part";
}

bool has_known_places(const std::filesystem::path& path) { return has_npy_name(path) || is_hdf5_name(path); }

void check_head(const std::filesystem::path& path, const PointFileHead& head)
{
    if (is_hdf5_name(path)) check_hdf5_head(path, head);
}

void check_room(const std::filesystem::path& path, const PointFileHead& head, std::uint64_t scratch)
{
    constexpr std::uint64_t head_bytes = 4096;
    std::error_code error;
    const auto file = output_place(path).file;
    const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    const auto space = std::filesystem::space(folder, error);
    if (error || space.available == static_cast<std::uintmax_t>(-1)) return; // writing shows it
    const std::uint64_t each = bytes_per_point(path, head.dimension) + scratch;
    const std::uint64_t room = (space.available - std::min<std::uintmax_t>(space.available, head_bytes)) / each;
    if (head.points <= room) return;
    throw InputError(fmt::format("{}: {} points take {:.3g} GB, and {:.3g} GB are free there: at most {} points fit",
                                 printable(path.string()), head.points,
                                 static_cast<double>(head.points) * static_cast<double>(each) * 1e-9,
                                 static_cast<double>(space.available) * 1e-9, room));
}

void create_placed_file(const std::filesystem::path& file, const std::filesystem::path& target,
                        const PointFileHead& head)
{
    if (!has_npy_name(target)) return create_hdf5_points(file, target, head);
    const std::string header = npy_header(head.points, head.dimension);
    const int handle = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (handle < 0) fail_to_write(target, errno);
    const bool is_written = ::write(handle, header.data(), header.size()) == static_cast<ssize_t>(header.size());
    const int error = errno;
    if (::close(handle) != 0) fail_to_write(target, errno);
    if (!is_written) fail_to_write(target, error);
}

PlacedFile::PlacedFile(const std::filesystem::path& file, const std::filesystem::path& target,
                       const PointFileHead& head)
    : target_(target), dimension_(static_cast<std::size_t>(head.dimension)), side_(head.side),
      columns_(columns_of(file, target, head)), file_(::open(file.c_str(), O_WRONLY | O_CLOEXEC))
{
    if (file_ < 0) fail();
}

PlacedFile::~PlacedFile()
{
    if (file_ >= 0) ::close(file_);
}

void PlacedFile::fail() const { fail_to_write(target_, errno); }

void PlacedFile::put(std::uint64_t first, std::span<const double> coordinates) const
{
    const std::size_t rows = coordinates.size() / dimension_;
    std::vector<double> along;
    std::vector<std::uint64_t> numbers;
    for (const PlacedColumn& column : columns_) {
        switch (column.content) {
        case PlacedColumn::Content::points:
            put_rows(column, first, std::as_bytes(coordinates), dimension_ * sizeof(double));
            break;
        case PlacedColumn::Content::axis:
            along.resize(rows);
            for (std::size_t i = 0; i < rows; ++i) along[i] = coordinates[dimension_ * i + column.axis] / side_;
            put_rows(column, first, std::as_bytes(std::span(along)), sizeof(double));
            break;
        case PlacedColumn::Content::number:
            numbers.resize(rows);
            for (std::size_t i = 0; i < rows; ++i) numbers[i] = first + i + 1;
            put_rows(column, first, std::as_bytes(std::span(numbers)), sizeof(std::uint64_t));
            break;
        }
    }
}

void PlacedFile::put_rows(const PlacedColumn& column, std::uint64_t first, std::span<const std::byte> rows,
                          std::size_t row_bytes) const
{
    while (!rows.empty()) {
        const std::uint64_t chunk = first / column.rows_per_chunk, row = first % column.rows_per_chunk;
        const std::uint64_t left = column.rows_per_chunk - row;
        auto part = rows.first(row_bytes * std::min<std::uint64_t>(rows.size() / row_bytes, left));
        rows = rows.subspan(part.size());
        first += part.size() / row_bytes;
        for (std::uint64_t place = column.chunks[chunk] + row * row_bytes; !part.empty();) {
            const ssize_t written = ::pwrite(file_, part.data(), part.size(), static_cast<off_t>(place));
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) fail();
            place += static_cast<std::uint64_t>(written);
            part = part.subspan(static_cast<std::size_t>(written));
        }
    }
}

void PlacedFile::close()
{
    const int file = file_;
    file_ = -1;
    if (::close(file) != 0) fail();
}

void write_placed_points(const std::filesystem::path& path, const PointFileHead& head,
                         const std::function<void(const PointSink& sink)>& write)
{
    check_head(path, head);
    const auto fail_number = [&] {
        throw InputError(fmt::format("{}: a file of {} points was handed another number of them",
                                     printable(path.string()), head.points));
    };
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        create_placed_file(temporary, path, head);
        PlacedFile file(temporary, path, head);
        std::uint64_t done = 0;
        write([&](std::span<const double> coordinates) {
            const std::uint64_t points = coordinates.size() / static_cast<std::size_t>(head.dimension);
            if (points > head.points - done) fail_number();
            file.put(done, coordinates);
            done += points;
        });
        if (done != head.points) fail_number();
        file.close();
    });
}

}
