// The parts of the Python module, a file each.
#pragma once

#include <pybind11/pybind11.h>

namespace poissonlab {

struct ParameterSpec;

void add_samplers(pybind11::module_& module);
void add_point_files(pybind11::module_& module);
void add_analysis(pybind11::module_& module);
void add_results(pybind11::module_& module);
void add_tile_sets(pybind11::module_& module);
void add_monotile_sets(pybind11::module_& module);
void add_kinds(pybind11::module_& module);

/// Returns the name of a parameter's kind, for hints of types.
const char* kind_of(const ParameterSpec& spec);

/// Returns the default as Python has it, a sampler by its name; None where no value can say it.
pybind11::object default_of(const ParameterSpec& spec);

}
