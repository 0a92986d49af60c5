// This function adds points with classes to an experiment of `poissonlab analyze`.
#pragma once

#include "experiment/series/experiment.hpp"

#include <string>

namespace poissonlab {

/// Adds a series of each class to the experiment of one set, whose points are those of a file, and the comparison of
/// the classes. `keys` are lines of a [[distribution]] of kind = "class-set", which reads that file. A
/// class of one point has no series, with a note. Throws InputError for what that kind refuses, and where the file has
/// another number of points than the set by now.
void add_class_series(Experiment& experiment, const std::string& keys);

}
