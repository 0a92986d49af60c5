// The words in which headers that a kernel and its host code share are written: constants, counters and record layouts
// in C that is OpenCL C 1.2 as well as C++20.
//
//     CONTRACT(dart_throwing)                                   C++: namespace poissonlab::contract::dart_throwing
//     DERIVED(DART_WORDS, (size_t DIMENSION), DIMENSION + 2)    C: a constant, as DIMENSION is; C++: a function
//     REAL(BOUNDARY_DEPTH, 0x1p-46)                             a double
//     END_CONTRACT
//
// Records fill their last eight bytes, by `uint unused` where they must: Mesa (22.3) takes arguments for smaller where
// they end in padding, and refuses them.
#pragma once

#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
namespace poissonlab::contract {
using uint = std::uint32_t;
using ulong = std::uint64_t;
}
// clang-format off
#define CONTRACT(name) namespace poissonlab::contract::name {
#define END_CONTRACT }
#define DERIVED(name, parameters, value) constexpr std::size_t name parameters { return value; }
#define REAL(name, value) inline constexpr double name = value;
#else
#define CONTRACT(name)
#define END_CONTRACT
#define DERIVED(name, parameters, value) enum { name = value };
#define REAL(name, value) constant double name = value;
// clang-format on
#endif
