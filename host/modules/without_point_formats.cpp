// These functions stand in for formats of points where a program lacks them: it has text and tables, and other files
// ask for the module.
#include "base/errors/errors.hpp"
#include "base/errors/missing_module.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/hdf5_points.hpp"
#include "base/points/hdf5_reading.hpp"
#include "base/points/point_file_formats.hpp"

namespace poissonlab {
namespace {

constexpr auto module_of_formats = "point_formats";

/// The program starts again once it has the module, and the content of a pipe is gone by then.
[[noreturn]] void need_point_formats(const PointFileContent& file)
{
    if (is_no_lasting_file(file.name))
        throw InputError::at({file.name}, "holds points in a format whose module is not built yet: give the points as "
                                          "a file once, and the module is built");
    throw MissingModule(module_of_formats);
}

[[noreturn]] void need_particles() { throw MissingModule("particles"); }

}

void stream_npy_points(const PointFileContent& file, const PieceSink& /*sink*/) { need_point_formats(file); }

NpyShape shape_of_npy_sets(const PointFileContent& file) { need_point_formats(file); }

std::vector<PointSet> read_npy_points(const PointFileContent& file) { need_point_formats(file); }

std::vector<PointSet> read_ply_points(const PointFileContent& file) { need_point_formats(file); }

std::vector<PointSet> read_geojson_points(const PointFileContent& file) { need_point_formats(file); }

std::vector<PointSet> read_utk_points(const PointFileContent& file) { need_point_formats(file); }

void write_usd_points(const std::filesystem::path& /*path*/, int /*dimension*/, std::size_t /*points*/,
                      const std::string& /*comment*/, const std::function<void(const PointSink& sink)>& /*write*/)
{
    throw MissingModule(module_of_formats);
}

void write_geojson_points(const std::filesystem::path& /*path*/, int /*dimension*/, const std::string& /*crs*/,
                          const std::string& /*comment*/, const std::function<void(const PointSink& sink)>& /*write*/,
                          const std::vector<std::string>& /*features*/)
{
    throw MissingModule(module_of_formats);
}

void write_dxf_points(const std::filesystem::path& /*path*/, int /*dimension*/, const std::string& /*comment*/,
                      const std::function<void(const PointSink& sink)>& /*write*/)
{
    throw MissingModule(module_of_formats);
}

void check_hdf5_head(const std::filesystem::path& /*path*/, const PointFileHead& /*head*/) { need_particles(); }

void create_hdf5_points(const std::filesystem::path& /*file*/, const std::filesystem::path& /*target*/,
                        const PointFileHead& /*head*/)
{
    need_particles();
}

std::vector<PlacedColumn> hdf5_columns(const std::filesystem::path& /*file*/, const std::filesystem::path& /*target*/,
                                       const PointFileHead& /*head*/)
{
    need_particles();
}

Hdf5Head head_of_hdf5_points(const std::filesystem::path& /*path*/, const PointReading& /*how*/) { need_particles(); }

void stream_hdf5_points(const std::filesystem::path& /*path*/, const PointReading& /*how*/, const PieceSink& /*sink*/)
{
    need_particles();
}

PointSet read_hdf5_points(const std::filesystem::path& /*path*/, const PointReading& /*how*/, PointDomain& /*domain*/)
{
    need_particles();
}

std::vector<std::filesystem::path> parts_of_hdf5_points(const std::filesystem::path& /*path*/) { need_particles(); }

}
