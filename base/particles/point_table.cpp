#include "base/particles/point_table.hpp"

#include "base/errors/errors.hpp"
#include "base/particles/hdf5_attributes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace poissonlab {
namespace {

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

}

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

}
