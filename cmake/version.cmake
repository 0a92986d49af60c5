# POISSONLAB_VERSION: the project version. POISSONLAB_VERSION_STRING: the same and, in a git checkout, the commit it was
# built from. POISSONLAB_BUILT_WITH: compiler and libraries, in a line.
# Written to version.hpp at every build, and only when it changed, so that nothing rebuilds needlessly.
find_path(OPENIMAGEIO_INCLUDE_DIR OpenImageIO/imageio.h REQUIRED)
file(STRINGS ${OPENIMAGEIO_INCLUDE_DIR}/OpenImageIO/oiioversion.h openimageio REGEX "OIIO_VERSION_(MAJOR|MINOR|PATCH) +[0-9]")
list(TRANSFORM openimageio REPLACE "[^0-9]" "")
list(JOIN openimageio "." openimageio)
set(built_with "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" "CGAL ${CGAL_VERSION}"
  "OpenImageIO ${openimageio}" "OpenEXR ${OpenEXR_VERSION}")
if(MPI_C_FOUND)
  list(APPEND built_with "MPI ${MPI_C_VERSION}")
else()
  list(APPEND built_with "no MPI")
endif()
list(JOIN built_with ", " built_with)

set(version_header ${PROJECT_BINARY_DIR}/generated/version.hpp)
add_custom_target(write_version_header
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${version_header} -DVERSION=${PROJECT_VERSION} "-DBUILT_WITH=${built_with}"
          -DSOURCE=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/write_version_header.cmake
  BYPRODUCTS ${version_header}
  VERBATIM)
add_library(lab_version INTERFACE)
add_dependencies(lab_version write_version_header)
target_include_directories(lab_version INTERFACE ${PROJECT_BINARY_DIR}/generated)
