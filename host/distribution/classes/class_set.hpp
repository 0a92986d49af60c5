// Measures points with classes, made here or elsewhere, and compares the classes.
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
    std::string domain;  ///< a text for parse_domain(); empty: the file's domain
    bool window = false; ///< the domain is a region, whose sides do not meet
    std::optional<double> reach;
    std::uint32_t labellings = 39;
    std::shared_ptr<const struct ClassSetPoints> read{}; ///< the points if they were read already
};

/// Points with classes, and their place.
struct ClassSetPoints
{
    PointSet points;                              ///< coordinates as ClassPlace has them
    std::vector<std::uint8_t> classes;            ///< a number for each point
    std::vector<std::string> names;               ///< numbers in rising order, then words in alphabetical order
    std::shared_ptr<const FramedRegion> region{}; ///< null: a torus
    PeriodicBox box{};                            ///< sides of the torus
    double unit = 1;                  ///< the unit of length of ClassPlace, in units of the file or of the region
    std::vector<std::string> notes{}; ///< sentences on how the files were read

    PointSet of_class(std::size_t number) const;
    std::vector<PointSet> by_class() const;
};

/// Reads both files, unless the settings have them. Throws InputError.
std::shared_ptr<const ClassSetPoints> read_class_set(const ClassSetSettings& settings);

/// A pair of classes, or one class twice.
struct ClassPairMeasures
{
    std::size_t first = 0, second = 0;
    double least = 0; ///< least distance; infinite if there is none. Lengths are in units of the file or the region
    double mean_first = 0;      ///< mean distance of points of the first from their nearest ones of the second
    double mean_second = 0;     ///< mean distance of points of the second from their nearest ones of the first
    ClassDistanceSteps steps;   ///< in lengths of ClassPlace
    std::vector<double> values; ///< the pair correlation function
    double pairs = 0;           ///< pairs of points that it is a sum over, each counted once
};

struct ClassSetMeasures
{
    std::vector<ClassPairMeasures> own;   ///< one for each class
    ClassPairMeasures all;                ///< all points as one class
    std::vector<ClassPairMeasures> cross; ///< pairs (0, 1), (0, 2), (1, 2), (0, 3), ...
    MarkCorrelation marks;                ///< a function of the distances of all.steps
    std::uint32_t labellings = 0;
    std::optional<CrossSpectra> spectra; ///< none in a box whose sides differ
    double covariance_error = 0;         ///< the error of common areas, over the region's area
};

ClassSetMeasures measure_class_set(const ClassSetPoints& set, const ClassSetSettings& settings,
                                   const std::function<void(const std::string& what)>& on_step);

/// Returns kind = "class-set", which measures a file of points.
Kind class_set_kind();

}
