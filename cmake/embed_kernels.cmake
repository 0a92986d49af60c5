# embed_kernels(TARGET FILE...): make kernel sources part of the binary.
#
# Generates kernel_sources.cpp, which defines poissonlab::embedded_kernel_file(name) (declared in
# host/device/kernel_source.hpp), so that the program needs no files beside it at run time.
function(embed_kernels target)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/kernel_sources.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/write_kernel_sources.cmake)
  list(JOIN ARGN "|" files)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${files}"
            -DBASE=${CMAKE_CURRENT_SOURCE_DIR} -P ${script}
    DEPENDS ${ARGN} ${script}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Embedding kernels"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
