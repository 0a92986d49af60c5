// Points of several classes, each and all together even: what settings ask for, and what is measured.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010. See host/sampling/classes/class_darts.hpp.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/distribution/classes/class_features.hpp"
#include "host/distribution/classes/class_means.hpp"
#include "host/distribution/regions/region_darts.hpp"
#include "host/kinds/distribution_place.hpp"
#include "host/sampling/classes/class_darts.hpp"
#include "results/pictures/distribution_result.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace poissonlab {

// The least distance of points of one set from those of another, on the unit torus.

/// Returns a distance in unit lengths; infinity if a set is empty. Coordinates lie in [0, 1); where they are multiples
/// of 2^-32, squares are exact, and one rounding follows. Time is O(N log N) for well-spread points.
double least_distance_between(const PointSet& a, const PointSet& b);

// The settings of [[distribution]] kind = "classes".

/// kind = "classes". Lists have a value for each class.
struct ClassSettings
{
    DartSettings place;              ///< the region, how it is read, and obstacles in it; no region: the unit torus
    std::vector<std::size_t> points; ///< empty: to saturation, or those of features
    FeatureNumbers features{};       ///< of points in the region's features; empty: those of `points`
    std::vector<std::string> densities{};      ///< that classes follow in a region: pictures or formulas; empty: none
    std::vector<std::string> densities_from{}; ///< of pictures: one for all, or of each class; empty: light
    std::vector<double> distances;    ///< of points of the same class, in sides of the torus or units of the region;
                                      ///< empty: of `matrix`, or those of relative_radius
    std::vector<double> matrix;       ///< of all pairs, row after row; empty: Wei's
    std::vector<double> per_length{}; ///< on lines: points of each class on a unit of length, of which `points` follow
    double relative_radius = 0.62;    ///< of each class, where there are no distances
    double factor = 1; ///< all distances are multiplied by it where a class with points to come is full; 1: an error
    int dimension = 2;
    std::uint32_t colors = 0; ///< of corner tiles that are built, whose points and distances these are; 0: none
    std::uint32_t joint_iterations = 0; ///< how often tiles that are built are relaxed together
    std::uint32_t equal_moments = 0;    ///< order up to which the points of each class have the same moments in them
    std::filesystem::path tiles;        ///< a tile set whose points have classes, instead of all of these; empty: darts
    std::uint32_t torus = 12;           ///< tiles along each axis
    std::uint32_t sets = 1;             ///< that spectra are means over; files have the first

    std::size_t classes() const;
    bool has_tiles() const { return colors > 0 || !tiles.empty(); }
    bool has_region() const { return !place.region.empty(); }
    bool is_along() const { return place.reading.is_along; }
    bool has_numbers() const { return !points.empty() || !features.is_empty(); }
};

struct PoissonTileSet;

/// The distances, the region and the request that darts are thrown for.
struct ClassWork
{
    ClassDartRequest request;
    ClassDistances asked;                     ///< in sides of the torus or units of the region
    double side = 1;                          ///< of the torus, in these units
    double length = 0;                        ///< of the lines that points lie on; 0: they lie in an area
    std::shared_ptr<const RegionLand> land{}; ///< of a region
    /// Features whose points the parts of the request are; empty: the whole region.
    std::shared_ptr<const std::vector<FeaturePart>> features = std::make_shared<const std::vector<FeaturePart>>();
};

/// Returns the matrix of the settings, or the one that follows from them and from the distances that classes have at a
/// relative radius of 1, on lines, in the plane or in space.
ClassDistances asked_distances(const ClassSettings& settings, const std::vector<double>& largest, int dimension);

/// Throws InputError, a line that begins with `where`, where full classes have fewer points than were asked for. It
/// says by how much smaller distances would have to be, on lines, in the plane or in space.
void check_counts(const ClassSettings& settings, const std::vector<std::size_t>& asked,
                  const std::vector<std::size_t>& counts, const std::string& where, int dimension);

/// Does so for a set, or for each of its features.
void check_numbers(const ClassSettings& settings, const struct ClassSet& set);

/// Prepares a set. Each `number` has random numbers of its own. Throws InputError if the torus, the region or the
/// memory has no room for the set.
ClassWork class_work(const ClassSettings& settings, std::uint64_t seed, std::uint32_t number = 0);

struct ClassSet
{
    ClassWork work;
    ClassedPoints points; ///< in coordinates of the torus, in a corner of which a region lies; on lines in their units
    std::shared_ptr<const PoissonTileSet> tiles{};     ///< of a tiling
    std::vector<std::vector<double>> density_errors{}; ///< of parts with densities: of each class, see density_errors()
    std::vector<std::string> features_on_lines{};      ///< the id of each point's feature, as JSON, if there are any

    /// The distances that classes keep, in sides of the torus or units of the region.
    ClassDistances kept() const { return work.asked.scaled(points.scale); }

    /// Return the set in these units, and in the coordinates of files, which are longitude and latitude if the region's
    /// are.
    ClassedPoints in_units() const;
    ClassedPoints as_in_files() const;
    /// Returns for each point the members of its feature of the region's file, see write_class_file().
    std::vector<std::string> features() const;

    const PlaneRegion* region() const { return work.land ? &work.land->whole : nullptr; }

    /// The length, area or volume that the points lie in, in powers of these units.
    double size() const { return is_on_lines() ? work.length : work.request.region ? work.request.region->area() : 1; }
    int dimension() const { return is_on_lines() ? 1 : work.request.dimension; }
    bool is_on_lines() const { return work.length > 0; }
};

/// Throws the darts, or takes the points of a tiling. Throws InputError where a class is full before it has the points
/// that are asked for, and what tiled_classes() throws.
ClassSet throw_classes(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                       std::uint32_t number = 0);

/// The least distance that was found for each pair of classes, in units of the set; infinite where there is none.
ClassDistances least_distances(const ClassSet& set);

/// Throws DensityError, see class_density.hpp, if a class has no density in a part of the region.
void check_densities(const ClassWork& work);

/// Returns how far the points of each class are from its density in a part, see class_density.hpp.
std::vector<double> density_errors(const ClassPart& part, const ClassedPoints& points);

/// Returns how far the points of a class are from its density, see class_density.hpp; -1: it has none, or features
/// have.
double density_error(const ClassSet& set, std::size_t of);

/// Sentences on classes whose distances keep their points from following their densities.
std::vector<std::string> density_notes(const ClassSet& set);

/// Numbers of all classes, of each, and of each pair.
std::vector<DistributionNumber> class_numbers(const ClassSet& set);

/// Least distances of pairs beside those that are kept, as a table.
DistributionTable distance_table(const ClassSet& set);

// Spectra of points with classes, as means over several sets.

/// Means over settings.sets sets in 2D, of which `first` is the first; makes the others, by the tiles of the first
/// where it has some. Throws InputError and DeviceError as throw_classes() does.
ClassSpectra averaged_spectra(const ClassSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                              const ClassSet& first);

/// Columns frequency,all,class_I...,cross_I_J..., and with several sets the same again, in that order, as ..._error.
std::string spectra_csv(const ClassSpectra& spectra);

}
