#include "base/errors/errors.hpp"
#include "base/particles/hdf5_objects.hpp"
#include "base/points/hdf5_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

namespace poissonlab {
namespace {

constexpr std::size_t particle_types = 6; // of particles; the second is dark matter

/// Rows of a chunk of /points: 4 MiB in 2D.
constexpr std::uint64_t chunk_rows = std::uint64_t{1} << 18;

/// A table in the file, and the column and axis of points that it holds.
struct TablePlace
{
    const char* group; ///< "" for none
    const char* name;
    PlacedColumn::Content content;
    std::size_t axis;
};

std::vector<TablePlace> tables_of(const std::filesystem::path& target)
{
    using enum PlacedColumn::Content;
    if (target.extension() == ".h5") return {{"/", "points", points, 0}};
    if (target.extension() == ".h5part")
        return {{"Step#0", "x", axis, 0}, {"Step#0", "y", axis, 1}, {"Step#0", "z", axis, 2}};
    return {{"PartType1", "Coordinates", points, 0}, {"PartType1", "ParticleIDs", number, 0}};
}

/// Makes a table whose room is there from the begin, and whose numbers HDF5 never writes; no time is stored.
Hdf5Object create_table(hid_t group, const TablePlace& table, const PointFileHead& head, bool in_chunks)
{
    const std::uint64_t columns =
        table.content == PlacedColumn::Content::points ? static_cast<std::uint64_t>(head.dimension) : 1;
    const hid_t type = table.content == PlacedColumn::Content::number ? H5T_NATIVE_UINT64 : H5T_NATIVE_DOUBLE;
    const Hdf5Object space = space_of(head.points, columns);
    const Hdf5Object how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, table.name);
    const std::array<hsize_t, 2> chunk{std::min<std::uint64_t>(head.points, chunk_rows), columns};
    if (H5Pset_obj_track_times(how, false) < 0 || (in_chunks && H5Pset_chunk(how, 2, chunk.data()) < 0) ||
        H5Pset_alloc_time(how, H5D_ALLOC_TIME_EARLY) < 0 || H5Pset_fill_time(how, H5D_FILL_TIME_NEVER) < 0)
        fail_hdf5(table.name);
    return {H5Dcreate2(group, table.name, type, space, H5P_DEFAULT, how, H5P_DEFAULT), H5Dclose, table.name};
}

void write_gadget_header(hid_t file, const PointFileHead& head)
{
    const Hdf5Object header = group_in(file, "Header");
    std::array<std::uint32_t, particle_types> count{}, none{};
    std::array<double, particle_types> mass{};
    count[1] = static_cast<std::uint32_t>(head.points);
    mass[1] = head.side * head.side * head.side / static_cast<double>(head.points);
    write_attribute(header, "NumPart_ThisFile", H5T_NATIVE_UINT32, count);
    write_attribute(header, "NumPart_Total", H5T_NATIVE_UINT32, count);
    write_attribute(header, "NumPart_Total_HighWord", H5T_NATIVE_UINT32, none);
    write_attribute(header, "MassTable", H5T_NATIVE_DOUBLE, mass);
    write_attribute(header, "BoxSize", head.side);
    for (const char* name : {"Time", "Redshift", "Omega0", "OmegaLambda"}) write_attribute(header, name, 0.0);
    write_attribute(header, "HubbleParam", 1.0);
    write_attribute(header, "NumFilesPerSnapshot", std::int32_t{1});
    for (const char* name : {"Flag_Sfr", "Flag_Cooling", "Flag_StellarAge", "Flag_Metals", "Flag_Feedback"})
        write_attribute(header, name, std::int32_t{0});
    write_attribute(header, "Flag_DoublePrecision", std::int32_t{1});
    write_attribute(header, "Units", "lengths in " + head.unit + "; all mass is BoxSize^3");
}

/// The comment in one line.
std::string one_line(std::string text)
{
    std::ranges::replace(text, '\n', ' ');
    return text;
}

void create_points_table(hid_t file, const std::filesystem::path& target, const PointFileHead& head)
{
    const Hdf5Object points = create_table(file, tables_of(target).front(), head, head.points > 0);
    if (head.side > 0) write_attribute(points, "domain", H5T_NATIVE_DOUBLE, std::array{0.0, head.side});
    write_attribute(points, "unit", head.unit);
    write_attribute(points, "comment", one_line(head.comment));
}

void create_particles(hid_t file, const std::filesystem::path& target, const PointFileHead& head)
{
    const auto tables = tables_of(target);
    const Hdf5Object group = group_in(file, tables[0].group);
    const bool is_snapshot = target.extension() == ".hdf5";
    for (const TablePlace& table : tables) {
        const Hdf5Object set = create_table(group, table, head, false);
        if (is_snapshot && table.content == PlacedColumn::Content::points)
            write_attribute(set, "Units", head.unit + ", BoxSize of them along each axis");
    }
    if (is_snapshot) write_gadget_header(file, head);
    write_attribute(file, "Comment", one_line(head.comment) + (is_snapshot ? "" : "; divided by the side of the box"));
}

/// Says the file's name before what went wrong.
template <class Work>
auto naming(const std::filesystem::path& target, const Work& work)
{
    const QuietHdf5 quiet;
    errno = 0;
    try {
        return work();
    } catch (const StorageError& error) {
        throw StorageError(fmt::format("{}: {}", printable(target.string()), error.what()));
    }
}

PlacedColumn column_of(hid_t file, const TablePlace& table, const PointFileHead& head)
{
    const std::string name = std::string(table.group) + "/" + table.name;
    const Hdf5Object set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, table.name);
    PlacedColumn column{.content = table.content, .axis = table.axis, .rows_per_chunk = head.points, .chunks = {}};
    if (table.content != PlacedColumn::Content::points || std::string_view(table.name) != "points") {
        column.chunks.push_back(H5Dget_offset(set));
    } else {
        column.rows_per_chunk = std::min(head.points, chunk_rows);
        for (std::uint64_t row = 0; row < head.points; row += chunk_rows) {
            const std::array<hsize_t, 2> begin{row, 0};
            haddr_t place = HADDR_UNDEF;
            hsize_t bytes = 0;
            unsigned filters = 0;
            if (H5Dget_chunk_info_by_coord(set, begin.data(), &filters, &place, &bytes) < 0) fail_hdf5(table.name);
            column.chunks.push_back(place);
        }
    }
    if (std::ranges::find(column.chunks, HADDR_UNDEF) != column.chunks.end()) fail_hdf5(table.name);
    return column;
}

}

void write_hdf5_file(const std::filesystem::path& file, const std::filesystem::path& target, const PointFileHead& head)
{
    naming(target, [&] {
        Hdf5Object made(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "the file");
        if (target.extension() == ".h5")
            create_points_table(made, target, head);
        else
            create_particles(made, target, head);
        if (H5Fflush(made, H5F_SCOPE_GLOBAL) < 0) fail_hdf5("the file");
        made.close();
    });
}

std::vector<PlacedColumn> columns_of_hdf5_file(const std::filesystem::path& file, const std::filesystem::path& target,
                                               const PointFileHead& head)
{
    std::vector<PlacedColumn> columns;
    if (head.points == 0) return columns;
    naming(target, [&] {
        const Hdf5Object made(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "the file");
        for (const TablePlace& table : tables_of(target)) columns.push_back(column_of(made, table, head));
    });
    return columns;
}

}
