// HDF5 brings some 30 libraries, for networks that it can read from, which take longer to load than all others of the
// program: it is in a module of its own.
#include "base/points/hdf5_points.hpp"

#include "base/errors/errors.hpp"
#include "base/points/hdf5_files.hpp"
#include "base/points/hdf5_reading.hpp"
#include "base/programs/loaded_module.hpp"

#include <fmt/format.h>

#include <limits>

namespace poissonlab {
namespace {

const Hdf5Files& hdf5_files()
{
    static const Hdf5Files* const loaded = reinterpret_cast<Hdf5FilesFunction>(
        function_of_module("poissonlab_particles", hdf5_files_function, "files of particles need HDF5"))();
    return *loaded;
}

}

bool is_hdf5_name(const std::filesystem::path& path) { return path.extension() == ".h5" || is_particle_file(path); }

bool is_particle_file(const std::filesystem::path& path)
{
    return path.extension() == ".hdf5" || path.extension() == ".h5part";
}

void check_hdf5_head(const std::filesystem::path& path, const PointFileHead& head)
{
    constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
    if (!is_particle_file(path)) return;
    if (head.dimension != 3)
        throw InputError(fmt::format("{}: particles of simulations are in 3D; these points are in 2D, which .h5, .npy, "
                                     ".csv, .ply and text take",
                                     printable(path.string())));
    if (head.points > most)
        throw InputError(fmt::format("{}: {} particles: a file of particles has at most {}; .h5 and .npy take more",
                                     printable(path.string()), head.points, most));
}

void create_hdf5_points(const std::filesystem::path& file, const std::filesystem::path& target,
                        const PointFileHead& head)
{
    hdf5_files().create(file, target, head);
}

std::vector<PlacedColumn> hdf5_columns(const std::filesystem::path& file, const std::filesystem::path& target,
                                       const PointFileHead& head)
{
    return hdf5_files().columns(file, target, head);
}

std::pair<std::uint64_t, int> size_of_hdf5_points(const std::filesystem::path& path) { return hdf5_files().size(path); }

void stream_hdf5_points(const std::filesystem::path& path, std::optional<CoordinateRange> range, const PieceSink& sink)
{
    hdf5_files().stream(path, range, sink);
}

PointSet read_hdf5_points(const std::filesystem::path& path, std::optional<CoordinateRange> range)
{
    PointSet set{2, {}};
    stream_hdf5_points(path, range, [&](int dimension, std::span<const double> coordinates, const char* /*done*/) {
        set.dimension = dimension;
        set.coordinates.insert(set.coordinates.end(), coordinates.begin(), coordinates.end());
    });
    return set;
}

}
