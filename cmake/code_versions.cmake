# code_hashes.hpp: hashes of the source files that decide what point sets, and what analyses of them, come out. They are
# part of the keys under which finished work is stored, so that no result outlives the code that made it. Written at
# every build, and only when a hash changed.
set(code_hashes_header ${PROJECT_BINARY_DIR}/generated/code_hashes.hpp)
add_custom_target(write_code_versions
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${code_hashes_header} -DSOURCE=${PROJECT_SOURCE_DIR}
          -P ${PROJECT_SOURCE_DIR}/cmake/write_code_versions.cmake
  BYPRODUCTS ${code_hashes_header}
  VERBATIM)
add_library(lab_code_versions INTERFACE)
add_dependencies(lab_code_versions write_code_versions)
target_include_directories(lab_code_versions INTERFACE ${PROJECT_BINARY_DIR}/generated)
