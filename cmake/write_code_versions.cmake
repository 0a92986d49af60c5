# Run as a script by cmake/code_versions.cmake: writes OUTPUT from the files below SOURCE, and beside it code_files.txt,
# which lists them for tests.
set(listed "")

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
    string(APPEND listed "${variable} ${file}\n")
  endforeach()
  string(SHA256 hash "${all}")
  string(SUBSTRING ${hash} 0 16 hash)
  set(${variable} ${hash} PARENT_SCOPE)
  set(listed "${listed}" PARENT_SCOPE)
endfunction()

# Everything that these parts include, and not only what they are: tests/experiment/code_versions_test.cpp follows the
# includes. Whole folders where most of a folder counts.
set(construction kernels/* runtime/*.h host/device/* host/errors/* host/geometry/* host/io/* host/sampling/* host/tiles/*
    host/poisson_tiles/* host/tile_construction/*)
set(records host/experiment/archives.hpp host/experiment/experiment.hpp host/experiment/work_listener.hpp)
hash_of(construction_version ${construction})
hash_of(sampling_version ${construction} ${records} host/tile_points/* host/tile_sampling/*
        host/experiment/command_sampler.* host/experiment/imported_points.* host/experiment/sample_unit.*
        host/experiment/series_work.*)
hash_of(analysis_version ${records} analysis/* host/errors/* host/geometry/* host/io/* host/experiment/analysis_unit.*
        host/experiment/iteration_records.* host/experiment/result_tables.* host/experiment/series_analysis.*
        host/experiment/series_work.* host/experiment/zone_plate_analysis.*)
hash_of(picture_version ${construction} ${records} host/experiment/construction_* host/experiment/picture_units.*
        host/experiment/tiling_*)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once
#define POISSONLAB_CONSTRUCTION_VERSION \"${construction_version}\"
#define POISSONLAB_SAMPLING_VERSION \"${sampling_version}\"
#define POISSONLAB_ANALYSIS_VERSION \"${analysis_version}\"
#define POISSONLAB_PICTURE_VERSION \"${picture_version}\"
" @ONLY)
get_filename_component(folder ${OUTPUT} DIRECTORY)
file(WRITE ${folder}/code_files.txt "${listed}")
