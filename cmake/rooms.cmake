# lab_room(TARGET FOLDERS... PUBLIC LIBRARIES... PRIVATE LIBRARIES...): a library of every source file in these folders
# and below. A new file belongs to it without being listed anywhere.
function(lab_room target)
  cmake_parse_arguments(ARG "" "" "FOLDERS;EXCEPT;PUBLIC;PRIVATE" ${ARGN})
  list(TRANSFORM ARG_FOLDERS APPEND "/*.cpp" OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
  foreach(name IN LISTS ARG_EXCEPT)
    list(FILTER sources EXCLUDE REGEX "/${name}$")
  endforeach()
  add_library(${target} STATIC ${sources})
  target_link_libraries(${target} PUBLIC lab_options ${ARG_PUBLIC} PRIVATE ${ARG_PRIVATE} fmt::fmt)
  lab_precompile(${target})
endfunction()
