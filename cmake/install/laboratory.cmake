# The program with its manual page, configs and documentation, and the Debian package of everything.
if(NOT lab_has_all_modules)
  install(CODE "message(FATAL_ERROR \"this build lacks modules: ./lab build adds them\")")
  return()
endif()
install(TARGETS poissonlab RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS poissonlab_pictures poissonlab_particles poissonlab_globe poissonlab_drawings
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/poissonlab)
install(DIRECTORY configs DESTINATION ${data_folder})
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs PATTERN site EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(POISSONLAB_PYTHON)
  install(TARGETS poissonlab_python LIBRARY DESTINATION ${POISSONLAB_PYTHON_DIR}/poissonlab)
  install(DIRECTORY python/poissonlab DESTINATION ${POISSONLAB_PYTHON_DIR} PATTERN __pycache__ EXCLUDE)
  install(FILES ${PROJECT_BINARY_DIR}/python/poissonlab/samplers.pyi DESTINATION ${POISSONLAB_PYTHON_DIR}/poissonlab)
  install(FILES python/examples/poisson_disk_sets.ipynb DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)
endif()

# Shells complete commands and options by what the program itself says.
foreach(shell bash zsh)
  add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/completion.${shell}
    COMMAND poissonlab completion ${shell} > ${PROJECT_BINARY_DIR}/completion.${shell}
    DEPENDS poissonlab VERBATIM)
endforeach()
add_custom_target(completion_scripts ALL
  DEPENDS ${PROJECT_BINARY_DIR}/completion.bash ${PROJECT_BINARY_DIR}/completion.zsh)
install(FILES ${PROJECT_BINARY_DIR}/completion.bash
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME poissonlab)
install(FILES ${PROJECT_BINARY_DIR}/completion.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions
  RENAME _poissonlab)
install(FILES ${PROJECT_BINARY_DIR}/poissonlab.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)

# cpack -G DEB. The libraries that the program is linked with are found by dpkg-shlibdeps; the rest is named here.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the authors of the Poisson disk laboratory <poissonlab@localhost>")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "pocl-opencl-icd | opencl-icd, gnuplot-nox | gnuplot, fonts-dejavu-core")
if(POISSONLAB_PYTHON)
  # The module is for the Python that it was built with.
  find_package(Python REQUIRED COMPONENTS Interpreter)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", python3-numpy, python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}~)"
    ", python3 (<< ${Python_VERSION_MAJOR}.${next_python})")
  set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/debian/postinst ${CMAKE_CURRENT_LIST_DIR}/debian/prerm)
endif()
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Makes Poisson disk point sets and tile sets with OpenCL, measures them as the
literature does, and writes reports. Has headers that evaluate Poisson disk
tile sets at run time, and tile sets to begin with.")
file(WRITE ${PROJECT_BINARY_DIR}/generated/copyright
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/

Files: *
Copyright: 2026 the authors of the Poisson disk laboratory
License: GPL-3.0-or-later
 The full text is in /usr/share/common-licenses/GPL-3.

Files: usr/include/poissonlab/* usr/share/doc/poissonlab/runtime/*
Copyright: 2026 the authors of the Poisson disk laboratory
License: MIT-0
 The full text is in /usr/share/doc/poissonlab/runtime/LICENSE.

Files: usr/share/poissonlab/tile_sets/*
Copyright: none
License: CC0-1.0
 The full text is in /usr/share/poissonlab/tile_sets/LICENSE.
")
install(FILES ${PROJECT_BINARY_DIR}/generated/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

# cpack --config CPackSourceConfig.cmake, or the target package_source: one archive, without what is built and made here.
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME poissonlab-${PROJECT_VERSION})
string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" source_pattern "${PROJECT_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES "^${source_pattern}/build/" "^${source_pattern}/out/" "/\\.git/" "/\\.git$" "/__pycache__/")
include(CPack)
