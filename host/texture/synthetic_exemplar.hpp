// Exemplars that are made: pictures of known statistics, for tests and for what photographs do not show.
//
// noise: independent bytes, of which no seam can be told. pebbles: disks of random light around even points, stationary
// where these are. bricks: a wall with joints, which tiles of square patches are bad at (Ng and others 2005, section
// 5). ramp: light that grows from west to east. checkerboard: squares of 8 pixels, which fit at whole periods. fabric:
// a plain weave whose threads differ in light and width. clouds: noise of five octaves, in which nothing is small.
#pragma once

#include "base/images/png_file.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace poissonlab {

/// The names of patterns.
const std::vector<std::string>& exemplar_patterns();

/// Points on a torus, in parts of 2^32 of its side: x, y, x, y, ...
using PebblePlaces = std::span<const std::uint32_t>;

/// A grey picture of size x size pixels. `places` are those of pebbles, about pebble_count(size) of them; other
/// patterns need none.
PngPixels synthetic_exemplar(const std::string& pattern, int size, std::uint64_t seed, PebblePlaces places);

/// The number of pebbles of a picture: each covers about 12 x 12 pixels.
std::size_t pebble_count(int size);

}
