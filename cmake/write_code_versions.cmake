# Run as a script by cmake/code_versions.cmake: writes OUTPUT from the files below SOURCE, and beside it code_files.txt,
# which lists them for tests.
set(listed "")

# hash_of(VARIABLE PATTERNS...): a hash of the names and contents of the files that match.
function(hash_of variable)
  list(TRANSFORM ARGN PREPEND "${SOURCE}/")
  foreach(pattern IN LISTS ARGN)
    file(GLOB_RECURSE files LIST_DIRECTORIES false ${pattern})
    if(NOT files)
      message(FATAL_ERROR "cmake/write_code_versions.cmake: no file is ${pattern}")
    endif()
  endforeach()
  file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${SOURCE} ${ARGN})
  list(FILTER files EXCLUDE REGEX "CMakeLists.txt$|^base/crew/") # which process does the work changes no result
  list(SORT files)
  set(all "")
  foreach(file IN LISTS files)
    file(SHA256 ${SOURCE}/${file} hash)
    string(APPEND all "${file} ${hash}\n")
    string(APPEND listed "${variable} ${file}\n")
  endforeach()
  string(SHA256 hash "${all}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${variable} ${hash} PARENT_SCOPE)
  set(listed "${listed}" PARENT_SCOPE)
endfunction()

# Whole folders, and everything that these include: tests/experiment/series/code_versions_test.cpp follows the includes.
set(construction kernels/* runtime/*.h base/* tiles/* host/device/* host/sampling/* host/tile_construction/*
    results/records/*)
hash_of(construction_version ${construction})
hash_of(sampling_version ${construction} host/tile_points/* host/tile_sampling/* host/settings/tilings/*
        configs/tilings/* host/distribution/regions/*
        host/distribution/region_samplers/* analysis/regions/framed_region.* analysis/regions/boundary_edges.*
        experiment/series/*)
hash_of(analysis_version base/* analysis/* results/* experiment/measuring/* experiment/series/*)
hash_of(picture_version ${construction} analysis/tilings/* results/pictures/* host/tile_points/* host/tile_sampling/*
        host/kinds/* host/scenes/* experiment/exhibits/* experiment/series/*)
hash_of(distribution_version ${construction} host/tile_points/* host/tile_sampling/* host/distribution/* host/schemes/*
        host/texture/* host/kinds/* host/settings/tilings/* configs/tilings/* analysis/* results/pictures/* results/blue_noise.* results/series.*
        results/method_grid.hpp results/statistic.* results/curve_tables.*
        experiment/exhibits/* experiment/series/*)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once
#define POISSONLAB_CONSTRUCTION_VERSION \"${construction_version}\"
#define POISSONLAB_SAMPLING_VERSION \"${sampling_version}\"
#define POISSONLAB_ANALYSIS_VERSION \"${analysis_version}\"
#define POISSONLAB_PICTURE_VERSION \"${picture_version}\"
#define POISSONLAB_DISTRIBUTION_VERSION \"${distribution_version}\"
" @ONLY)
get_filename_component(folder ${OUTPUT} DIRECTORY)
file(WRITE ${folder}/code_files.txt "${listed}")
