// The sampler "penrose": points of a Penrose tiling that is divided as a density asks for.
//
// Ostromoukhov, Donohue and Jodoin, Fast hierarchical importance sampling with blue noise properties, SIGGRAPH 2004;
// Lagae, Tile-Based Methods in Computer Graphics, 2007, section 6.8. A set is a window of the plane, not a torus. Every
// realization is the same.
#pragma once

#include "host/sampling/sampler.hpp"
#include "host/tile_sampling/built_once.hpp"
#include "host/tile_sampling/penrose/penrose_points.hpp"
#include "host/tile_sampling/penrose/penrose_table.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace poissonlab {

// The table of Penrose points that was built before: building takes seconds, reading a file does not.

/// The name of the table's file: there is one for each version of the code.
std::string penrose_table_name();

/// The table from `folder`, or built and put there: see built_once(). An empty folder: always built. `on_step` is told
/// of waiting and of the steps of building; what it throws ends that.
BuiltOnce<PenroseTable> cached_penrose_table(const std::filesystem::path& folder,
                                             const std::function<void(const std::string& what)>& on_step = {});

// The importance that gives a number of points.

/// The importance whose set has as nearly as possible `points` points in the unit square. With the same density
/// everywhere, that is exact but for numbers between two rows of the table, where a few points come in or go out as all
/// of them move. With another density, it is the best of some tries. Throws InputError where tiles would have to be
/// finer than the finest.
std::uint64_t importance_for_points(const PenroseTiling& tiling, std::size_t points);

SamplerSpec penrose_sampler();

}
