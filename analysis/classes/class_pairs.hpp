// Statistics of points of two classes: the cross pair correlation function, cross nearest-neighbour distances, and the
// mark correlation function.
//
//   g_ab(r) = A^2 / (n_a n_b) sum over i in a, j in b of k(r - d_ij) w_ij / (2 pi d_ij)
//
// where k is Epanechnikov's kernel, as for one class (region_curves.hpp), and w_ij is one over the set covariance at
// x_i - x_j in a region (the translation correction, Ohser 1983; in spatstat, pcfcross(correction = "translate",
// divisor = "d")) and 1 / A on a torus. It is 1 on average where classes are independent of each other and one of them
// is uniform. For one class the sum has i != j, and n_a (n_a - 1) in place of n_a n_b.
//
// The mark correlation function of classes, also called mark equality function, is the probability that two points at
// distance r are of one class, over that of any two points of the set (Illian et al., Statistical Analysis and
// Modelling of Spatial Point Patterns, 2008, section 5.3.3; in spatstat, markcorr with f(m, n) = 1 where m = n). It is
// 1 on average if classes were given to points at random.
#pragma once

#include "analysis/regions/framed_region.hpp"
#include "analysis/regions/set_covariance.hpp"
#include "base/geometry/periodic_box.hpp"
#include "base/geometry/point_set.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace poissonlab {

/// The place of points with classes: a region in its frame, or a torus whose unit of length is the root of its area.
class ClassPlace
{
public:
    explicit ClassPlace(std::shared_ptr<const FramedRegion> region)
        : region_(std::move(region)), covariance_(std::make_shared<SetCovariance>(region_->boundary().edges()))
    {}
    explicit ClassPlace(const PeriodicBox& box) : box_(box) {}

    double area() const { return region_ ? region_->area() : 1; }
    double unit_length() const { return region_ ? region_->unit_length() : 1; } ///< the root of the area

    /// The longest distance of pairs, up to `most`: half of the torus' shortest side, or as regions have it, which are
    /// in the unit square.
    double reach(double most) const;

    /// Prepares for this number of pairs up to a distance.
    void expect(double pairs, double reach)
    {
        if (covariance_) covariance_->expect(pairs, reach);
    }

    /// The area that is left of the place if it is moved by (x, y) and cut with itself.
    double common_area(double x, double y) const { return region_ ? covariance_->at(x, y) : 1; }
    double least_common_area() const { return region_ ? covariance_->least_common_area() : 0; } ///< of pairs that count
    double covariance_error() const { return covariance_ ? covariance_->table_error() : 0; }

    const FramedRegion* region() const { return region_.get(); }
    const PeriodicBox& box() const { return box_; }

private:
    std::shared_ptr<const FramedRegion> region_;
    std::shared_ptr<SetCovariance> covariance_;
    PeriodicBox box_;
};

/// Curves are measured at step, 2 step, ..., count step.
struct ClassDistanceSteps
{
    double step = 0;
    std::size_t count = 0;
    double half_width = 0; ///< half the width of the kernel

    double reach() const { return step * static_cast<double>(count); }
};

/// The steps that suit this number of points: 50 to the distance of the densest packing, up to four of these distances,
/// or up to `reach` if it is not 0; the kernel has Stoyan's half width of 0.15 mean spacings.
ClassDistanceSteps class_distance_steps(const ClassPlace& place, std::size_t points, double reach = 0);

/// The pair correlation function of two classes, or of one if both are the same object. Points that coincide are left
/// out, as their direction is unknown. Any number of threads gives the same bytes. Classes without pairs have NaN.
/// `summed`, unless null, is set to the number of pairs within reach, each counted once. Time is in proportion to it,
/// which is quadratic in the points where these lie in clusters. Throws Interrupted, as all functions here do.
std::vector<double> class_pair_correlation(const PointSet& a, const PointSet& b, const ClassPlace& place,
                                           const ClassDistanceSteps& steps, double* summed = nullptr);

/// The distances of the points of `a` from their nearest ones in `b`, other than themselves if both are the same
/// object.
struct CrossNearest
{
    double least = 0; ///< infinite where there are none
    double mean = 0;
};
CrossNearest cross_nearest(const PointSet& a, const PointSet& b, const ClassPlace& place);

struct MarkCorrelation
{
    std::vector<double> values;    ///< NaN where there are no pairs, or no two points have one class
    std::vector<double> low, high; ///< the least and largest of the random labellings; empty without any
    double p_value = 1; ///< the share of sets, these and the measured one, that are as far from 1, by squares of
                        ///< differences weighted by pairs (the test of Diggle, Cressie, Loosmore and Ford)
};

/// The mark correlation function of points with `classes` below 255, and of `labellings` permutations of these.
MarkCorrelation mark_correlation(const PointSet& points, std::span<const std::uint8_t> classes, const ClassPlace& place,
                                 const ClassDistanceSteps& steps, std::uint32_t labellings);

}
