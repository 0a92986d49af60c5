# lab_room(TARGET FOLDERS... FILES... EXCEPT FILES... ALONE FILES... PUBLIC LIBRARIES... PRIVATE LIBRARIES...): a library
# of every source file in these folders and below, and of FILES, but for those EXCEPT, regular expressions for the ends of
# paths below the current folder. A new file belongs to it without being listed anywhere.
#
# Files ALONE have a heavy header to themselves when the others are compiled together.
function(lab_room target)
  cmake_parse_arguments(ARG "" "" "FOLDERS;FILES;EXCEPT;ALONE;PUBLIC;PRIVATE" ${ARGN})
  list(TRANSFORM ARG_FOLDERS APPEND "/*.cpp" OUTPUT_VARIABLE patterns)
  set(sources "")
  if(patterns)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${patterns})
  endif()
  foreach(name IN LISTS ARG_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "(^|/)${name}$")
  endforeach()
  add_library(${target} STATIC ${sources} ${ARG_FILES})
  target_link_libraries(${target} PUBLIC lab_options ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} fmt::fmt)
  lab_precompile(${target})
  lab_unity(${target} 24)
  set_source_files_properties(${ARG_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# lab_unity(TARGET FILES): with POISSONLAB_UNITY so many source files are compiled as one, which takes a third of the time:
# most of it goes into headers that they share. Names in unnamed namespaces must differ within a target.
function(lab_unity target files)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${POISSONLAB_UNITY} UNITY_BUILD_BATCH_SIZE ${files})
  if(POISSONLAB_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # GCC takes a source file that another one includes for a header, where unnamed namespaces would be a mistake.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()
