// Measures points with classes, made here or elsewhere: what classes have to do with each other.
#pragma once

#include "analysis/classes/class_pairs.hpp"
#include "analysis/spectra/cross_spectrum.hpp"
#include "base/regions/region_reading.hpp"
#include "host/kinds/kind.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace poissonlab {

/// The keys of kind = "class-set".
struct ClassSetSettings
{
    std::filesystem::path set;
    std::string classes = "class"; ///< see PointClasses
    std::string region;            ///< empty: a torus
    RegionReading reading;
    std::string domain;  ///< as for parse_domain(); empty: what the file says
    bool window = false; ///< the domain is a region, whose sides do not meet
    std::optional<double> reach;
    std::uint32_t labellings = 39;
    std::shared_ptr<const struct ClassSetPoints> read{}; ///< where they were read already
};

/// Points with classes, and where they lie.
struct ClassSetPoints
{
    PointSet points;                   ///< coordinates as ClassPlace has them
    std::vector<std::uint8_t> classes; ///< of each point
    std::vector<std::string> names;    ///< of classes, in rising order if they are numbers, else in that of letters
    std::shared_ptr<const FramedRegion> region{}; ///< null: a torus
    PeriodicBox box{};                            ///< of that
    double unit = 1;                  ///< lengths of ClassPlace are so long, in units of the file or of the region
    std::vector<std::string> notes{}; ///< sentences on what was made of the files

    PointSet of_class(std::size_t number) const;
    std::vector<PointSet> by_class() const;
};

/// A file has so many classes at most.
inline constexpr std::size_t most_measured_classes = 64;

/// Numbers the classes of points by their names. Throws InputError for a point without one, for fewer than two and for
/// more than most_measured_classes; `file` is for the message.
void number_classes(const std::vector<std::string>& class_of_point, const std::string& file, ClassSetPoints& to);

/// Reads both files, unless the settings have them. Throws InputError.
std::shared_ptr<const ClassSetPoints> read_class_set(const ClassSetSettings& settings);

/// A pair of classes, or one class twice.
struct ClassPairMeasures
{
    std::size_t first = 0, second = 0;
    double least = 0;       ///< distance; infinite where there is none. Lengths are in units of the file or the region
    double mean_first = 0;  ///< distance of points of the first from their nearest ones of the second
    double mean_second = 0; ///< and of the second from the first
    ClassDistanceSteps steps;   ///< in lengths of ClassPlace
    std::vector<double> values; ///< the pair correlation
};

struct ClassSetMeasures
{
    std::vector<ClassPairMeasures> own;   ///< of each class
    ClassPairMeasures all;                ///< of all points
    std::vector<ClassPairMeasures> cross; ///< of pairs (0, 1), (0, 2), (1, 2), (0, 3), ...
    MarkCorrelation marks;                ///< over the distances of all.steps
    std::uint32_t labellings = 0;
    std::optional<CrossSpectra> spectra; ///< none in a box whose sides differ
    double covariance_error = 0;         ///< of areas in common, over the region's area
};

ClassSetMeasures measure_class_set(const ClassSetPoints& set, const ClassSetSettings& settings,
                                   const std::function<void(const std::string& what)>& on_step);

/// Returns kind = "class-set", which measures a file of points.
Kind class_set_kind();

}
