// Point sets from files, so that an experiment can compare methods with sets made elsewhere.
#pragma once

#include "host/sampling/sampler.hpp"

namespace poissonlab {

/// `file`: reads each point set that `path` names, one or more a file (see base/points/point_file.hpp).
///
/// `path` is a list of names and globs (* ? [...]), relative to the folder of the config file. Files are
/// taken in the order of the list, those of a glob sorted by name. Its check throws InputError when there is
/// no such file, when one is named twice, when sizes or dimensions differ.
SamplerSpec file_sampler();

}
