// What the library of the precompiled headers is built from; see compiler_options.cmake.
