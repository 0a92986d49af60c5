# The headers for other programs with the tile sets that ship: `find_package(poissonlab_runtime)` gives the target
# poissonlab::runtime and the folder poissonlab_runtime_TILE_SETS, `pkg-config poissonlab_runtime` the same.
include(CMakePackageConfigHelpers)

add_library(poissonlab_runtime INTERFACE)
add_library(poissonlab::runtime ALIAS poissonlab_runtime)
set_target_properties(poissonlab_runtime PROPERTIES EXPORT_NAME runtime)
target_include_directories(poissonlab_runtime INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/runtime> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/poissonlab>)

# Nothing here depends on the machine: packages of headers belong into share.
set(package_folder ${CMAKE_INSTALL_DATADIR}/cmake/poissonlab_runtime)
set(tile_set_folder ${data_folder}/tile_sets)
install(TARGETS poissonlab_runtime EXPORT poissonlab_runtime)
install(EXPORT poissonlab_runtime NAMESPACE poissonlab:: DESTINATION ${package_folder}
  FILE poissonlab_runtime-targets.cmake)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/poissonlab_runtime-config.cmake.in
  ${PROJECT_BINARY_DIR}/generated/poissonlab_runtime-config.cmake
  INSTALL_DESTINATION ${package_folder} PATH_VARS tile_set_folder NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/poissonlab_runtime-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
configure_file(${CMAKE_CURRENT_LIST_DIR}/poissonlab_runtime.pc.in
  ${PROJECT_BINARY_DIR}/generated/poissonlab_runtime.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/generated/poissonlab_runtime-config.cmake
  ${PROJECT_BINARY_DIR}/generated/poissonlab_runtime-config-version.cmake DESTINATION ${package_folder})
install(FILES ${PROJECT_BINARY_DIR}/generated/poissonlab_runtime.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

install(DIRECTORY runtime/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/poissonlab
  FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp" PATTERN "*.js" PATTERN "*.wgsl"
  PATTERN tile_sets EXCLUDE PATTERN examples EXCLUDE PATTERN godot EXCLUDE PATTERN blender EXCLUDE)
install(DIRECTORY runtime/tile_sets/ DESTINATION ${tile_set_folder})
install(DIRECTORY runtime/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/runtime
  PATTERN "*.h" EXCLUDE PATTERN "*.hpp" EXCLUDE PATTERN tile_sets EXCLUDE)
