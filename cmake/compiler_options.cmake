# Options that every target of the laboratory shares, as the interface library lab_options.
add_library(lab_options INTERFACE)
target_compile_options(lab_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wconversion -Wno-sign-conversion
  # Same source, same bits: no fused multiply-add that the source does not ask for.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 warns of overlaps inside std::string that cannot be (GCC bugs 105329 and 105651).
  target_compile_options(lab_options INTERFACE -Wno-restrict)
endif()
if(POISSONLAB_WERROR)
  target_compile_options(lab_options INTERFACE -Werror)
endif()
if(POISSONLAB_SANITIZE)
  target_compile_options(lab_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(lab_options INTERFACE -fsanitize=address,undefined)
endif()
target_include_directories(lab_options INTERFACE ${PROJECT_SOURCE_DIR}/host ${PROJECT_SOURCE_DIR})
