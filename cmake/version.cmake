# POISSONLAB_VERSION_STRING: the project version and, in a git checkout, the commit it was built from.
# Written to version.hpp at every build, and only when it changed, so that nothing rebuilds needlessly.
set(version_header ${PROJECT_BINARY_DIR}/generated/version.hpp)
add_custom_target(write_version_header
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${version_header} -DVERSION=${PROJECT_VERSION}
          -DSOURCE=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/write_version_header.cmake
  BYPRODUCTS ${version_header}
  VERBATIM)
add_library(lab_version INTERFACE)
add_dependencies(lab_version write_version_header)
target_include_directories(lab_version INTERFACE ${PROJECT_BINARY_DIR}/generated)
