// The compact kernel that spreads points onto a grid for the fast periodogram.
//
// "Exponential of semicircle": Barnett, Magland, af Klinteberg: A Parallel Nonuniform Fast Fourier Transform
// Library Based on an "Exponential of Semicircle" Kernel, SIAM Journal on Scientific Computing 41(5), 2019,
// equation 1.8:
//   phi(t) = exp(beta (sqrt(1 - t^2) - 1)) for |t| <= 1, 0 elsewhere
// Here it is stretched over `width` grid spacings.
#pragma once

#include <vector>

namespace poissonlab {

class SpreadingKernel
{
public:
    static constexpr int min_width = 4;
    static constexpr int max_width = 16;

    /// `width`: grid points under the kernel, even, min_width to max_width. `oversampling`: grid points per
    /// frequency sample, above 1. beta = 0.976 pi (1 - 1 / (2 oversampling)) width, ibidem section 4.2.
    SpreadingKernel(int width, double oversampling);

    int width() const { return width_; }

    /// The kernel's values at the `width` grid points under it, the first of which is `offset` in [0, 1) grid spacings
    /// behind its left end. Values are those of polynomials, within 1e-10 of the kernel, whose largest value is 1.
    void values(double offset, double* result) const;

    /// The derivatives of these polynomials by the offset. At its ends the kernel itself is steeper than any.
    void slopes(double offset, double* result) const;

    /// The kernel's Fourier transform at a frequency in cycles per grid spacing.
    double transform(double frequency) const;

private:
    template <int width>
    static void evaluate(const double* coefficients, double x, double* result);
    void evaluate_all(const std::vector<double>& coefficients, double x, double* result) const;
    void make_polynomials();
    void make_nodes();
    double at(double t) const;

    int width_;
    double beta_;
    /// Powers of 2 offset - 1, for the grid points of the kernel's left half: [power][grid point]. The right
    /// half's are the same in reverse order but for the signs of odd powers.
    std::vector<double> coefficients_;
    std::vector<double> slopes_; ///< of their derivatives by offset, in the same order

    /// cos(2 pi frequency place) weight, summed up, is the transform.
    struct Node
    {
        double place, weight;
    };
    std::vector<Node> nodes_;
};

}
