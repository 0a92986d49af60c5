// Tapers of a region, and the spectrum of points in it by several of them.
//
// A taper is a function h on the region with an integral of squares of 1, which weighs points:
//
//   P(f) = |sum over points of h(x) exp(-2 pi i f.x) - N H(f)|^2 / N
//
// with its transform H in the place of the region's (see region_transform.hpp). Where h falls to 0 at the boundary, H
// has no slow tails, and spectra are not blurred by peaks that are far away. Orthogonal tapers make powers that are
// nearly independent at one frequency: there the mean has the spread of that of as many sets (Thomson, Spectrum
// estimation and harmonic analysis, Proceedings of the IEEE 70(9), 1982; of point patterns: Rajala, Olhede, Grainger,
// Murrell, What is the Fourier transform of a spatial point process?, IEEE Transactions on Information Theory 69(8),
// 2023). The powers of two frequencies that are near each other have more to do with each other than without tapers,
// see taper_covariance.hpp.
//
// The tapers here are those whose H is narrowest in its second moment, the integral of |f|^2 |H|^2, which is that of
// the squared gradient over 4 pi^2: the functions of the region's lowest vibrations, as a drum. In a rectangle these
// are products of sines, the sine tapers (Riedel, Sidorenko, Minimum bias multiple taper spectral estimation, IEEE
// Transactions on Signal Processing 43(1), 1995).
//
// They are found among functions that are bilinear in the cells of a grid over the region's box, 0 at and beyond cells
// that the boundary crosses: orthogonal as such, within rounding, and with transforms in closed form. Cells are a 128th
// of the box wide where that gives enough nodes, and otherwise a part of the region's width. Where two tapers have the
// same frequency, as in a square, rounding decides which pair of functions is found: single tapers can differ between
// machines, the sum of their spectra cannot.
//
// The nodes of tapers: a grid over a region's box, of which only the nodes inside the region are stored.
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "analysis/spectra/half_spectrum.hpp"
#include "analysis/spectra/nonuniform_transform.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace poissonlab {

/// A node that is not there.
inline constexpr std::size_t no_node = static_cast<std::size_t>(-1);

class TaperGrid
{
public:
    /// Divides the box into so many columns and rows. A node is stored if no edge crosses the cells around it and all
    /// of them are inside. The cost grows with the rows, the cells that the boundary crosses, and the nodes.
    TaperGrid(const FramedRegion& region, const std::array<std::size_t, 2>& cells);

    const std::array<std::size_t, 2>& cells() const { return cells_; }

    /// The sides of a cell, in the frame.
    const std::array<double, 2>& step() const { return step_; }

    /// Nodes are numbered row by row.
    std::size_t size() const { return columns_.size(); }
    std::size_t rows() const { return cells_[1] + 1; } ///< the first and the last one have no nodes
    std::size_t row_begin(std::size_t row) const { return row_begins_[row]; }
    std::uint32_t column(std::size_t node) const { return columns_[node]; }

    /// The number of the node at a crossing of lines, or no_node.
    std::size_t number(std::size_t column, std::size_t row) const;

private:
    std::array<std::size_t, 2> cells_{};
    std::array<double, 2> step_{};
    std::vector<std::uint32_t> columns_;
    std::vector<std::size_t> row_begins_;
};

/// Tapers that can be had of one region.
inline constexpr std::size_t most_tapers = 64;

class RegionTapers
{
public:
    /// Throws InputError where the region is too thin for so many on the grid.
    RegionTapers(const FramedRegion& region, std::size_t count);

    std::size_t count() const { return values_.size(); }

    /// The taper at a place of the frame; lengths are roots of the region's area.
    double at(std::size_t taper, const std::array<double, 2>& place) const;

    /// The root of the region's area, in lengths of the frame.
    double unit_length() const { return grid_.step()[0] / step_[0]; }

    /// The frequency of the vibration of unit waves, squared, times 4 pi^2: the integral of the squared gradient.
    double eigenvalue(std::size_t taper) const { return eigenvalues_[taper]; }

    // The taper as values at nodes, of which it is the sum of pyramids whose bases are two steps wide.
    PointSet nodes() const; ///< in the frame
    const std::vector<double>& values(std::size_t taper) const { return values_[taper]; }
    const std::array<double, 2>& step() const { return step_; } ///< in roots of the region's area

private:
    TaperGrid grid_;
    std::array<double, 2> step_{};
    std::vector<std::vector<double>> values_;
    std::vector<double> eigenvalues_;
};

class TaperedPeriodogram
{
public:
    /// Takes `size` and `is_exact` as RegionPeriodogram does.
    TaperedPeriodogram(std::shared_ptr<const FramedRegion> region, std::shared_ptr<const RegionTapers> tapers, int size,
                       bool is_exact);
    ~TaperedPeriodogram();

    /// Computes the periodogram of points in the frame by one of the tapers.
    void compute(const PointSet& points, std::size_t taper, HalfSpectrum& result);

private:
    HalfPlane weighted_sums(const PointSet& points, const std::vector<double>& weights);
    const HalfPlane& node_sums(std::size_t taper);

    std::shared_ptr<const FramedRegion> region_;
    std::shared_ptr<const RegionTapers> tapers_;
    int size_;
    std::unique_ptr<NonuniformTransform> fast_; ///< none: exact
    PointSet nodes_;
    std::vector<std::optional<HalfPlane>> kept_; ///< sums over nodes: of each taper, or of the last one
};

// The lowest vibrations of a drum on nodes of a grid: the eigenvectors of its stiffness and its mass.

struct DrumModes
{
    std::vector<std::vector<double>> values; ///< of each mode at each node; the integrals of its square are 1
    std::vector<double> eigenvalues;         ///< of these values
};

/// Bilinear elements on the nodes of a grid, whose steps are given; there are `count` + 8 nodes or more. Modes have
/// errors of some 1e-9; where many have nearly one eigenvalue, they can be combinations of these. Throws InputError
/// where none are found.
DrumModes drum_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count);

/// Modes that extend along the whole of a long region of some `length`. The drum's own modes would be confined to where
/// it is a little wider, or bends. These are products u g: u is the drum's solution under a load of 1 everywhere, and
/// the functions g have the least integrals of u^2 |grad g|^2, the first being 1 in each part of the region. They are
/// the drum's modes without the potential 1 / u, which traps them (Filoche, Mayboroda, Universal mechanism for Anderson
/// and weak localization, PNAS 109(37), 2012). Eigenvalues are the integrals of the squared gradients of u g. Cells
/// must be nearly square.
DrumModes released_modes(const TaperGrid& grid, std::array<double, 2> step, std::size_t count, double length);

}
