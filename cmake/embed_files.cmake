# embed_files(TARGET HEADER FUNCTION FILE...): make text files part of the binary.
#
# Adds a source file to TARGET that defines `std::string_view poissonlab::FUNCTION(std::string_view name)`, declared in
# HEADER: the text of the FILE of that name (relative to the calling folder), empty for unknown names. The program then
# needs no files beside it at run time.
function(embed_files target header function)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/write_embedded_files.cmake)
  list(JOIN ARGN "|" files)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${files}" -DHEADER=${header} -DFUNCTION=${function}
            -DBASE=${CMAKE_CURRENT_SOURCE_DIR} -P ${script}
    DEPENDS ${ARGN} ${script}
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    COMMENT "Embedding ${function}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
