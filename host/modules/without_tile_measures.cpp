// These functions stand in for measures of tiled sets where a program lacks them: a run of such sets asks for the
// module.
#include "analysis/measures/lattice_peaks.hpp"
#include "analysis/measures/off_lattice_anisotropy.hpp"
#include "analysis/measures/seam_density.hpp"
#include "analysis/tilings/tiled_sets.hpp"
#include "base/errors/missing_module.hpp"

namespace poissonlab {
namespace {

[[noreturn]] void need_module() { throw MissingModule("tile_measures"); }

}

void need_tile_measures() { need_module(); }

SeamDensity::SeamDensity(int dimension, int tiles, std::size_t /*points*/)
    : dimension_(dimension), tiles_(tiles), width_(0)
{
    need_module();
}

void SeamDensity::add(const PointSet& /*points*/) { need_module(); }

void SeamDensity::append(const SeamDensity& /*other*/) { need_module(); }

std::optional<double> SeamDensity::largest_deviation() const { need_module(); }

std::optional<double> SeamDensity::border_density() const { need_module(); }

FoldedDensity::FoldedDensity(int tiles, std::size_t /*points*/) : tiles_(tiles), size_(0) { need_module(); }

void FoldedDensity::add(const PointSet& /*points*/) { need_module(); }

void FoldedDensity::append(const FoldedDensity& /*other*/) { need_module(); }

SquareImage FoldedDensity::densities() const { need_module(); }

LatticePeaks lattice_peaks(const Spectrum& /*spectrum*/, int /*tiles*/) { need_module(); }

std::optional<NearLatticePeaks> near_lattice_peaks(const Spectrum& /*spectrum*/, int /*tiles*/) { need_module(); }

std::optional<NearLatticePeaks> near_lattice_peaks(const std::vector<double>& /*powers*/, std::size_t /*points*/)
{
    need_module();
}

std::vector<double> lattice_shell_powers(const HalfSpectrum& /*periodogram*/, std::size_t /*points*/, int /*tiles*/)
{
    need_module();
}

double mean_ratio_of_shells(const std::vector<double>& /*shells*/, std::size_t /*points*/) { need_module(); }

std::vector<double> near_lattice_powers(const HalfSpectrum& /*periodogram*/, std::size_t /*points*/, int /*tiles*/)
{
    need_module();
}

double lattice_share(const HalfSpectrum& /*periodogram*/, int /*tiles*/) { need_module(); }

std::optional<double> off_lattice_anisotropy_db(const Spectrum& /*spectrum*/, int /*tiles*/) { need_module(); }

double min_distance_within_tiles(const PointSet& /*points*/, int /*tiles*/) { need_module(); }

double min_distance_within_tiles(const PointStrips& /*points*/, int /*tiles*/) { need_module(); }

}
