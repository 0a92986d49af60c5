#include "base/particles/hdf5_attributes.hpp"

#include <fmt/format.h>

#include <array>

namespace poissonlab {
namespace {

/// The numbers in each element of an attribute: several where its type is an array. None for what is no number.
std::size_t numbers_of_element(hid_t type)
{
    if (H5Tget_class(type) == H5T_INTEGER || H5Tget_class(type) == H5T_FLOAT) return 1;
    if (H5Tget_class(type) != H5T_ARRAY) return 0;
    const Hdf5Object base(H5Tget_super(type), H5Tclose, "a type");
    const int axes = H5Tget_array_ndims(type);
    std::array<hsize_t, H5S_MAX_RANK> size{};
    if (axes < 1 || H5Tget_array_dims2(type, size.data()) < 0) return 0;
    std::size_t count = numbers_of_element(base);
    for (int i = 0; i < axes; ++i) count *= size[static_cast<std::size_t>(i)];
    return count;
}

const char* word_for(hid_t type)
{
    switch (H5Tget_class(type)) {
    case H5T_STRING:
        return "is text";
    case H5T_COMPOUND:
        return "is a record";
    case H5T_ENUM:
        return "is one of a list of words";
    default:
        return "is not a number";
    }
}

}

bool has_link(hid_t file, const std::string& name) { return H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0; }

std::optional<std::vector<double>> attribute_numbers(hid_t object, const char* name, const std::string& shown)
{
    if (H5Aexists(object, name) <= 0) return std::nullopt;
    const Hdf5Object attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose, name);
    const Hdf5Object type(H5Aget_type(attribute), H5Tclose, name);
    const Hdf5Object space(H5Aget_space(attribute), H5Sclose, name);
    const std::size_t each = numbers_of_element(type);
    if (each == 0) throw InputError(fmt::format("the attribute {} {}: must hold numbers", shown, word_for(type)));
    const hssize_t count = H5Sget_simple_extent_npoints(space);
    if (count < 1) throw InputError(fmt::format("the attribute {} is empty: must hold numbers", shown));
    std::vector<double> numbers(static_cast<std::size_t>(count) * each);
    const hsize_t size = each;
    const Hdf5Object in_memory(each == 1 ? H5Tcopy(H5T_NATIVE_DOUBLE) : H5Tarray_create2(H5T_NATIVE_DOUBLE, 1, &size),
                               H5Tclose, name);
    if (H5Aread(attribute, in_memory, numbers.data()) < 0) fail_hdf5(name);
    return numbers;
}

std::optional<std::vector<double>> group_numbers(hid_t file, const std::string& group, const char* name)
{
    if (!has_link(file, group)) return std::nullopt;
    const Hdf5Object object(H5Gopen2(file, group.c_str(), H5P_DEFAULT), H5Gclose, group.c_str());
    return attribute_numbers(object, name, group + "/" + name);
}

}
