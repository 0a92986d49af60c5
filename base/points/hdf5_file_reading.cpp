#include "base/errors/errors.hpp"
#include "base/points/hdf5_files.hpp"
#include "base/points/hdf5_objects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace poissonlab {
namespace {

constexpr hsize_t rows_per_piece = hsize_t{1} << 18;

/// An open table of points.
struct PointTable
{
    Hdf5Object file, set;
    hsize_t rows = 0, columns = 0;
    CoordinateRange range{};
};

bool has_link(hid_t file, const char* name) { return H5Lexists(file, name, H5P_DEFAULT) > 0; }

/// One or two numbers of an attribute; none where it is not there.
std::vector<double> attribute_of(hid_t object, const char* name)
{
    if (H5Aexists(object, name) <= 0) return {};
    const Hdf5Object attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, name);
    const Hdf5Object space(H5Aget_space(attribute), H5Sclose, name);
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count < 1 || count > 2) return {};
    std::vector<double> numbers(static_cast<std::size_t>(count));
    if (H5Aread(attribute, H5T_NATIVE_DOUBLE, numbers.data()) < 0) fail_hdf5(name);
    return numbers;
}

/// The range that the file declares.
CoordinateRange range_of(hid_t file, hid_t set)
{
    if (const auto domain = attribute_of(set, "domain"); domain.size() == 2) return {domain[0], domain[1]};
    if (has_link(file, "Header")) {
        const Hdf5Object header(H5Gopen2(file, "Header", H5P_DEFAULT), H5Gclose, "Header");
        if (const auto side = attribute_of(header, "BoxSize"); side.size() == 1) return {0, side[0]};
    }
    return {};
}

[[noreturn]] void fail_table(const std::filesystem::path& path, const std::string& problem)
{
    throw InputError::at({path.string()}, problem);
}

PointTable open_table(const std::filesystem::path& path, std::optional<CoordinateRange> range)
{
    Hdf5Object file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
    const bool is_snapshot = has_link(file, "PartType1") && has_link(file, "PartType1/Coordinates");
    if (!is_snapshot && !has_link(file, "points"))
        fail_table(path, "has neither the table /points nor /PartType1/Coordinates, points in HDF5");
    Hdf5Object set(H5Dopen2(file, is_snapshot ? "PartType1/Coordinates" : "points", H5P_DEFAULT), H5Dclose, "points");
    const Hdf5Object space(H5Dget_space(set), H5Sclose, "points");
    const Hdf5Object type(H5Dget_type(set), H5Tclose, "points");
    std::array<hsize_t, 2> extent{};
    if (H5Sget_simple_extent_ndims(space) != 2 || H5Sget_simple_extent_dims(space, extent.data(), nullptr) < 0 ||
        (extent[1] != 2 && extent[1] != 3) || H5Tget_class(type) != H5T_FLOAT)
        fail_table(path, "points must be floating-point numbers, N x 2 or N x 3");
    if (extent[0] == 0) fail_table(path, "no points: must be at least 1");
    const CoordinateRange declared = range ? *range : range_of(file, set);
    if (!(declared.low < declared.high)) fail_table(path, "domain: must be two numbers, the first smaller");
    return {std::move(file), std::move(set), extent[0], extent[1], declared};
}

void read_rows(const PointTable& table, hsize_t first, hsize_t rows, std::vector<double>& numbers)
{
    const std::array<hsize_t, 2> begin{first, 0}, count{rows, table.columns};
    const Hdf5Object in_file(H5Dget_space(table.set), H5Sclose, "points");
    const Hdf5Object in_memory(H5Screate_simple(2, count.data(), nullptr), H5Sclose, "points");
    numbers.resize(rows * table.columns);
    if (H5Sselect_hyperslab(in_file, H5S_SELECT_SET, begin.data(), nullptr, count.data(), nullptr) < 0 ||
        H5Dread(table.set, H5T_NATIVE_DOUBLE, in_memory, in_file, H5P_DEFAULT, numbers.data()) < 0)
        fail_hdf5("points");
}

/// Does work with HDF5 whose failures are wrong input.
template <class Work>
auto as_input(const std::filesystem::path& path, const Work& work)
{
    const QuietHdf5 quiet;
    errno = 0;
    try {
        return work();
    } catch (const StorageError&) {
        throw InputError::at({path.string()}, "cannot be read as HDF5: it is damaged, or ends too early");
    }
}

}

std::pair<std::uint64_t, int> size_of_hdf5_file(const std::filesystem::path& path)
{
    return as_input(path, [&] {
        const PointTable table = open_table(path, CoordinateRange{});
        return std::pair<std::uint64_t, int>(table.rows, static_cast<int>(table.columns));
    });
}

void stream_hdf5_file(const std::filesystem::path& path, std::optional<CoordinateRange> range, const PieceSink& sink)
{
    as_input(path, [&] {
        const PointTable table = open_table(path, range);
        std::vector<double> numbers;
        for (hsize_t row = 0; row < table.rows; row += rows_per_piece) {
            read_rows(table, row, std::min(rows_per_piece, table.rows - row), numbers);
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                if (!is_coordinate(numbers[i], table.range))
                    fail_table(path,
                               fmt::format("point {}: {}: must be a number in [{}, {})", row + i / table.columns + 1,
                                           numbers[i], table.range.low, table.range.high));
                numbers[i] = to_unit(numbers[i], table.range);
            }
            sink(static_cast<int>(table.columns), numbers, nullptr);
        }
    });
}

}
