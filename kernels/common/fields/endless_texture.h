// The contract of endless_texture.cl and its host code, host/texture/endless/endless_texture.cpp.
#pragma once

#include "kernels/common/contract.h"

CONTRACT(endless_texture)

enum // methods in this order: from hexagons on, from tiles on
{
    METHOD_REPEATED = 0,    ///< the exemplar side by side
    METHOD_OFFSETS = 1,     ///< squares at random places of the exemplar, blended at their borders
    METHOD_HEXAGONS = 2,    ///< hexagons at random places, weighted by their contrast
    METHOD_BLENDED = 3,     ///< hexagons of a Gaussian exemplar, blended at equal variance and transformed back
    METHOD_TILES = 4,       ///< corner tiles of an atlas
    METHOD_WANG_TILES = 5,  ///< Wang tiles of an atlas
    GAUSSIAN_ZERO = 32768,  ///< the Gaussian exemplar: this number is its mean ...
    GAUSSIAN_STEPS = 4096,  ///< ... and so many are a standard deviation
    INVERSE_ENTRIES = 2048, ///< of the table back, over all 65,536 numbers
    TURNS = 256,            ///< angles that hexagons turn by
    TURN_UNIT = 32768       ///< of their cosines and sines
};

/// Pictures that are looked up, and what is done with them.
struct EndlessPlane
{
    uint seed;
    int width, height;        ///< of the exemplar or the atlas, in texels
    int cell, row;            ///< pixels between lattice points along a row, and between rows; of tiles, their side
    int reach_x, reach_y;     ///< so far from a lattice point its piece of the exemplar is seen
    int choices_x, choices_y; ///< places of such a piece
    int is_tileable;          ///< whether pieces may go over the exemplar's borders
    float inverse_unit;       ///< one over the sum of the three, or along an axis the two, whole weights
    float falloff;            ///< the part of a weight that is a pixel's lightness
    float means[3];           ///< of the exemplar's channels
    float axes[9];            ///< colours that the three coordinates of a Gaussian exemplar stand for
};

/// A rectangle of pixels, rows to the south, by the lattice point before it.
struct EndlessWindow
{
    uint cell_x, cell_y;  ///< modulo 2^32
    int start_x, start_y; ///< pixels from there to the first one; of tiles, to that in the last row
    int width, height;
};

END_CONTRACT
