// Objects of HDF5 that close themselves, and their attributes. What fails throws StorageError without the file's name.
#pragma once

#include "base/errors/errors.hpp"

#include <hdf5.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

/// An HDF5 failure holds the message about a file that is written, and in `cause` HDF5's own words.
class Hdf5Failure : public StorageError
{
public:
    Hdf5Failure(const std::string& message, std::string cause) : StorageError(message), cause_(std::move(cause)) {}

    /// Empty where the library gives none.
    const std::string& cause() const { return cause_; }

private:
    std::string cause_;
};

/// Throws Hdf5Failure; the file's name is put in front later.
[[noreturn]] void fail_hdf5(const char* what);

/// HDF5 prints no errors of its own meanwhile. At the end of the program it would try again to write files that a full
/// disk did not take, and crash: it must not, and there is nothing else for it to do then.
class QuietHdf5
{
public:
    QuietHdf5();
    ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// An open object.
class Hdf5Object
{
public:
    Hdf5Object(hid_t id, herr_t (*close)(hid_t), const char* what) : id_(id), close_(close), what_(what)
    {
        if (id < 0) fail_hdf5(what);
    }
    Hdf5Object(Hdf5Object&& other) noexcept
        : id_(std::exchange(other.id_, -1)), close_(other.close_), what_(other.what_)
    {}
    Hdf5Object& operator=(Hdf5Object&&) = delete;
    ~Hdf5Object()
    {
        if (id_ >= 0) close_(id_);
    }

    operator hid_t() const { return id_; }

    /// Closes it, which may write.
    void close()
    {
        if (close_(std::exchange(id_, -1)) < 0) fail_hdf5(what_);
    }

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
    const char* what_;
};

/// A table of one column has one axis.
Hdf5Object space_of(std::uint64_t rows, std::uint64_t columns);

Hdf5Object group_in(hid_t file, const char* name);

template <class Value, std::size_t N>
void write_attribute(hid_t object, const char* name, hid_t type, const std::array<Value, N>& values)
{
    const Hdf5Object space = N == 1 ? Hdf5Object(H5Screate(H5S_SCALAR), H5Sclose, "a space") : space_of(N, 1);
    const Hdf5Object attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
    if (H5Awrite(attribute, type, values.data()) < 0) fail_hdf5(name);
}

void write_attribute(hid_t object, const char* name, double value);
void write_attribute(hid_t object, const char* name, std::int32_t value);
void write_attribute(hid_t object, const char* name, const std::string& text);

// Attributes of HDF5 as numbers, of whatever shape: one number, rows of them, or an array as its type.

bool has_link(hid_t file, const std::string& name);

/// All numbers of an attribute; nothing where the object has none of the name. `shown` is what messages call it. Throws
/// InputError without the file's name for one that does not hold numbers.
std::optional<std::vector<double>> attribute_numbers(hid_t object, const char* name, const std::string& shown);

/// Returns the numbers of the attribute `name` of a group; nothing if the group or the attribute is not there.
std::optional<std::vector<double>> group_numbers(hid_t file, const std::string& group, const char* name);

}
