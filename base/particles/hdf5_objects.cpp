#include "base/particles/hdf5_objects.hpp"

#include "base/errors/errors.hpp"

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

}
