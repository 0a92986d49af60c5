#include "host/distribution/surface_spectra/mesh_pairs.hpp"

#include "analysis/surfaces/surface_paths.hpp"
#include "base/random/random_words.hpp"
#include "host/distribution/surfaces/surface_files.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"

#include <fmt/format.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

constexpr std::size_t rings = 16, sectors = 12;

/// A ring has an anisotropy from that many pairs on, five for each sector.
constexpr std::uint64_t least_in_ring = 5 * sectors;

/// Paths of a set are followed through some so many windows, which takes a core some ten seconds; where there would be
/// more, they are followed from a part of the points.
constexpr double most_windows = 1e8;

/// Pairs of points, [0], and of points and random points, [1].
using Counts = std::array<std::vector<std::uint64_t>, 2>;

double distance_of(std::size_t bin) { return (static_cast<double>(bin) + 0.5) * farthest_pair / pair_bins; }

Counts counts_of(std::size_t size) { return {std::vector<std::uint64_t>(size), std::vector<std::uint64_t>(size)}; }

void add(Counts& sum, const Counts& counts)
{
    for (std::size_t of = 0; of < 2; ++of)
        for (std::size_t i = 0; i < sum[of].size(); ++i) sum[of][i] += counts[of][i];
}

/// What is counted along the surface. Integers: their order does not matter.
struct PathCounts
{
    Counts bins;        ///< of all parts
    Counts differences; ///< by squares
    Counts sectors;     ///< of lines without a direction, each pair once
};

std::vector<MeshPosition> positions_of(const std::vector<SurfacePoint>& points)
{
    std::vector<MeshPosition> positions;
    for (const SurfacePoint& p : points) positions.push_back({p.triangle, barycentrics_of(p)});
    return positions;
}

/// Returns g, its errors as those of independent pairs. `expected`: pairs for each pair of a point and a random one;
/// `twice`: pairs of points are counted from both ends.
std::vector<PairCorrelationBin> correlation(const Counts& counts, double expected, double twice)
{
    std::vector<PairCorrelationBin> bins;
    for (std::size_t k = 0; k < counts[0].size(); ++k) {
        const auto pairs = static_cast<double>(counts[0][k]), random = static_cast<double>(counts[1][k]);
        if (random == 0) continue;
        const double value = pairs / (random * expected), one = twice / (random * expected);
        bins.push_back({distance_of(k), value,
                        std::hypot(one * std::sqrt(std::max(pairs / twice, 1.0)), value / std::sqrt(random)),
                        pairs / twice});
    }
    return bins;
}

/// The axis of space that is nearest to the tangent planes: ways are turned such that its projection points to the
/// right.
std::size_t axis_of(const FixedSurface& surface)
{
    MeshPoint squares{};
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const MeshPoint normal = normal_of(surface.triangles[t]);
        for (std::size_t k = 0; k < 3; ++k) squares[k] += surface.areas[t] * normal[k] * normal[k];
    }
    return static_cast<std::size_t>(std::ranges::min_element(squares) - squares.begin());
}

/// Two directions in the plane of a triangle.
struct TangentFrame
{
    MeshPoint right, up;

    TangentFrame(const SurfaceTriangle& triangle, std::size_t axis)
    {
        const MeshPoint normal = normal_of(triangle);
        if (std::abs(normal[axis]) > 1 - 1e-9) axis = (axis + 1) % 3;
        for (std::size_t k = 0; k < 3; ++k) right[k] = (k == axis ? 1 : 0) - normal[axis] * normal[k];
        right = unit(right);
        up = cross(normal, right);
    }
};

/// Blurs counts with the binomial weights of a Gaussian whose standard deviation is 1.5 squares along both axes.
std::vector<double> blurred(const std::vector<std::uint64_t>& counts)
{
    constexpr std::array<double, 10> weights{1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
    constexpr auto n = static_cast<std::ptrdiff_t>(difference_squares);
    std::vector<double> from(counts.begin(), counts.end()), to(counts.size());
    // Twice a binomial of 9 steps is shifted by half a square to either side.
    for (const std::ptrdiff_t shift : {-4, -5}) {
        for (std::ptrdiff_t y = 0; y < n; ++y)
            for (std::ptrdiff_t x = 0; x < n; ++x) {
                double sum = 0;
                for (std::ptrdiff_t i = 0; i < 10; ++i)
                    if (const std::ptrdiff_t at = x + i + shift; at >= 0 && at < n)
                        sum += weights[i] * from[y * n + at];
                to[x * n + y] = sum; // rows become columns, so that the second time blurs along the other axis
            }
        from.swap(to);
    }
    return from;
}

class PairCount
{
public:
    PairCount(const PairGround& ground, const std::vector<SurfacePoint>& points, const PartsOfPoints& parts,
              std::uint64_t seed)
        : ground_(ground), points_(points), parts_(parts),
          unit_(std::sqrt(2 / std::numbers::sqrt3 * ground.surface.area / static_cast<double>(points.size()))),
          order_(points.size()), rank_(points.size())
    {
        std::iota(order_.begin(), order_.end(), 0u);
        choose_sources(seed);
        for (std::uint32_t i = 0; i < order_.size(); ++i) rank_[order_[i]] = i;
    }

    MeshPairs count() const
    {
        MeshPairs pairs;
        pairs.unit = unit_;
        pairs.sources = sources_;
        pairs.reach = reach_;
        const double expected = static_cast<double>(points_.size() - 1) / static_cast<double>(ground_.random.size());
        pairs.in_space = correlation(count_in_space(), expected, 2);
        count_along(pairs, expected);
        return pairs;
    }

private:
    /// A path enters some root of T of the T triangles within reach, or fewer, and there are as many windows as ends of
    /// paths to vertices.
    void choose_sources(std::uint64_t seed)
    {
        const double triangles = static_cast<double>(ground_.mesh.triangles.size()), area = ground_.surface.area;
        const auto within = [&](double reach) {
            return std::min(1.0, std::numbers::pi * reach * reach * unit_ * unit_ / area) * triangles;
        };
        if (const double all = within(farthest_pair); all > most_path_triangles)
            reach_ =
                std::min(farthest_pair, std::sqrt(most_path_triangles / triangles * area / std::numbers::pi) / unit_);
        const double windows = std::pow(within(reach_), 1.5);
        sources_ = points_.size();
        if (const double most = std::max(50.0, most_windows / windows); most < static_cast<double>(sources_)) {
            sources_ = static_cast<std::size_t>(most);
            RandomWords random(stream_key(seed, Purpose::surface_candidates, 3), 0);
            for (std::size_t i = 0; i < sources_; ++i)
                std::swap(order_[i], order_[i + random.below(static_cast<std::uint32_t>(order_.size() - i))]);
        }
    }

    /// All pairs that see each other, from both ends.
    Counts count_in_space() const
    {
        const FixedSurface& surface = ground_.surface;
        const double reach = surface.units_of(farthest_pair * unit_), scale = pair_bins / reach;
        const auto whole =
            static_cast<std::uint64_t>(std::min(reach + 1, std::ldexp(1.0, contract::surface::COORDINATE_BITS + 1)));
        const std::array<const std::vector<SurfacePoint>*, 2> sets{&points_, &ground_.random};
        Counts sum = counts_of(pair_bins);
        for (std::size_t of = 0; of < 2; ++of) {
            const SurfaceNeighbours near(surface, *sets[of], whole);
            tbb::combinable<std::vector<std::uint64_t>> counts([&] { return std::vector<std::uint64_t>(pair_bins); });
            tbb::parallel_for(std::size_t{0}, points_.size(), [&](std::size_t i) {
                std::vector<std::uint64_t>& bins = counts.local();
                const SurfaceTriangle& triangle = surface.triangles[points_[i].triangle];
                near.for_each_around(place_of(points_[i]), [&](std::uint32_t other) {
                    const SurfacePoint& point = (*sets[of])[other];
                    if ((of == 0 && other == i) ||
                        cosine_between(triangle, surface.triangles[point.triangle]) < ground_.least_cosine)
                        return;
                    const auto squared = static_cast<double>(squared_distance(place_of(points_[i]), place_of(point)));
                    if (const double bin = std::sqrt(squared) * scale; bin < pair_bins)
                        ++bins[static_cast<std::size_t>(bin)];
                });
            });
            counts.combine_each([&](const std::vector<std::uint64_t>& bins) {
                for (std::size_t k = 0; k < pair_bins; ++k) sum[of][k] += bins[k];
            });
        }
        return sum;
    }

    void count_along(MeshPairs& pairs, double expected) const
    {
        std::vector<SurfacePoint> ends = points_;
        ends.insert(ends.end(), ground_.random.begin(), ground_.random.end());
        std::vector<SurfacePoint> from;
        for (std::size_t i = 0; i < sources_; ++i) from.push_back(points_[order_[i]]);
        const SurfacePaths paths(ground_.mesh, positions_of(ends));
        const std::size_t axis = axis_of(ground_.surface), parts = std::max<std::size_t>(parts_.count, 1);
        tbb::combinable<PathCounts> counts([&] {
            return PathCounts{counts_of(parts * pair_bins), counts_of(difference_squares * difference_squares),
                              counts_of(rings * sectors)};
        });
        std::vector<double> nearest(sources_, INFINITY);
        paths.from_each(positions_of(from), reach_ * unit_, [&](std::size_t i, std::span<const SurfacePath> found) {
            const TangentFrame frame(ground_.surface.triangles[from[i].triangle], axis);
            for (const SurfacePath& path : found)
                if (path.target != order_[i]) count_path(counts.local(), i, path, frame, nearest[i]);
        });
        PathCounts sum{counts_of(parts * pair_bins), counts_of(difference_squares * difference_squares),
                       counts_of(rings * sectors)};
        counts.combine_each([&](const PathCounts& part) {
            add(sum.bins, part.bins);
            add(sum.differences, part.differences);
            add(sum.sectors, part.sectors);
        });
        evaluate(pairs, sum, expected);
        set_nearest(pairs, nearest);
    }

    void count_path(PathCounts& counts, std::size_t source, const SurfacePath& path, const TangentFrame& frame,
                    double& nearest) const
    {
        const std::size_t of = path.target < points_.size() ? 0 : 1;
        if (of == 0) nearest = std::min(nearest, path.length);
        const double length = path.length / unit_;
        if (!(length < farthest_pair)) return;
        const std::size_t part = parts_.count == 0 ? 0 : parts_.of_point[order_[source]];
        ++counts.bins[of][part * pair_bins + static_cast<std::size_t>(length * pair_bins / farthest_pair)];
        const double x = dot(path.way, frame.right) / unit_, y = dot(path.way, frame.up) / unit_;
        constexpr double scale = difference_squares / (2 * farthest_pair);
        const auto last = static_cast<double>(difference_squares - 1);
        const auto column = static_cast<std::size_t>(std::clamp((farthest_pair + x) * scale, 0.0, last)),
                   row = static_cast<std::size_t>(std::clamp((farthest_pair - y) * scale, 0.0, last));
        ++counts.differences[of][row * difference_squares + column];
        if (of == 0 && rank_[path.target] < source) return;      // the pair is counted from its other end
        const double turn = std::atan2(y, x) / std::numbers::pi; // in half turns, from -1 to 1
        const auto sector = static_cast<std::size_t>((turn < 0 ? turn + 1 : turn) * sectors) % sectors;
        ++counts.sectors[of][static_cast<std::size_t>(length * rings / farthest_pair) * sectors + sector];
    }

    void evaluate(MeshPairs& pairs, const PathCounts& counts, double expected) const
    {
        const double twice = sources_ == points_.size() ? 2 : 1;
        Counts all = counts_of(pair_bins);
        for (std::size_t of = 0; of < 2; ++of)
            for (std::size_t i = 0; i < counts.bins[of].size(); ++i) all[of][i % pair_bins] += counts.bins[of][i];
        pairs.along = correlation(all, expected, twice);
        if (parts_.count > 0) pairs.localised = localised(counts.bins);
        pairs.anisotropy = anisotropy(counts.sectors);
        const std::vector<double> found = blurred(counts.differences[0]), random = blurred(counts.differences[1]);
        for (std::size_t i = 0; i < found.size(); ++i)
            pairs.differences.push_back(random[i] > 0 ? found[i] / (random[i] * expected) : 0);
    }

    /// The sum of pairs over the sum of what the densities around the points of each part let expect: those of points
    /// within reach, the points themselves left out.
    std::vector<PairCorrelationBin> localised(const Counts& bins) const
    {
        std::vector<PairCorrelationBin> local;
        for (std::size_t k = 0; k < pair_bins; ++k) {
            std::vector<double> pairs(parts_.count), expected(parts_.count);
            for (std::size_t p = 0; p < parts_.count; ++p) {
                const auto begin = static_cast<std::ptrdiff_t>(p * pair_bins);
                const auto within = [&](std::size_t of) {
                    return static_cast<double>(std::accumulate(bins[of].begin() + begin,
                                                               bins[of].begin() + begin + pair_bins, std::uint64_t{0}));
                };
                pairs[p] = static_cast<double>(bins[0][p * pair_bins + k]);
                if (within(1) > 0)
                    expected[p] = static_cast<double>(bins[1][p * pair_bins + k]) * within(0) / within(1);
            }
            const double all = std::accumulate(pairs.begin(), pairs.end(), 0.0),
                         sum = std::accumulate(expected.begin(), expected.end(), 0.0);
            if (!(sum > 0)) continue;
            double squares = 0;
            for (std::size_t p = 0; p < parts_.count; ++p)
                if (expected[p] > 0) squares += expected[p] * std::pow(pairs[p] / expected[p] - all / sum, 2);
            local.push_back({distance_of(k), all / sum, std::sqrt(squares / sum), all});
        }
        return local;
    }

    /// The variance of the pairs in the sectors of a ring, over that of independent pairs.
    static std::vector<std::array<double, 2>> anisotropy(const Counts& counts)
    {
        std::vector<std::array<double, 2>> found;
        for (std::size_t ring = 0; ring < rings; ++ring) {
            const auto begin = static_cast<std::ptrdiff_t>(ring * sectors);
            std::array<std::uint64_t, 2> all{};
            for (std::size_t of = 0; of < 2; ++of)
                all[of] =
                    std::accumulate(counts[of].begin() + begin, counts[of].begin() + begin + sectors, std::uint64_t{0});
            if (all[0] < least_in_ring || all[1] == 0) continue;
            const double ratio = static_cast<double>(all[0]) / static_cast<double>(all[1]);
            double sum = 0;
            for (std::size_t s = 0; s < sectors; ++s) {
                const auto pairs = static_cast<double>(counts[0][ring * sectors + s]);
                const double expected = ratio * static_cast<double>(counts[1][ring * sectors + s]);
                if (expected > 0) sum += (pairs - expected) * (pairs - expected) / (expected * (1 + ratio));
            }
            if (sum > 0)
                found.push_back(
                    {(static_cast<double>(ring) + 0.5) * farthest_pair / rings, 10 * std::log10(sum / (sectors - 1))});
        }
        return found;
    }

    void set_nearest(MeshPairs& pairs, const std::vector<double>& nearest) const
    {
        double sum = 0;
        std::size_t count = 0;
        for (const double length : nearest)
            if (length < INFINITY) sum += length, ++count;
        pairs.nearest_along = count > 0 ? sum / static_cast<double>(count) / unit_ : INFINITY;
        if (sources_ == points_.size() && count > 0) pairs.least_along = std::ranges::min(nearest) / unit_;
    }

    const PairGround& ground_;
    const std::vector<SurfacePoint>& points_;
    const PartsOfPoints& parts_;
    double unit_, reach_ = farthest_pair;
    std::size_t sources_ = 0;
    std::vector<std::uint32_t> order_, rank_; ///< the first of them are the sources
};

}

MeshPairs pairs_on_mesh(const PairGround& ground, const std::vector<SurfacePoint>& points, const PartsOfPoints& parts,
                        std::uint64_t seed)
{
    return PairCount(ground, points, parts, seed).count();
}

std::string mesh_pairs_csv(const MeshPairs& pairs)
{
    std::string text = "distance,along,along_error,in_space,in_space_error,localised,localised_spread\n";
    const auto cells = [](const std::vector<PairCorrelationBin>& bins, double distance) {
        for (const PairCorrelationBin& bin : bins)
            if (bin.distance == distance) return fmt::format(",{},{}", bin.value, bin.standard_error);
        return std::string(",nan,nan");
    };
    for (std::size_t k = 0; k < pair_bins; ++k) {
        const double distance = distance_of(k);
        text += fmt::format("{}{}{}{}\n", distance, cells(pairs.along, distance), cells(pairs.in_space, distance),
                            cells(pairs.localised, distance));
    }
    return text;
}

}
