// Endless textures that are no tiles, as users ask for them: functions of the plane that look up one picture.
//
// Quilez, Texture repetition, 2015 (iquilezles.org/articles/texturerepetition), technique 1; Mikkelsen, Practical
// Real-Time Hex-Tiling, JCGT 11(3), 2022; Heitz and Neyret, High-Performance By-Example Noise using a
// Histogram-Preserving Blending Operator, HPG 2018; Deliot and Heitz, Procedural Stochastic Textures by Tiling and
// Blending, GPU Zen 2, 2019; Burley, On Histogram-Preserving Blending for Randomized Texture Tiling, JCGT 8(4), 2019;
// Efros and Freeman, Image Quilting for Texture Synthesis and Transfer, SIGGRAPH 2001.
#pragma once

#include "base/images/png_file.hpp"
#include "base/word_table.hpp"

#include <cstdint>
#include <optional>

namespace poissonlab {

enum class EndlessMethod
{
    repeated, ///< the exemplar side by side
    offsets,  ///< squares at random places of the exemplar, blended at their borders (Quilez)
    hexagons, ///< hexagons at random places, their weights raised to a power (Mikkelsen)
    blended,  ///< by-example noise: hexagons of a Gaussian exemplar, transformed back (Heitz and Neyret)
    quilted,  ///< blocks that fit, one after the other: no function of the plane, but a picture (Efros and Freeman)
};
inline constexpr WordTable<EndlessMethod, 5> endless_methods{{{{EndlessMethod::repeated, "repeated"},
                                                               {EndlessMethod::offsets, "offsets"},
                                                               {EndlessMethod::hexagons, "hexagons"},
                                                               {EndlessMethod::blended, "blended"},
                                                               {EndlessMethod::quilted, "quilted"}}}};

// Largest and smallest values of a request.
inline constexpr int least_endless_cell = 8, most_endless_cell = 2048;
inline constexpr int most_endless_exponent = 16, most_endless_gain = 8;
inline constexpr int least_quilting_block = 12, most_quilting_block = 512;

struct EndlessRequest
{
    EndlessMethod method = EndlessMethod::hexagons;
    /// Pixels between lattice points along a row. Unless given what Heitz and Neyret have and Mikkelsen after them, one
    /// over 2 sqrt 3 of the exemplar; of offsets a third.
    std::optional<int> cell;
    /// The power of weights. Unless given 7 of hexagons (Mikkelsen), 1 of blended ones (Burley has larger ones too).
    std::optional<int> exponent;
    double falloff = 0.6;  ///< hexagons: the part of a weight that is the lightness of its pixel (Mikkelsen)
    int gain = 1;          ///< hexagons: weights w below a half become (2 w)^gain / 2, others alike; 1 does nothing
    double turn = 0;       ///< hexagons: how far they turn, in half turns to either side (Mikkelsen leaves it to users)
    bool restored = false; ///< offsets, hexagons: the variance that blending takes is given back
    bool tileable = false; ///< whether the exemplar fits to itself: pieces may go over its borders
    int block = 64;        ///< quilted: the side of a block, a sixth of which overlaps (Efros and Freeman)
    double tolerance = 0.1;
    std::uint64_t seed = 1;

    bool has_hexagons() const { return method == EndlessMethod::hexagons || method == EndlessMethod::blended; }
    int exponent_or_default() const { return exponent.value_or(method == EndlessMethod::hexagons ? 7 : 1); }
    /// Even, so that every other row of lattice points lies at half a cell. Of an exemplar its width and height count.
    int cell_of(const PngPixels& exemplar) const;
    /// Pixels between rows of lattice points: what makes triangles of them equilateral, rounded.
    int row_of(const PngPixels& exemplar) const;
};

/// Checks what depends on the exemplar's width and height. Throws InputError that begins with the parameter's name.
void check(const EndlessRequest& request, const PngPixels& exemplar);

/// Returns how many texels a pixel takes, those of a table among them; nothing of quilted pictures, which are there.
std::optional<int> fetches_of(const EndlessRequest& request, int channels);

}
