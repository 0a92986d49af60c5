#include "host/distribution/surface_spectra/mesh_pairs.hpp"

#include "base/random/random_words.hpp"
#include "base/surfaces/surface_paths.hpp"
#include "host/distribution/surface_spectra/pair_counts.hpp"
#include "host/distribution/surfaces/along_surface.hpp"
#include "host/distribution/surfaces/surface_neighbours.hpp"

#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace poissonlab {
namespace {

/// Paths of a set are followed through some so many windows, which takes a core some ten seconds; where there would be
/// more, they are followed from a part of the points. A look at a point of a triangle takes a tenth of the time.
constexpr double most_windows = 1e8, windows_a_look = 0.1;

PairCounts counts_of(std::size_t size) { return {std::vector<std::uint64_t>(size), std::vector<std::uint64_t>(size)}; }

void add(PairCounts& sum, const PairCounts& counts)
{
    for (std::size_t of = 0; of < 2; ++of)
        for (std::size_t i = 0; i < sum[of].size(); ++i) sum[of][i] += counts[of][i];
}

/// Counts along the surface. They are integers, whose order does not matter.
struct PathCounts
{
    PairCounts bins;        ///< of all parts
    PairCounts differences; ///< by squares
    PairCounts sectors;     ///< of lines without a direction, each pair once
};

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
        pairs.in_space = pair_correlation(count_in_space(), expected, 2);
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
        const double windows = std::pow(within(reach_), 1.5) + windows_a_look * points_beside();
        sources_ = points_.size();
        if (const double most = std::max(50.0, most_windows / windows); most < static_cast<double>(sources_)) {
            sources_ = static_cast<std::size_t>(most);
            RandomWords random(stream_key(seed, Purpose::surface_candidates, 3), 0);
            for (std::size_t i = 0; i < sources_; ++i)
                std::swap(order_[i], order_[i + random.below(static_cast<std::uint32_t>(order_.size() - i))]);
        }
    }

    /// Returns the mean number of points and random points in the triangle of a point: many on coarse meshes.
    double points_beside() const
    {
        std::vector<std::size_t> counts(ground_.mesh.triangles.size());
        for (const std::vector<SurfacePoint>* set : {&points_, &ground_.random})
            for (const SurfacePoint& point : *set) ++counts[point.triangle];
        double sum = 0;
        for (const SurfacePoint& point : points_) sum += static_cast<double>(counts[point.triangle]);
        return sum / static_cast<double>(points_.size());
    }

    /// All pairs that see each other, from both ends.
    PairCounts count_in_space() const
    {
        const FixedSurface& surface = ground_.surface;
        const double reach = surface.units_of(farthest_pair * unit_), scale = pair_bins / reach;
        const auto whole =
            static_cast<std::uint64_t>(std::min(reach + 1, std::ldexp(1.0, contract::surface::COORDINATE_BITS + 1)));
        const std::array<const std::vector<SurfacePoint>*, 2> sets{&points_, &ground_.random};
        PairCounts sum = counts_of(pair_bins);
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
                              counts_of(difference_rings * difference_sectors)};
        });
        std::vector<double> nearest(sources_, INFINITY);
        paths.from_each(positions_of(from), reach_ * unit_, [&](std::size_t i, std::span<const SurfacePath> found) {
            const TangentFrame frame(ground_.surface.triangles[from[i].triangle], axis);
            for (const SurfacePath& path : found)
                if (path.target != order_[i]) count_path(counts.local(), i, path, frame, nearest[i]);
        });
        PathCounts sum{counts_of(parts * pair_bins), counts_of(difference_squares * difference_squares),
                       counts_of(difference_rings * difference_sectors)};
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
        const auto sector =
            static_cast<std::size_t>((turn < 0 ? turn + 1 : turn) * difference_sectors) % difference_sectors;
        ++counts.sectors[of][static_cast<std::size_t>(length * difference_rings / farthest_pair) * difference_sectors +
                             sector];
    }

    void evaluate(MeshPairs& pairs, const PathCounts& counts, double expected) const
    {
        const double twice = sources_ == points_.size() ? 2 : 1;
        PairCounts all = counts_of(pair_bins);
        for (std::size_t of = 0; of < 2; ++of)
            for (std::size_t i = 0; i < counts.bins[of].size(); ++i) all[of][i % pair_bins] += counts.bins[of][i];
        pairs.along = pair_correlation(all, expected, twice);
        if (parts_.count > 0) pairs.localised = localised_correlation(counts.bins, parts_.count);
        pairs.anisotropy = difference_anisotropy(counts.sectors);
        const std::vector<double> found = blurred_differences(counts.differences[0]),
                                  random = blurred_differences(counts.differences[1]);
        for (std::size_t i = 0; i < found.size(); ++i)
            pairs.differences.push_back(random[i] > 0 ? found[i] / (random[i] * expected) : 0);
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

}
