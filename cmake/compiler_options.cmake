# Options that every target of the laboratory shares, as the interface library lab_options.
add_library(lab_options INTERFACE)
target_compile_options(lab_options INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Wconversion -Wno-sign-conversion
  # Same source, same bits: no fused multiply-add that the source does not ask for.
  -ffp-contract=off)
if(NOT POISSONLAB_UNITY)
  target_compile_options(lab_options INTERFACE -Wshadow)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # Names that a file has to itself hide nothing of the files that are compiled with it. Clang has no such warning.
  target_compile_options(lab_options INTERFACE -Wshadow=local)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of overlaps inside std::string that cannot be (GCC bugs 105329 and 105651).
  target_compile_options(lab_options INTERFACE -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13)
  # GCC 13 warns of dangling references wherever a function with a temporary argument returns a reference, also to
  # something else.
  target_compile_options(lab_options INTERFACE -Wno-dangling-reference)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC collects its garbage whenever that has grown to twice what is used, precompiled headers among it. Where memory
  # allows it, it begins at a gigabyte, which most source files never need: that saves up to a tenth of the time.
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY) # in MiB
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR memory_of_compiler "${memory} / (${processors} + 1)")
  if(memory_of_compiler GREATER 2500)
    target_compile_options(lab_options INTERFACE "SHELL:--param ggc-min-heapsize=1000000")
  endif()
endif()
if(POISSONLAB_PIC OR POISSONLAB_PYTHON)
  # The Python package is a shared library of all rooms. No function of these is replaced by another program's, so that
  # they may be inlined as in a program.
  target_compile_options(lab_options INTERFACE -fPIC -fno-semantic-interposition)
endif()
if(POISSONLAB_WERROR)
  target_compile_options(lab_options INTERFACE -Werror)
endif()
if(POISSONLAB_SANITIZE)
  target_compile_options(lab_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(lab_options INTERFACE -fsanitize=address,undefined)
endif()
if(POISSONLAB_SANITIZE_THREADS)
  # Fences (in CGAL) are not understood by it, which GCC warns of.
  target_compile_options(lab_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer -Wno-tsan)
  target_link_options(lab_options INTERFACE -fsanitize=thread)
endif()
if(POISSONLAB_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "POISSONLAB_FUZZ needs Clang, whose libFuzzer it is for: cmake --preset fuzz")
  endif()
  # Conversions of numbers that do not fit are not part of "undefined", but are what damaged files lead to.
  set(fuzz_checks address,undefined,float-cast-overflow)
  target_compile_options(lab_options INTERFACE
    -fsanitize=fuzzer-no-link,${fuzz_checks} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(lab_options INTERFACE -fsanitize=${fuzz_checks})
  target_compile_definitions(lab_options INTERFACE _GLIBCXX_ASSERTIONS)
endif()
target_include_directories(lab_options INTERFACE ${PROJECT_SOURCE_DIR})

# Most of the time to build a library goes into the headers of the standard library and of fmt: they are compiled once,
# here, for all that link fmt.
set(precompiled_headers
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <numeric> <optional> <set>
  <span> <sstream> <stdexcept> <string> <string_view> <tuple> <utility> <variant> <vector> <fmt/format.h>)
foreach(name lab_precompiled lab_precompiled_cold)
  add_library(${name} STATIC ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
  target_link_libraries(${name} PRIVATE lab_options fmt::fmt)
  target_precompile_headers(${name} PRIVATE ${precompiled_headers})
endforeach()
target_compile_options(lab_precompiled_cold PRIVATE $<$<CONFIG:Release>:-O1>)

# lab_precompile(TARGETS...): libraries that link fmt and whose own definitions are none.
function(lab_precompile)
  foreach(target IN LISTS ARGN)
    target_precompile_headers(${target} REUSE_FROM lab_precompiled)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # Like -Wrestrict above: with precompiled headers GCC 12 no longer sees that std::string is not ours.
      target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-array-bounds)
    endif()
  endforeach()
endfunction()

# lab_cold(TARGETS...): libraries of lab_room() that read, write, draw and ask other libraries, where optimising makes the
# build slower and nothing faster. Functions of a precompiled header keep the level that it was compiled with, so that
# these have one of their own: that takes a quarter off their time.
function(lab_cold)
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    set_target_properties(${target} PROPERTIES PRECOMPILE_HEADERS_REUSE_FROM lab_precompiled_cold)
  endforeach()
endfunction()
