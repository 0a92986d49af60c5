// The source of the library of the precompiled headers; see compiler_options.cmake.
