# Run as a script by cmake/code_versions.cmake: writes OUTPUT from the files below SOURCE.

# hash_of(VARIABLE PATTERNS...): a hash of the names and contents of the files that match.
function(hash_of variable)
  list(TRANSFORM ARGN PREPEND "${SOURCE}/")
  file(GLOB_RECURSE files LIST_DIRECTORIES false RELATIVE ${SOURCE} ${ARGN})
  list(FILTER files EXCLUDE REGEX "CMakeLists.txt$")
  list(SORT files)
  set(all "")
  foreach(file IN LISTS files)
    file(SHA256 ${SOURCE}/${file} hash)
    string(APPEND all "${file} ${hash}\n")
  endforeach()
  string(SHA256 hash "${all}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${variable} ${hash} PARENT_SCOPE)
endfunction()

# What a tile set is made with.
set(construction kernels/* host/device/* host/geometry/* host/sampling/* host/tiles/* host/poisson_tiles/*
    host/tile_construction/*)
hash_of(construction_version ${construction})
hash_of(sampling_version ${construction} host/tile_points/* host/tile_sampling/* host/experiment/command_sampler.*
        host/experiment/sample_unit.* host/io/point_file*)
hash_of(analysis_version analysis/* host/geometry/* host/io/point_file* host/experiment/archives.hpp
        host/experiment/analysis_unit.* host/experiment/experiment.hpp host/experiment/iteration_records.*
        host/experiment/result_tables.* host/experiment/series_analysis.* host/experiment/zone_plate_analysis.*)
hash_of(picture_version host/tiles/* host/poisson_tiles/* host/tile_construction/* host/sampling/* kernels/*
        host/experiment/construction_* host/experiment/tiling_*)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once
#define POISSONLAB_CONSTRUCTION_VERSION \"${construction_version}\"
#define POISSONLAB_SAMPLING_VERSION \"${sampling_version}\"
#define POISSONLAB_ANALYSIS_VERSION \"${analysis_version}\"
#define POISSONLAB_PICTURE_VERSION \"${picture_version}\"
" @ONLY)
