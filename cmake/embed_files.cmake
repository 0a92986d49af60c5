# embed_files(TARGET HEADER FUNCTION FOLDER FILE...): make text files part of the binary.
#
# Adds a source file to TARGET that defines `std::string_view poissonlab::FUNCTION(std::string_view name)`, declared in
# HEADER: the text of the FILE of that name (relative to FOLDER), empty for unknown names. The program then needs no files
# beside it at run time.
function(embed_files target header function folder)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/write_embedded_files.cmake)
  list(JOIN ARGN "|" files)
  list(TRANSFORM ARGN PREPEND ${folder}/ OUTPUT_VARIABLE paths)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} "-DFILES=${files}" -DHEADER=${header} -DFUNCTION=${function}
            -DBASE=${folder} -P ${script}
    DEPENDS ${paths} ${script}
    COMMENT "Embedding ${function}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON) # all have the same names inside
endfunction()
