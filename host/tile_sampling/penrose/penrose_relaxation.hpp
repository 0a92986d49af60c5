// A table of vectors for Penrose points, made from nothing: relaxation in which all points of an index move alike.
//
// Ostromoukhov, Donohue and Jodoin 2004 relax by Lloyd's method and tabulate the mean displacements of points with the
// same last digits. Here three importances of each row share its vectors, so that all of a row are good, and points
// that are too near push each other apart after that: by Lloyd's method alone the worst importance has a relative
// radius of 0.43. No number is taken from the authors' program.
#pragma once

#include "host/tile_sampling/penrose/penrose_table.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace poissonlab {

struct PenroseRelaxation
{
    std::uint32_t lloyd_rounds = 20;
    std::uint32_t push_rounds = 60;
    double pushed_radius = 0.72; ///< points nearer than that, as a relative radius, push each other
    // Levels of the patches: there are pairs that meet once among thousands of points, which pushes must know.
    std::uint32_t lloyd_level = 10; ///< some 700 to 1,800 points
    std::uint32_t push_level = 11;  ///< some 1,800 to 4,700

    bool operator==(const PenroseRelaxation&) const = default;
};

/// On all threads; the result is the same for any number of them. `on_step` is told of each row; what it throws ends
/// that.
PenroseTable relaxed_penrose_table(const PenroseRelaxation& relaxation = {},
                                   const std::function<void(const std::string& what)>& on_step = {});

}
