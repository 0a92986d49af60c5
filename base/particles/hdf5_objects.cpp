#include "base/particles/hdf5_objects.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace poissonlab {
namespace {

/// Takes the innermost of HDF5's errors that has words.
herr_t take_words(unsigned /*number*/, const H5E_error2_t* error, void* words)
{
    auto& text = *static_cast<std::string*>(words);
    if (text.empty() && error->desc != nullptr) text = error->desc;
    return 0;
}

std::string cause_of_failure()
{
    std::string words;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_words, &words);
    return words;
}

}

void fail_hdf5(const char* what)
{
    const int error = errno;
    throw Hdf5Failure(error == 0 ? fmt::format("cannot be written: HDF5 refuses {}", what)
                                 : fmt::format("cannot be written: {}", std::strerror(error)),
                      cause_of_failure());
}

QuietHdf5::QuietHdf5()
{
    [[maybe_unused]] static const herr_t is_told = H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Object space_of(std::uint64_t rows, std::uint64_t columns)
{
    const std::array<hsize_t, 2> size{rows, columns};
    return {H5Screate_simple(columns == 1 ? 1 : 2, size.data(), nullptr), H5Sclose, "a space"};
}

Hdf5Object group_in(hid_t file, const char* name)
{
    return {H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name};
}

void write_attribute(hid_t object, const char* name, double value)
{
    write_attribute(object, name, H5T_NATIVE_DOUBLE, std::array{value});
}

void write_attribute(hid_t object, const char* name, std::int32_t value)
{
    write_attribute(object, name, H5T_NATIVE_INT32, std::array{value});
}

void write_attribute(hid_t object, const char* name, const std::string& text)
{
    const Hdf5Object type(H5Tcopy(H5T_C_S1), H5Tclose, "a type");
    if (H5Tset_size(type, text.size() + 1) < 0 || H5Tset_cset(type, H5T_CSET_UTF8) < 0) fail_hdf5(name);
    const Hdf5Object space(H5Screate(H5S_SCALAR), H5Sclose, "a space");
    const Hdf5Object attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
    if (H5Awrite(attribute, type, text.c_str()) < 0) fail_hdf5(name);
}

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
