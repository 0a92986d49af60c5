// Pictures that texture tiles are made of.
#pragma once

#include "base/images/linear_picture.hpp"
#include "base/images/png_file.hpp"

#include <filesystem>
#include <string>

namespace poissonlab {

/// Reads a picture of any kind that OpenImageIO knows, upright, as 8-bit sRGB: one channel for grey ones, else three.
/// Cuts and differences are taken of these values, as in the papers. Alpha is left out, colours being those beneath it,
/// unless it covers. Floating-point numbers are taken for light: negative ones are 0, and where some are above 1 all
/// are tone-mapped, see tone_mapped(). Throws InputError for what is no picture, has numbers that are not finite, or
/// sides of more than most_exemplar_pixels, and if reading needs more memory than memory_limit(): a byte for each
/// number of 8 bits without alpha, 12 bytes for each of all others.
PngPixels read_exemplar(const std::filesystem::path& file, AlphaUse use = AlphaUse::left_out);

/// Reads an exemplar; `note` becomes what a person should know of light that 8 bits do not show, and of alpha that is
/// left out, or stays empty.
PngPixels read_exemplar(const std::filesystem::path& file, std::string& note, AlphaUse use = AlphaUse::left_out);

/// Light from 0 to 1 of light from 0 to `brightest`, channel by channel: Reinhard and others, Photographic Tone
/// Reproduction for Digital Images, 2002, equation 4. Where nothing is brighter than 1, light stays as it is.
double tone_mapped(double light, double brightest);

/// Two exemplars side by side, the second one for marked corners: it begins at the width of the first one. What is
/// higher than the other loses its lowest rows. Throws InputError where one is grey and the other has colours.
PngPixels side_by_side(const PngPixels& first, const PngPixels& second);

}
