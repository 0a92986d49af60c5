# Run as a script by cmake/version.cmake: writes OUTPUT from VERSION, the git commit of SOURCE, and BUILT_WITH.
set(commit "")
find_program(git git)
if(git)
  execute_process(COMMAND ${git} -C ${SOURCE} describe --always --dirty --exclude=*
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
set(text "${VERSION}")
if(commit)
  string(APPEND text " (${commit})")
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once
#define POISSONLAB_VERSION \"${VERSION}\"
#define POISSONLAB_BUILT_WITH \"${BUILT_WITH}\"
#define POISSONLAB_VERSION_STRING \"${text}\"
" @ONLY)
