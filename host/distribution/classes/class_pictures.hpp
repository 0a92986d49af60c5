// Points of several classes as pictures: where they are, and their spectra.
#pragma once

#include "host/distribution/classes/class_means.hpp"
#include "host/distribution/classes/class_points.hpp"
#include "host/sampling/classes/class_darts.hpp"
#include "results/pictures/curve_chart.hpp"
#include "results/pictures/distribution_files.hpp"
#include "results/pictures/mark_picture.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace poissonlab {

/// Draws points as disks, which have a colour for each class and are as large as its distances. In 3D only the lowest
/// tenth is shown. In a region, outlines and obstacles are drawn as well.
MarkPicture class_picture(const ClassSet& set);

/// Classes that have points, by which spectra are listed.
std::vector<std::uint32_t> used_classes(const ClassedPoints& points);

/// Spectra of all classes that have points, up to a frequency; 0: as far as those of all points together are of
/// interest. 2D only.
CrossSpectra class_spectra(const ClassedPoints& points, std::size_t bins = 0);

/// Adds pictures of the mean radial power of each class and of all points, and of the cross power of each pair of
/// classes, and spectra.csv. A set has `points` points. `names` has the names of all classes; empty: their numbers.
void add_class_spectra(std::size_t points, const ClassSpectra& spectra, const std::vector<std::string>& names,
                       DistributionFiles& files, DistributionResult& result);

}
