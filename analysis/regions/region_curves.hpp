// The curves of points in a region, as means over sets: pair correlation, K, nearest distances of points and places, J;
// and the envelope of independent random points, which are measured in the same way.
//
// Envelopes go from the least to the largest of so many random sets of as many points, distance by distance: a set of
// independent points leaves that of 39 at a distance once in twenty times (Besag, Diggle, Simple Monte Carlo tests for
// spatial pattern, Applied Statistics 26(3), 1977).
#pragma once

#include "analysis/measures/pair_correlation.hpp"
#include "analysis/regions/random_in_region.hpp"
#include "analysis/regions/region_distances.hpp"
#include "analysis/regions/region_pairs.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace poissonlab {

/// The functions that have envelopes, in the order of tables.
enum class RegionFunction : std::size_t
{
    pair_correlation, ///< g, smooth
    k,                ///< by the translation correction
    nearest,          ///< G
    empty_space,      ///< F
    j
};
inline constexpr std::size_t region_functions = 5;

/// All curves at one distance.
struct RegionCurveRow
{
    double distance = 0; ///< in the region's own units
    double k_isotropic = 0;
    std::array<double, region_functions> value{};
    std::array<double, region_functions> low{}; ///< of the envelope; not numbers without one
    std::array<double, region_functions> high{};

    double of(RegionFunction f) const { return value[static_cast<std::size_t>(f)]; }
};

class RegionCurves
{
public:
    /// The first set has so many points, two or more: distances of curves, and random sets, are of that many. `density`
    /// may be null. `envelope`: random sets, 0 for none.
    RegionCurves(std::shared_ptr<const FramedRegion> region, std::shared_ptr<const RegionDensity> density,
                 std::size_t points, std::uint32_t envelope);

    /// Adds a set in the frame; `name` is for messages.
    void add(const PointSet& points, const std::string& name);

    /// Appends the sets of `other`, which was constructed alike.
    void append(const RegionCurves& other);

    /// K in squares of the region's units; all else without units. Makes and measures the random sets.
    std::vector<RegionCurveRow> rows() const;

    /// The pair correlation of bins, as on the torus: distances in roots of the region's area.
    /// Errors are between the `groups` of sets, see errors_of_mean().
    std::vector<PairCorrelationBin> pair_correlation(const std::vector<std::size_t>& groups = {}) const;

    const SetCovariance& covariance() const { return covariance_; }
    const PairDistances& distances() const { return distances_; }

    /// Cereal stores the curves of each set.
    template <class Archive>
    void serialize(Archive& archive)
    {
        archive(pairs_, g_of_bin_, k_isotropic_, values_);
    }

private:
    using Values = std::array<std::vector<double>, region_functions>;

    Values measure(const PointSet& points, const std::string& name, PairCurves& pairs, bool is_isotropic) const;

    std::shared_ptr<const FramedRegion> region_;
    std::shared_ptr<const RegionDensity> density_;
    std::size_t points_;
    std::uint32_t envelope_;
    SetCovariance covariance_;
    PairDistances distances_;
    std::shared_ptr<const RegionPlaces> places_;
    // Each set has a curve in each of these.
    std::vector<std::vector<double>> pairs_, g_of_bin_, k_isotropic_;
    std::vector<Values> values_;
};

}
