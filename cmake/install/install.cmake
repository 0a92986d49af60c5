# What `cmake --install` puts where, `cpack`'s Debian package, and the target `uninstall`.
#
# The module of pictures lies in lib/poissonlab, where the program looks for it relative to itself: an installed tree can
# be moved.
set(data_folder ${CMAKE_INSTALL_DATADIR}/poissonlab)

include(${CMAKE_CURRENT_LIST_DIR}/runtime.cmake)
if(NOT POISSONLAB_RUNTIME_ONLY)
  include(${CMAKE_CURRENT_LIST_DIR}/laboratory.cmake)
endif()

# Everything that the last `cmake --install` of this build folder wrote, and the folders that are empty then.
add_custom_target(uninstall VERBATIM
  COMMAND ${CMAKE_COMMAND} -DMANIFEST=${PROJECT_BINARY_DIR}/install_manifest.txt
          -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake)
