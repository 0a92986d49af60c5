#include "analysis/regions/taper_covariance.hpp"

#include "analysis/regions/region_transform.hpp"
#include "analysis/spectra/radial_bin.hpp"
#include "base/programs/interrupt.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

using Wave = std::complex<double>;

/// Differences of frequencies are summed up to so many root mean square frequencies of the highest taper, because a
/// product of two tapers has frequencies of both. Up to `summed_reach`, which all compact regions keep, sums are
/// direct; their time grows with its square, so larger reaches use fast transforms. `most_reach` limits these.
constexpr double root_mean_squares = 4;
constexpr int least_reach = 4, summed_reach = 32, most_reach = 512;

/// In long regions a few differences of frequencies have nearly all of the sum: those of a strip lie on a line. The
/// smallest terms are dropped, and this part of the sum is kept.
constexpr double kept_part = 0.999;

/// Rings are summed up to this many frequencies, or up to three times the reach but at most `most_radius`.
constexpr int summed_radius = 64, most_radius = 256;

/// The transforms of products of tapers, sums over the nodes, which lie in rows.
class ProductTransforms
{
public:
    ProductTransforms(const RegionTapers& tapers, double unit, int reach)
        : tapers_(tapers), reach_(reach), nodes_(tapers.nodes())
    {
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            for (int u = 0; u <= reach_; ++u) along_.push_back(std::polar(1.0, turn * u * nodes_[i][0] / unit));
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (i > 0 && nodes_[i][1] == nodes_[i - 1][1]) continue;
            rows_.push_back(i);
            for (int v = -reach_; v <= reach_; ++v) across_.push_back(std::polar(1.0, turn * v * nodes_[i][1] / unit));
        }
        rows_.push_back(nodes_.size());
    }

    /// Adds weight |H_kl|^2 at u = 0 .. reach, v = -reach .. reach, v fastest.
    void add_squares(std::size_t k, std::size_t l, double weight, std::vector<double>& squares) const
    {
        const auto columns = static_cast<std::size_t>(reach_) + 1, heights = 2 * columns - 1;
        std::vector<Wave> sums(columns * heights), row(columns);
        for (std::size_t r = 0; r + 1 < rows_.size(); ++r) {
            std::ranges::fill(row, 0);
            for (std::size_t i = rows_[r]; i < rows_[r + 1]; ++i) {
                const double product = tapers_.values(k)[i] * tapers_.values(l)[i];
                for (std::size_t u = 0; u < columns; ++u) row[u] += product * along_[i * columns + u];
            }
            for (std::size_t u = 0; u < columns; ++u)
                for (std::size_t v = 0; v < heights; ++v) sums[u * heights + v] += row[u] * across_[r * heights + v];
        }
        for (std::size_t at = 0; at < sums.size(); ++at) squares[at] += weight * std::norm(sums[at]);
    }

private:
    static constexpr double turn = -2 * std::numbers::pi;

    const RegionTapers& tapers_;
    int reach_;
    PointSet nodes_;
    std::vector<std::size_t> rows_; ///< the first node of each row, and the number of nodes
    std::vector<Wave> along_, across_;
};

int reach_of(const RegionTapers& tapers)
{
    double largest = 0;
    for (std::size_t k = 0; k < tapers.count(); ++k) largest = std::max(largest, tapers.eigenvalue(k));
    const double root_mean_square = std::sqrt(largest) / (2 * std::numbers::pi);
    return std::clamp(static_cast<int>(std::ceil(root_mean_squares * root_mean_square)), least_reach, most_reach);
}

/// The sums over all pairs of tapers of |H_kl|^2 at u = 0 .. reach, v = -reach .. reach, v fastest.
std::vector<double> summed_squares(const RegionTapers& tapers, int reach)
{
    const std::size_t count = tapers.count();
    const ProductTransforms transforms(tapers, tapers.unit_length(), reach);
    const auto columns = static_cast<std::size_t>(reach) + 1, heights = 2 * columns - 1;
    std::vector<std::vector<double>> parts(count, std::vector<double>(columns * heights));
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t k) {
        for (std::size_t l = 0; l <= k; ++l) transforms.add_squares(k, l, l < k ? 2 : 1, parts[k]);
    });
    for (std::size_t k = 1; k < count; ++k)
        for (std::size_t at = 0; at < parts[0].size(); ++at) parts[0][at] += parts[k][at];
    return parts[0];
}

/// summed_squares() by fast transforms, without what is not needed for `kept_part` of their sum.
std::vector<double> fast_squares(const RegionTapers& tapers, int reach)
{
    NonuniformTransform transform(reach);
    const PointSet nodes = tapers.nodes();
    const auto columns = static_cast<std::size_t>(reach) + 1, heights = 2 * columns - 1;
    std::vector<double> squares(columns * heights), products(nodes.size());
    for (std::size_t k = 0; k < tapers.count(); ++k)
        for (std::size_t l = 0; l <= k; ++l) {
            stop_if_interrupted();
            for (std::size_t i = 0; i < products.size(); ++i) products[i] = tapers.values(k)[i] * tapers.values(l)[i];
            const HalfPlane sums = region_sums(nodes, products, tapers.unit_length(), reach, &transform);
            for (std::size_t at = 0; at < squares.size(); ++at)
                squares[at] += (l < k ? 2 : 1) * std::norm(sums.at(static_cast<int>(at / heights),
                                                                   static_cast<int>(at % heights) - reach));
        }
    std::vector<double> rising = squares;
    std::ranges::sort(rising);
    double left = (1 - kept_part) * std::accumulate(rising.begin(), rising.end(), 0.0), least = 0;
    for (std::size_t i = 0; i < rising.size() && left > rising[i]; ++i) left -= least = rising[i];
    for (double& square : squares)
        if (square <= least) square = 0;
    return squares;
}

struct Difference
{
    int u, v;
    double square;
};

/// The ring of each frequency (u, v) with |u|, |v| <= radius, the number of rings for those that have none.
class RingTable
{
public:
    RingTable(const RadialBins& bins, int radius) : radius_(radius), side_(2 * radius + 1)
    {
        rings_.resize(static_cast<std::size_t>(side_) * side_);
        for (int v = -radius; v <= radius; ++v) {
            RadialBins::Walk ring(bins, 0, bins.squared(1, v));
            for (int u = 0; u <= radius; ++u) {
                const std::size_t k = ring.of(u);
                at(u, v) = at(-u, v) = k == 0 ? bins.count() - 1 : k - 1; // bin 0 is no ring
            }
        }
    }

    std::size_t& at(int u, int v) { return rings_[static_cast<std::size_t>((v + radius_) * side_ + u + radius_)]; }

private:
    int radius_, side_;
    std::vector<std::size_t> rings_;
};

}

double RingCovariance::of(std::size_t first, std::size_t second) const
{
    const auto [low, high] = std::minmax(first, second);
    return high - low < bands_[low].size() ? bands_[low][high - low] : 0;
}

std::vector<double> RingCovariance::errors(const std::vector<double>& power) const
{
    std::vector<double> errors;
    for (std::size_t b = 0; b < power.size(); ++b) errors.push_back(power[b] * std::sqrt(bands_[b][0]));
    return errors;
}

double RingCovariance::error_of(const std::vector<double>& power,
                                const std::function<double(const std::vector<double>& power)>& statistic) const
{
    std::vector<double> moved = power, slope(power.size()); // slopes are over relative changes of power
    for (std::size_t b = 0; b < power.size(); ++b) {
        const double part = std::sqrt(bands_[b][0]);
        moved[b] = power[b] * (1 + part);
        const double above = statistic(moved);
        moved[b] = power[b] * std::max(0.0, 1 - part);
        slope[b] = (above - statistic(moved)) / (part + std::min(1.0, part));
        moved[b] = power[b];
    }
    double variance = 0;
    for (std::size_t b = 0; b < power.size(); ++b) {
        variance += slope[b] * slope[b] * bands_[b][0];
        for (std::size_t d = 1; d < bands_[b].size() && b + d < power.size(); ++d)
            variance += 2 * slope[b] * slope[b + d] * bands_[b][d];
    }
    return std::sqrt(std::max(0.0, variance));
}

TaperCovariance::TaperCovariance(const RegionTapers& tapers) : reach_(reach_of(tapers))
{
    const auto columns = static_cast<std::size_t>(reach_) + 1, heights = 2 * columns - 1;
    const std::vector<double> sums =
        reach_ > summed_reach ? fast_squares(tapers, reach_) : summed_squares(tapers, reach_);
    const auto middle = static_cast<std::size_t>(reach_);
    // At difference 0 it is the number of tapers, whatever rounding and the sum over nodes make of it.
    const double scale = 1 / (sums[middle] * static_cast<double>(tapers.count()));
    squares_.resize(heights * heights);
    for (std::size_t v = 0; v < heights; ++v)
        for (std::size_t u = 0; u < columns; ++u) {
            const double square = sums[u * heights + v] * scale;
            squares_[v * heights + middle + u] = square;
            squares_[(heights - 1 - v) * heights + middle - u] = square;
        }
}

double TaperCovariance::at(int u, int v) const
{
    if (std::abs(u) > reach_ || std::abs(v) > reach_) return 0;
    const int side = 2 * reach_ + 1;
    return squares_[static_cast<std::size_t>((v + reach_) * side + u + reach_)];
}

RingCovariance TaperCovariance::of_rings(int size, double bin_width) const
{
    const RadialBins bins(size, bin_width);
    const std::size_t rings = bins.count() - 1;
    const auto bands = static_cast<std::size_t>(std::ceil(std::sqrt(2.0) * reach_ / bin_width)) + 1;
    // Frequencies of a summed ring have all rings of their neighbours in the table.
    const int radius = std::min(size / 2, std::max({summed_radius, std::min(3 * reach_, most_radius),
                                                    static_cast<int>(std::ceil(4 * bin_width))}));
    std::vector<Difference> differences;
    for (int y = -reach_; y <= reach_; ++y)
        for (int x = -reach_; x <= reach_; ++x)
            if (at(x, y) > 0) differences.push_back({x, y, at(x, y)});
    RingTable ring_at(bins, radius + reach_);
    std::vector<std::vector<double>> sums(rings, std::vector<double>(bands));
    std::vector<double> samples(rings);
    for (int v = -radius; v <= radius; ++v) {
        stop_if_interrupted();
        for (int u = -radius; u <= radius; ++u) {
            const std::size_t ring = ring_at.at(u, v);
            if (ring >= rings) continue;
            ++samples[ring];
            for (const Difference& d : differences) {
                const std::size_t other = ring_at.at(u + d.u, v + d.v);
                if (other >= ring && other < rings && other - ring < bands) sums[ring][other - ring] += d.square;
            }
        }
    }
    std::size_t whole = 0; // rings that lie in the radius
    while (whole < rings && bins.centre(whole + 1) + bin_width / 2 <= radius) ++whole;
    for (std::size_t b = whole; b < rings; ++b) samples[b] = 2 * std::numbers::pi * bins.centre(b + 1) * bin_width;
    // f and -f have one power: twice the sum over the other half.
    std::vector<double> level(bands);
    for (std::size_t d = 0; d < bands; ++d) {
        // Rings that are farther apart than half of those summed, in long regions, are taken where there are some.
        const bool has_few = reach_ > summed_reach && d < whole;
        const std::size_t from = has_few ? std::min(whole / 2, (whole - d) / 2) : whole / 2;
        double all = 0;
        std::size_t counted = 0;
        for (std::size_t b = from; b + d < whole; ++b, ++counted)
            all += 2 * sums[b][d] / std::sqrt(samples[b] * samples[b + d]);
        level[d] = counted > 0 ? all / static_cast<double>(counted) : 0;
    }
    std::vector<std::vector<double>> covariance(rings);
    for (std::size_t b = 0; b < rings; ++b)
        for (std::size_t d = 0; d < bands && b + d < rings; ++d)
            covariance[b].push_back(b + d < whole ? 2 * sums[b][d] / (samples[b] * samples[b + d])
                                                  : level[d] / std::sqrt(samples[b] * samples[b + d]));
    return RingCovariance(std::move(covariance));
}

}
