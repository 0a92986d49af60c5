// Points whose radially averaged power follows a curve: gradient descent of the squared difference.
//
// After Heck, Schloemer, Deussen, Blue noise sampling with controlled aliasing, ACM Transactions on Graphics 32(3),
// 2013, who ask for a step and for a step with a peak; they descend the difference of pair correlations, this the
// difference of the power itself, by the nonuniform transform and its adjoint. Steps are those of Barzilai and Borwein
// (IMA Journal of Numerical Analysis 8, 1988), halved while the difference would grow.
//
// It runs on the host, whatever the engine: FFTW's last bits depend on the processor, and so do the sets.
#pragma once

#include "base/geometry/point_set.hpp"
#include "host/sampling/lloyd_relaxation.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace poissonlab {

/// A radially averaged power over frequencies in units of sqrt(N): straight lines between values, the first one's
/// before it, and 1 beyond the last.
class TargetCurve
{
public:
    /// Frequencies ascend.
    TargetCurve(std::vector<double> frequencies, std::vector<double> power);

    double at(double frequency) const;

private:
    std::vector<double> frequencies_, power_;
};

/// 0 below a frequency and 1 beyond, where a peak may begin that is `peak` higher and falls off as a Gaussian of a
/// standard deviation of 0.05.
TargetCurve step_curve(double frequency, double peak);

/// The difference of a set from a curve: the mean over the rings of whole frequencies up to twice sqrt(N) of the
/// squared difference of their mean power. Were it a mean over frequencies, the lowest would hardly count.
class SpectrumDifference
{
public:
    SpectrumDifference(std::size_t points, const TargetCurve& target);
    ~SpectrumDifference();

    double of(const PointSet& points);

    /// The derivatives of the difference by coordinates, for the set that of() was last asked about.
    std::vector<double> gradient(const PointSet& points);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The set after so many steps; fewer where none makes the difference smaller. Energies of records are differences.
LloydResult follow_curve(const PointSet& points, const TargetCurve& target, std::size_t iterations);

/// The sampler "target-spectrum": target, frequency, peak, curve, curve_points, iterations, start.
SamplerSpec target_spectrum_sampler();

}
