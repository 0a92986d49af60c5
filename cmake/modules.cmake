# Modules: what a program may have beside the core. A module is one stem in parallel rooms: host/modules/NAME.cpp with what
# it brings to configs, and app/commands/NAME/commands.cpp with its commands.
#
# POISSONLAB_MODULES says which the program gets. ./lab begins with none and adds those that a config or a command names;
# tests, benchmarks and the Python package take all.
set(lab_host_modules
  methods own_methods tiles other_tiles tilings textures regions distributions classes surfaces surface_textures
  surface_spectra surface_classes geometry_tiles recursive_tiles sphere)
set(lab_command_modules
  results tiles tilings textures regions distributions classes surfaces surface_textures
  surface_classes recursive_tiles large_sets manual)
# These modules are built when work needs them, because no command and no key names them: files of HDF5, points in files
# other than text, processes of MPI, the sequential twins of kernels, sets in 3D, measures of tiled sets, the zone plate.
set(lab_wordless_modules particles point_formats processes reference space tile_measures zone_plate)
set(lab_all_modules ${lab_host_modules} ${lab_command_modules} ${lab_wordless_modules})
list(REMOVE_DUPLICATES lab_all_modules)

# lab_needs_of_NAME has the modules that NAME stands on, which may stand on others.
set(lab_needs_of_methods reference)
set(lab_needs_of_particles point_formats)
set(lab_needs_of_tiles point_formats reference tile_measures)
set(lab_needs_of_tilings reference)
set(lab_needs_of_regions methods point_formats)
set(lab_needs_of_large_sets methods)
set(lab_needs_of_other_tiles methods tiles)
set(lab_needs_of_distributions methods point_formats)
set(lab_needs_of_classes methods regions)
set(lab_needs_of_textures methods)
set(lab_needs_of_surfaces methods point_formats)
set(lab_needs_of_surface_spectra surfaces)
set(lab_needs_of_surface_classes classes surfaces)
set(lab_needs_of_surface_textures distributions textures surfaces)
set(lab_needs_of_geometry_tiles distributions surfaces)
set(lab_needs_of_recursive_tiles distributions other_tiles)
set(lab_needs_of_sphere other_tiles distributions surface_spectra tilings)

set(POISSONLAB_MODULES all CACHE STRING "The modules of the program: all, or some of ${lab_all_modules}")
set(lab_modules_of_program ${POISSONLAB_MODULES})
if(POISSONLAB_TESTS OR POISSONLAB_BENCHMARKS OR POISSONLAB_PYTHON OR POISSONLAB_FUZZ OR "all" IN_LIST POISSONLAB_MODULES
   OR "manual" IN_LIST POISSONLAB_MODULES)
  set(lab_modules_of_program ${lab_all_modules})
endif()
foreach(name IN LISTS POISSONLAB_MODULES)
  foreach(needed IN LISTS lab_needs_of_${name})
    list(APPEND lab_modules_of_program ${needed} ${lab_needs_of_${needed}})
    foreach(further IN LISTS lab_needs_of_${needed})
      list(APPEND lab_modules_of_program ${lab_needs_of_${further}})
    endforeach()
  endforeach()
  if(NOT name STREQUAL "all" AND NOT name IN_LIST lab_all_modules)
    list(JOIN lab_all_modules ", " known)
    message(FATAL_ERROR "POISSONLAB_MODULES: \"${name}\" is no module; there are ${known}, and all")
  endif()
endforeach()

list(REMOVE_DUPLICATES lab_modules_of_program)
set(lab_has_all_modules YES)
foreach(name IN LISTS lab_all_modules)
  if(NOT name IN_LIST lab_modules_of_program)
    set(lab_has_all_modules NO)
  endif()
endforeach()

# What parts of the core call that only modules have: a program without these has files called without_*.cpp, which ask
# for the module.
set(lab_program_has_regions NO)
set(lab_program_has_shapes NO) # of regions
set(lab_program_has_tiles NO)
set(lab_program_has_kinds NO) # or methods that follow densities
foreach(name IN LISTS lab_modules_of_program)
  if(name IN_LIST lab_all_modules AND NOT name IN_LIST lab_wordless_modules AND NOT name MATCHES "^(own_methods|results)$")
    set(lab_program_has_kinds YES)
  endif()
  if(name STREQUAL regions)
    set(lab_program_has_regions YES)
    set(lab_program_has_shapes YES)
  endif()
  if(name MATCHES "^(tiles|other_tiles|tilings|textures|distributions|classes|surfaces|surface_textures)$")
    set(lab_program_has_shapes YES)
    set(lab_program_has_tiles YES)
  endif()
endforeach()

# lab_module_list(TARGET HEADER TYPE FUNCTION ADDS LIBRARY NAMES...): objects of a source file that lists modules as
# FUNCTION() of HEADER, {"NAME", ADDS}, and that link LIBRARY of each. NAME in these two stands for the module's.
function(lab_module_list target header type function adds library)
  set(rows "")
  set(libraries "")
  foreach(name IN LISTS ARGN)
    string(REPLACE NAME ${name} row "        {\"NAME\", ${adds}},\n")
    string(APPEND rows "${row}")
    string(REPLACE NAME ${name} library_of_module ${library})
    list(APPEND libraries ${library_of_module})
  endforeach()
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp)
  file(CONFIGURE OUTPUT ${file} @ONLY CONTENT "// Written by cmake/modules.cmake.
#include \"${header}\"

namespace poissonlab {

const std::vector<${type}>& ${function}()
{
    static const std::vector<${type}> all{
${rows}    };
    return all;
}

}
")
  add_library(${target} OBJECT ${file})
  target_link_libraries(${target} PUBLIC lab_options ${libraries} fmt::fmt)
  lab_precompile(${target})
  lab_unity(${target} 24) # with the files that stand in for modules
  lab_cold(${target})
endfunction()
