// HDF5 brings some 30 libraries, for networks that it can read from, which take longer to load than all others of the
// program: it is in a module of its own.
#include "base/points/hdf5_points.hpp"

#include "base/errors/errors.hpp"
#include "base/points/hdf5_files.hpp"
#include "base/points/hdf5_reading.hpp"
#include "base/points/unit_coordinates.hpp"
#include "base/programs/loaded_module.hpp"

#include <fmt/format.h>

#include <limits>

namespace poissonlab {
namespace {

const Hdf5Files& hdf5_files()
{
    static const Hdf5Files* const loaded = reinterpret_cast<Hdf5FilesFunction>(
        function_of_module("poissonlab_particles", hdf5_files_function, "files of particles need HDF5", true))();
    return *loaded;
}

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

Hdf5Head head_of_hdf5_points(const std::filesystem::path& path, const PointReading& how)
{
    return hdf5_files().head(path, how);
}

std::vector<std::filesystem::path> parts_of_hdf5_points(const std::filesystem::path& path)
{
    return hdf5_files().parts(path);
}

namespace {

void stream_pieces(const std::filesystem::path& path, const PointReading& how, const Hdf5Head& head,
                   const PieceSink& sink)
{
    const PointFileContent file{path.string(), {}, head.domain, how.told, how.options};
    for (const std::string& sentence : head.told) file.tell(sentence);
    UnitCoordinates units(file);
    const auto axes = static_cast<std::size_t>(head.dimension);
    std::vector<double> piece;
    hdf5_files().stream(path, how, [&](std::uint64_t first, std::span<const double> stored) {
        piece.resize(stored.size());
        for (std::size_t i = 0; i < stored.size(); ++i)
            piece[i] = units(stored[i], i % axes, head.rounding, [&] {
                return CoordinatePlace{0, fmt::format("point {}: {}", first + i / axes + 1, stored[i])};
            });
        if (!units.are_refused()) sink(head.dimension, piece, nullptr);
    });
    units.finish();
}

}

void stream_hdf5_points(const std::filesystem::path& path, const PointReading& how, const PieceSink& sink)
{
    stream_pieces(path, how, head_of_hdf5_points(path, how), sink);
}

PointSet read_hdf5_points(const std::filesystem::path& path, const PointReading& how, PointDomain& domain)
{
    const Hdf5Head head = head_of_hdf5_points(path, how);
    domain = head.domain;
    PointSet set{head.dimension, {}};
    stream_pieces(path, how, head, [&](int /*dimension*/, std::span<const double> coordinates, const char* /*done*/) {
        set.coordinates.insert(set.coordinates.end(), coordinates.begin(), coordinates.end());
    });
    return set;
}

}
