#include "base/errors/errors.hpp"
#include "base/particles/hdf5_attributes.hpp"
#include "base/particles/hdf5_objects.hpp"
#include "base/particles/point_table.hpp"
#include "base/particles/snapshot_head.hpp"
#include "base/points/hdf5_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

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
