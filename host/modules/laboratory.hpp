// The modules of the laboratory: what each brings, and which of them this program has.
//
// To add a module: list it in cmake/modules.cmake, write host/modules/NAME.cpp, and print the manifest anew
// (`poissonlab manual --stored`). A program that lacks a module knows its words from the manifest.
#pragma once

#include "host/kinds/kind.hpp"
#include "host/sampling/sampler.hpp"

#include <string>
#include <vector>

namespace poissonlab {

/// The laboratory holds the samplers and kinds of work that configs, commands and Python can ask for.
struct Laboratory
{
    SamplerRegistry samplers;
    SamplerRegistry region_samplers; ///< of sets in regions of the plane
    std::vector<Kind> kinds;
};

/// A module by its name, and the function that adds what it brings.
struct Module
{
    std::string name;
    void (*add)(Laboratory& laboratory);
};

// Each is in the file of its name.
void add_core(Laboratory& laboratory);
void add_methods(Laboratory& laboratory);
void add_own_methods(Laboratory& laboratory);
void add_tiles(Laboratory& laboratory);
void add_other_tiles(Laboratory& laboratory);
void add_tilings(Laboratory& laboratory);
void add_textures(Laboratory& laboratory);
void add_regions(Laboratory& laboratory);
void add_distributions(Laboratory& laboratory);
void add_surfaces(Laboratory& laboratory);
void add_classes(Laboratory& laboratory);
void add_surface_textures(Laboratory& laboratory);
void add_surface_spectra(Laboratory& laboratory);
void add_surface_classes(Laboratory& laboratory);
void add_geometry_tiles(Laboratory& laboratory);
void add_recursive_tiles(Laboratory& laboratory);
void add_sphere(Laboratory& laboratory);

/// The modules of this program; CMake writes the list.
const std::vector<Module>& built_modules();

/// Everything, in the order of the manifest; what this program lacks is there by name (see SamplerSpec::absent_module).
const Laboratory& laboratory();

/// False where this program lacks a module that the manifest knows.
bool has_all_modules();

/// Throws MissingModule where this program lacks a module.
void need_all_modules();

}
