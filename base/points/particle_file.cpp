#include "base/points/particle_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace poissonlab {
namespace {

constexpr std::size_t types = 6; // of particles; the second is dark matter

/// HDF5 says what went wrong by errno alone, if that; the file's name is put in front later.
[[noreturn]] void fail_hdf5(const char* what)
{
    const int error = errno;
    throw StorageError(error == 0 ? fmt::format("cannot be written: HDF5 refuses {}", what)
                                  : fmt::format("cannot be written: {}", std::strerror(error)));
}

/// HDF5 prints no errors of its own meanwhile. At the end of the program it would try again to write files that a full
/// disk did not take, and crash: it must not, and there is nothing else for it to do then.
class QuietHdf5
{
public:
    QuietHdf5()
    {
        [[maybe_unused]] static const herr_t is_told = H5dont_atexit();
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

/// An open object of HDF5.
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

Hdf5Object space_of(std::size_t rows, std::size_t columns)
{
    const std::array<hsize_t, 2> size{rows, columns};
    return {H5Screate_simple(columns == 1 ? 1 : 2, size.data(), nullptr), H5Sclose, "a space"};
}

Hdf5Object group_in(hid_t file, const char* name)
{
    return {H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose, name};
}

template <class Value, std::size_t N>
void write_attribute(hid_t object, const char* name, hid_t type, const std::array<Value, N>& values)
{
    const Hdf5Object space = N == 1 ? Hdf5Object(H5Screate(H5S_SCALAR), H5Sclose, "a space") : space_of(N, 1);
    const Hdf5Object attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
    if (H5Awrite(attribute, type, values.data()) < 0) fail_hdf5(name);
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

/// A table of numbers that is written in rows, one after another.
class Hdf5Rows
{
public:
    /// The room is there from the begin, so that descriptions of it are not written last; no time is stored.
    Hdf5Rows(hid_t group, const char* name, hid_t type, std::size_t rows, std::size_t columns)
        : type_(type), columns_(columns), name_(name), set_(create(group, name, type, rows, columns))
    {}

    void append(const void* values, std::size_t rows)
    {
        if (rows == 0) return;
        const Hdf5Object all(H5Dget_space(set_), H5Sclose, name_), part = space_of(rows, columns_);
        const std::array<hsize_t, 2> begin{done_, 0}, size{rows, columns_};
        errno = 0;
        if (H5Sselect_hyperslab(all, H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr) < 0 ||
            H5Dwrite(set_, type_, part, all, H5P_DEFAULT, values) < 0)
            fail_hdf5(name_);
        done_ += rows;
    }

    hid_t id() const { return set_; }
    void close() { set_.close(); }

private:
    static Hdf5Object create(hid_t group, const char* name, hid_t type, std::size_t rows, std::size_t columns)
    {
        const Hdf5Object space = space_of(rows, columns), how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, name);
        if (H5Pset_obj_track_times(how, false) < 0 || H5Pset_alloc_time(how, H5D_ALLOC_TIME_EARLY) < 0 ||
            H5Pset_fill_time(how, H5D_FILL_TIME_NEVER) < 0)
            fail_hdf5(name);
        return {H5Dcreate2(group, name, type, space, H5P_DEFAULT, how, H5P_DEFAULT), H5Dclose, name};
    }

    hid_t type_;
    std::size_t columns_, done_ = 0;
    const char* name_;
    Hdf5Object set_;
};

/// A file of particles: what it says of all, then their numbers in pieces.
class ParticleFile
{
public:
    ParticleFile(const std::filesystem::path& path, std::size_t points) : points_(points), file_(create(path)) {}
    virtual ~ParticleFile() = default;
    ParticleFile(const ParticleFile&) = delete;
    ParticleFile& operator=(const ParticleFile&) = delete;

    void append(std::span<const double> coordinates)
    {
        const std::size_t rows = coordinates.size() / 3;
        if (rows > points_ - done_) fail_number();
        append_rows(coordinates, rows);
        done_ += rows;
    }

    /// Says whether all is there and written.
    void finish()
    {
        if (done_ != points_) fail_number();
        close_rows();
        errno = 0;
        if (H5Fflush(file_, H5F_SCOPE_GLOBAL) < 0) fail_hdf5("the file");
        file_.close();
    }

protected:
    virtual void append_rows(std::span<const double> coordinates, std::size_t rows) = 0;
    virtual void close_rows() = 0;
    hid_t file() const { return file_; }
    std::size_t done() const { return done_; }

private:
    static Hdf5Object create(const std::filesystem::path& path)
    {
        errno = 0;
        return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose, "the file"};
    }

    [[noreturn]] void fail_number() const
    {
        throw InputError(fmt::format("a file of {} particles was handed another number of them", points_));
    }

    std::size_t points_, done_ = 0;
    Hdf5Object file_;
};

/// A snapshot of one file with particles of type 1, at rest: it has no velocities.
class GadgetSnapshot : public ParticleFile
{
public:
    GadgetSnapshot(const std::filesystem::path& path, std::size_t points, double side, const std::string& unit,
                   const std::string& comment)
        : ParticleFile(path, points), group_(group_in(file(), "PartType1")),
          coordinates_(group_, "Coordinates", H5T_NATIVE_DOUBLE, points, 3),
          ids_(group_, "ParticleIDs", H5T_NATIVE_UINT64, points, 1)
    {
        write_header(points, side, unit);
        write_attribute(coordinates_.id(), "Units", unit + ", BoxSize of them along each axis");
        write_attribute(file(), "Comment", comment);
    }

private:
    void write_header(std::size_t points, double side, const std::string& unit)
    {
        const Hdf5Object header = group_in(file(), "Header");
        std::array<std::uint32_t, types> count{}, none{};
        std::array<double, types> mass{};
        count[1] = static_cast<std::uint32_t>(points);
        mass[1] = side * side * side / static_cast<double>(points);
        write_attribute(header, "NumPart_ThisFile", H5T_NATIVE_UINT32, count);
        write_attribute(header, "NumPart_Total", H5T_NATIVE_UINT32, count);
        write_attribute(header, "NumPart_Total_HighWord", H5T_NATIVE_UINT32, none);
        write_attribute(header, "MassTable", H5T_NATIVE_DOUBLE, mass);
        write_attribute(header, "BoxSize", side);
        for (const char* name : {"Time", "Redshift", "Omega0", "OmegaLambda"}) write_attribute(header, name, 0.0);
        write_attribute(header, "HubbleParam", 1.0);
        write_attribute(header, "NumFilesPerSnapshot", std::int32_t{1});
        for (const char* name : {"Flag_Sfr", "Flag_Cooling", "Flag_StellarAge", "Flag_Metals", "Flag_Feedback"})
            write_attribute(header, name, std::int32_t{0});
        write_attribute(header, "Flag_DoublePrecision", std::int32_t{1});
        write_attribute(header, "Units", "lengths in " + unit + "; all mass is BoxSize^3");
    }

    void append_rows(std::span<const double> coordinates, std::size_t rows) override
    {
        coordinates_.append(coordinates.data(), rows);
        numbers_.resize(rows);
        for (std::size_t i = 0; i < rows; ++i) numbers_[i] = done() + i + 1;
        ids_.append(numbers_.data(), rows);
    }

    void close_rows() override
    {
        coordinates_.close();
        ids_.close();
        group_.close();
    }

    Hdf5Object group_;
    Hdf5Rows coordinates_, ids_;
    std::vector<std::uint64_t> numbers_;
};

/// One step of H5Part, coordinates in the unit cube.
class H5PartStep : public ParticleFile
{
public:
    H5PartStep(const std::filesystem::path& path, std::size_t points, double side, const std::string& comment)
        : ParticleFile(path, points), side_(side),
          group_(group_in(file(), "Step#0")), axes_{Hdf5Rows(group_, "x", H5T_NATIVE_DOUBLE, points, 1),
                                                    Hdf5Rows(group_, "y", H5T_NATIVE_DOUBLE, points, 1),
                                                    Hdf5Rows(group_, "z", H5T_NATIVE_DOUBLE, points, 1)}
    {
        write_attribute(file(), "Comment", comment + "; divided by the side of the box");
    }

private:
    void append_rows(std::span<const double> coordinates, std::size_t rows) override
    {
        along_.resize(rows);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (std::size_t i = 0; i < rows; ++i) along_[i] = coordinates[3 * i + axis] / side_;
            axes_[axis].append(along_.data(), rows);
        }
    }

    void close_rows() override
    {
        for (Hdf5Rows& axis : axes_) axis.close();
        group_.close();
    }

    double side_;
    Hdf5Object group_;
    std::array<Hdf5Rows, 3> axes_;
    std::vector<double> along_;
};

/// The comment in one line.
std::string one_line(std::string text)
{
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

}

bool is_particle_file(const std::filesystem::path& path)
{
    return path.extension() == ".hdf5" || path.extension() == ".h5part";
}

void write_particles_in_pieces(const std::filesystem::path& path, std::size_t points, double side,
                               const std::string& unit, const std::string& comment,
                               const std::function<void(const PointSink& sink)>& write)
{
    if (points > std::numeric_limits<std::uint32_t>::max())
        throw InputError(fmt::format("{}: {} particles: a snapshot in one file has at most {}",
                                     printable(path.string()), points, std::numeric_limits<std::uint32_t>::max()));
    write_whole_file(path, [&](const std::filesystem::path& temporary) {
        const QuietHdf5 quiet;
        try {
            const auto fill = [&](ParticleFile& file) {
                write([&](std::span<const double> coordinates) { file.append(coordinates); });
                file.finish();
            };
            if (path.extension() == ".h5part") {
                H5PartStep file(temporary, points, side, one_line(comment));
                fill(file);
            } else {
                GadgetSnapshot file(temporary, points, side, unit, one_line(comment));
                fill(file);
            }
        } catch (const StorageError& error) {
            throw StorageError(fmt::format("{}: {}", printable(path.string()), error.what()));
        }
    });
}

}
