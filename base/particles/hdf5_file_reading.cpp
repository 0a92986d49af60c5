#include "base/errors/errors.hpp"
#include "base/particles/hdf5_objects.hpp"
#include "base/particles/snapshot_head.hpp"
#include "base/points/hdf5_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {
namespace {

// A table of coordinates in HDF5, read in pieces.

/// An open table of points.
struct PointTable
{
    Hdf5Object file, set;
    hsize_t rows = 0;
    std::size_t columns = 0;
    double rounding = 0; ///< half the relative distance between neighbours of its numbers
};

/// Throws where the numbers are compressed in a way that this HDF5 does not have.
void check_filters(hid_t how, const std::string& table)
{
    const int filters = H5Pget_nfilters(how);
    for (int i = 0; i < filters; ++i) {
        std::array<char, 64> name{};
        unsigned flags = 0;
        std::size_t values = 0;
        const H5Z_filter_t filter = H5Pget_filter2(how, static_cast<unsigned>(i), &flags, &values, nullptr,
                                                   name.size() - 1, name.data(), nullptr);
        if (filter >= 0 && H5Zfilter_avail(filter) <= 0)
            throw InputError(fmt::format("{} is compressed by the filter {} ({}), which this HDF5 does not have: "
                                         "`h5repack -f NONE` where it is there writes it without",
                                         table, filter, printable(name.data())));
    }
}

/// Throws where the table is put together of other files (a virtual one) and one is missing: HDF5 reads zeros for it.
void check_sources(hid_t how, const std::filesystem::path& path, const std::string& table)
{
    if (H5Pget_layout(how) != H5D_VIRTUAL) return;
    std::size_t sources = 0;
    if (H5Pget_virtual_count(how, &sources) < 0) fail_hdf5(table.c_str());
    for (std::size_t i = 0; i < sources; ++i) {
        const ssize_t length = H5Pget_virtual_filename(how, i, nullptr, 0);
        if (length <= 0) continue;
        std::string name(static_cast<std::size_t>(length) + 1, '\0');
        H5Pget_virtual_filename(how, i, name.data(), name.size());
        name.resize(static_cast<std::size_t>(length));
        if (name == "." || name.find('%') != name.npos) continue;
        if (std::filesystem::exists(path.parent_path() / name) || std::filesystem::exists(name)) continue;
        throw InputError(fmt::format("{} is in other files, and {} is missing", table, printable(name)));
    }
}

std::vector<hsize_t> extent_of(hid_t space)
{
    std::array<hsize_t, H5S_MAX_RANK> extent{};
    const int axes = H5Sget_simple_extent_dims(space, extent.data(), nullptr);
    return {extent.begin(), extent.begin() + std::max(axes, 0)};
}

/// Half the distance between 1 and the next number of a type.
double rounding_of(hid_t type)
{
    std::size_t sign = 0, exponent = 0, exponent_size = 0, mantissa = 0, mantissa_size = 0;
    if (H5Tget_fields(type, &sign, &exponent, &exponent_size, &mantissa, &mantissa_size) < 0) return 0;
    return std::exp2(-1 - static_cast<double>(mantissa_size));
}

/// Opens a table of points; returns nothing where the file has no such table, or one without rows. Throws InputError
/// without the file's name for a table that holds no points, and for one that this HDF5 cannot read: by its
/// compression, or because files are missing that it is put together of.
std::optional<PointTable> open_point_table(const std::filesystem::path& path, const std::string& name)
{
    Hdf5Object file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
    const std::string group = name.substr(0, name.find('/'));
    if (!has_link(file, group) || !has_link(file, name)) return std::nullopt;
    Hdf5Object set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, name.c_str());
    const Hdf5Object space(H5Dget_space(set), H5Sclose, name.c_str());
    const Hdf5Object type(H5Dget_type(set), H5Tclose, name.c_str());
    const Hdf5Object how(H5Dget_create_plist(set), H5Pclose, name.c_str());
    const std::vector<hsize_t> extent = extent_of(space);
    if (extent.size() != 2 || (extent[1] != 2 && extent[1] != 3))
        throw InputError(fmt::format("{} is {}: points must be N x 2 or N x 3", name,
                                     extent.empty() ? "a single value" : fmt::format("{}", fmt::join(extent, " x "))));
    if (H5Tget_class(type) != H5T_FLOAT)
        throw InputError(fmt::format("{}: points must be floating-point numbers", name));
    if (extent[0] == 0) return std::nullopt;
    check_filters(how, name);
    check_sources(how, path, name);
    return PointTable{std::move(file), std::move(set), extent[0], extent[1], rounding_of(type)};
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

/// Do all points of these files have the same coordinate along an axis?
bool has_one_number(const std::vector<std::filesystem::path>& files, const std::string& name, std::size_t axis)
{
    constexpr hsize_t rows_per_piece = hsize_t{1} << 18;
    std::optional<double> first;
    std::vector<double> numbers;
    for (const auto& path : files) {
        const auto table = open_point_table(path, name);
        for (hsize_t row = 0; table && row < table->rows; row += rows_per_piece) {
            read_rows(*table, row, std::min(rows_per_piece, table->rows - row), numbers);
            for (std::size_t i = axis; i < numbers.size(); i += table->columns)
                if (numbers[i] != *(first = first.value_or(numbers[i]))) return false;
        }
    }
    return true;
}

/// Does work with HDF5 whose failures are wrong input; errors without a place are about this file.
template <class Work>
auto as_input(const std::filesystem::path& path, const Work& work)
{
    const QuietHdf5 quiet;
    errno = 0;
    try {
        return work();
    } catch (const Hdf5Failure& failure) {
        throw InputError::at({path.string()}, "cannot be read as HDF5: " + failure.cause());
    } catch (const InputError& error) {
        if (!error.place().file.empty()) throw;
        throw InputError::at({path.string()}, error.what());
    }
}

/// The tables of a set, one a file.
struct TablesOfSet
{
    std::vector<std::filesystem::path> files;
    std::string table;
    BoxSides box{};
};

bool has_particles(hid_t file)
{
    for (std::size_t type = 0; type < particle_types; ++type)
        if (has_link(file, fmt::format("PartType{}", type))) return true;
    // A part of a snapshot may have none of its particles.
    return has_link(file, "Header") && !has_link(file, "points") &&
           group_numbers(file, "Header", "NumFilesPerSnapshot").has_value();
}

/// The attribute `domain` of the table /points: two numbers.
std::optional<CoordinateRange> declared_domain(hid_t file)
{
    const Hdf5Object set(H5Dopen2(file, "points", H5P_DEFAULT), H5Dclose, "points");
    const auto domain = attribute_numbers(set, "domain", "domain");
    if (!domain) return std::nullopt;
    if (domain->size() != 2 || !((*domain)[0] < (*domain)[1]))
        throw InputError(fmt::format("the attribute domain is {}: must be two numbers, the first smaller",
                                     fmt::join(*domain, ", ")));
    return CoordinateRange{(*domain)[0], (*domain)[1]};
}

TablesOfSet tables_of_set(const std::filesystem::path& path, const PointReading& how)
{
    const Hdf5Object file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
    if (has_particles(file)) {
        const std::vector<SnapshotPart> parts = read_snapshot(path);
        TablesOfSet set{{}, coordinates_of_type(type_of_points(parts, how)), parts.front().box};
        for (const SnapshotPart& part : parts) set.files.push_back(part.path);
        return set;
    }
    if (!has_link(file, "points"))
        throw InputError("has neither the table /points nor /PartType0/Coordinates to /PartType6, points in HDF5");
    if (how.particles) throw InputError("has no types of particles, but the table /points");
    return {{path}, "points", read_box(file)};
}

/// The box, which is a cube where its sides are equal. Along an axis in which all points are the same, its side does
/// not count.
PointDomain domain_of_box(const TablesOfSet& set, const PointTable& table)
{
    if (!set.box.problem.empty()) throw InputError(set.box.problem);
    std::vector<double> sides = set.box.sides;
    if (sides.size() == 1) sides.resize(table.columns, sides.front());
    const auto shown = fmt::format("the attribute {} is {}", set.box.name, fmt::join(set.box.sides, " x "));
    if (sides.size() != 3 && sides.size() != table.columns)
        throw InputError(shown + ": must be one side, or one along each axis");
    sides.resize(table.columns);
    for (std::size_t axis = 0; axis < table.columns; ++axis) {
        std::vector<double> others = sides;
        if (table.columns == 3) others.erase(others.begin() + static_cast<std::ptrdiff_t>(axis));
        const bool are_equal = std::ranges::all_of(others, [&](double side) { return side == others[0]; });
        const bool is_cube = are_equal && sides[axis] == others[0];
        if (!is_cube && (!are_equal || table.columns == 2 || !has_one_number(set.files, set.table, axis))) continue;
        if (!(others[0] > 0) || !std::isfinite(others[0])) throw InputError(shown + ": must be above 0");
        return CoordinateRange{0, others[0]};
    }
    std::vector<CoordinateRange> ranges;
    for (const double side : sides) {
        if (!(side > 0) || !std::isfinite(side)) throw InputError(shown + ": must be above 0");
        ranges.push_back({0, side});
    }
    return PointDomain(ranges);
}

/// The domain that the file declares, or [0, 1).
PointDomain domain_of_set(const TablesOfSet& set, const PointTable& table, std::vector<std::string>& told)
{
    if (set.table == "points")
        if (const auto domain = declared_domain(table.file)) return *domain;
    if (!set.box.name.empty()) return domain_of_box(set, table);
    if (set.table != "points") told.emplace_back("the header has no BoxSize: the side of the box is taken as 1");
    return {};
}

}

Hdf5Head head_of_hdf5_file(const std::filesystem::path& path, const PointReading& how)
{
    return as_input(path, [&] {
        const TablesOfSet set = tables_of_set(path, how);
        Hdf5Head head;
        for (const auto& name : set.files) {
            const auto table = as_input(name, [&] { return open_point_table(name, set.table); });
            if (!table) continue;
            if (head.points > 0 && static_cast<int>(table->columns) != head.dimension)
                throw InputError::at({name.string()}, fmt::format("{} has {} columns, and {} in other files", set.table,
                                                                  table->columns, head.dimension));
            if (head.points == 0) {
                head.dimension = static_cast<int>(table->columns);
                head.rounding = table->rounding;
                head.domain = how.domain ? *how.domain : domain_of_set(set, *table, head.told);
            }
            head.points += table->rows;
        }
        if (head.points == 0) throw InputError("no points: must be at least 1");
        if (set.files.size() > 1)
            head.told.push_back(fmt::format("is read with all {} files of its snapshot", set.files.size()));
        return head;
    });
}

void stream_hdf5_file(const std::filesystem::path& path, const PointReading& how, const StoredPieceSink& sink)
{
    constexpr hsize_t rows_per_piece = hsize_t{1} << 18;
    as_input(path, [&] {
        const TablesOfSet set = tables_of_set(path, how);
        std::uint64_t done = 0;
        std::vector<double> numbers;
        for (const auto& name : set.files) {
            const auto table = as_input(name, [&] { return open_point_table(name, set.table); });
            for (hsize_t row = 0; table && row < table->rows; row += rows_per_piece) {
                const hsize_t rows = std::min(rows_per_piece, table->rows - row);
                as_input(name, [&] { read_rows(*table, row, rows, numbers); });
                sink(done, numbers);
                done += rows;
            }
        }
    });
}

std::vector<std::filesystem::path> parts_of_hdf5_file(const std::filesystem::path& path)
{
    return as_input(path, [&]() -> std::vector<std::filesystem::path> {
        const Hdf5Object file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
        if (!has_particles(file)) return {path};
        return names_of_parts(read_snapshot_part(path, file)).first;
    });
}

}
