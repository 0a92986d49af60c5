// The parts of the Python module, a file each.
#pragma once

#include <pybind11/pybind11.h>

namespace poissonlab {

void add_samplers(pybind11::module_& module);
void add_point_files(pybind11::module_& module);
void add_analysis(pybind11::module_& module);
void add_results(pybind11::module_& module);
void add_tile_sets(pybind11::module_& module);
void add_kinds(pybind11::module_& module);

}
