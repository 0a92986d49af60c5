// The peaks that a tiling leaves in the power spectrum: tiles of side 1/M repeat their points, which puts
// power at frequencies that are multiples of M along every axis.
//
// Lagae and Dutre, A comparison of methods for generating Poisson disk distributions, Computer Graphics Forum
// 27(1), 2008, see them in the periodograms of Wang and corner tiles; here they are a number. For every
// multiple f = M (a, b[, c]) but 0:
//
//   ratio(f) = P(f) / mean of P over the ring around f,
//   ring: the samples other than f no more than w = min(3, M - 1) away along each axis
//
// As w < M, a ring holds no other multiple, and not f = 0. Multiples whose ring reaches beyond the spectrum
// are left out. f and -f have the same power and both count. Without peaks, ratios of K periodograms are K
// exponential variables averaged: their mean is 1 (1 + 1/(24 K) in 2D, for the noise of the ring) and the
// largest of n (n/2 of them independent) about ln(n / 2) where K = 1.
#pragma once

#include "analysis/spectra/half_spectrum.hpp"
#include "analysis/spectra/spectrum.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace poissonlab {

struct LatticePeaks
{
    int tiles = 0;                  ///< M
    double max_ratio = 0;           ///< over all peaks; 0 without any
    double mean_ratio = 0;          ///< mean of the ratios; 0 without any
    std::array<int, 3> frequency{}; ///< where the ratio is largest, the first in storage order; 2D: z is 0
    std::size_t peaks = 0;          ///< multiples that took part
    std::optional<double> mean_ratio_standard_error = {}; ///< for whoever has several realizations to set
    std::size_t empty_rings = 0; ///< peaks that have nothing around them but rounding: ratios without meaning

    bool operator==(const LatticePeaks&) const = default;
};

/// `tiles` is M, tiles per unit length, at least 2: with one tile every frequency is a multiple. Throws
/// InputError otherwise. A ring without power counts as one with (1e-11)^2 N, where the rounding of
/// exact_periodogram ends; below 1e-12 N it is an empty one. Spectra too small for any ring have no peaks.
LatticePeaks lattice_peaks(const Spectrum& spectrum, int tiles);

/// The peaks where a good distribution has no power, or its first ring: up to 1.05 times the principal frequency of the
/// densest packing, 1.075 sqrt N (3D: 1.091 cbrt N).
struct NearLatticePeaks
{
    double mean_ratio = 0;   ///< as in LatticePeaks
    double excess_share = 0; ///< what these peaks have above the power around them, of all power up to there

    bool operator==(const NearLatticePeaks&) const = default;
};

/// The result is empty where no multiple of `tiles` is as low.
std::optional<NearLatticePeaks> near_lattice_peaks(const Spectrum& spectrum, int tiles);

/// Returns what the error of LatticePeaks::mean_ratio follows from, of the periodogram of one set: the peaks in shells
/// half a multiple of `tiles` thick, three numbers each: how many they are, the sum of their powers, and of the mean
/// powers around them. Linear in periodograms, as near_lattice_powers() are: a ratio of one periodogram, whose ring may
/// have next to no power, spreads far more than that of a mean. Throws InputError for fewer `tiles` than 2.
std::vector<double> lattice_shell_powers(const HalfSpectrum& periodogram, std::size_t points, int tiles);

/// The mean ratio of such a list, or of an average of lists, where peaks of a shell count by their powers: it differs
/// as mean_ratio does from set to set. 0 without peaks.
double mean_ratio_of_shells(const std::vector<double>& shells, std::size_t points);

/// Returns the powers that the near lattice peaks of one set follow from: all power up to where NearLatticePeaks end,
/// then for each peak its own and the mean power of its ring. Errors follow from how sets differ. The list is linear in
/// periodograms, so that the measures of an average of spectra follow from that of such lists. Sets of a series have
/// lists of one length for one number of `points`. Throws InputError for fewer `tiles` than 2.
std::vector<double> near_lattice_powers(const HalfSpectrum& periodogram, std::size_t points, int tiles);

/// The measures of such a list, or of an average of lists; nothing where there are no peaks.
std::optional<NearLatticePeaks> near_lattice_peaks(const std::vector<double>& powers, std::size_t points);

}
