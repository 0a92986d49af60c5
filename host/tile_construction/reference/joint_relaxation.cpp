// Relaxes tiles together sequentially: the plain twin of kernels/joint_nulling.cl, with Voronoi cells by CGAL.
#include "host/tile_construction/joint_relaxation.hpp"

#include "host/sampling/cells/voronoi_cells.hpp"
#include "host/tile_construction/unit_circle.hpp"

#include <cmath>

namespace poissonlab::reference {
namespace {

class ReferenceJointEngine final : public JointEngine
{
public:
    std::vector<double> centroid_displacements(const PointSet& points) override
    {
        return voronoi_cells(points).displacements;
    }

    std::vector<Displacement> nulling_displacements(std::span<const WeightedPoint> points,
                                                    std::uint32_t points_per_tile, double longest) override
    {
        const auto frequencies = nulled_frequencies(points_per_tile);
        std::vector<Displacement> transform;
        for (const auto& frequency : frequencies) {
            Displacement sum{};
            for (const WeightedPoint& point : points) {
                const std::complex<double> e = wave(frequency, point);
                sum[0] += point.weight * e.real();
                sum[1] += point.weight * e.imag();
            }
            transform.push_back(sum);
        }
        const double step = nulling_step(points);
        std::vector<Displacement> displacements(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!points[i].moves) continue;
            Displacement sum{};
            for (std::size_t k = 0; k < frequencies.size(); ++k) {
                const std::complex<double> e = wave(frequencies[k], points[i]);
                const double slope = transform[k][0] * e.imag() - transform[k][1] * e.real();
                const double x = frequencies[k][0], y = frequencies[k][1];
                const double part = slope / (x * x + y * y);
                sum[0] += x * part;
                sum[1] += y * part;
            }
            displacements[i] = limited(sum, -step * points[i].weight, longest);
        }
        return displacements;
    }

private:
    static std::complex<double> wave(const std::array<std::int32_t, 2>& frequency, const WeightedPoint& point)
    {
        return unit_circle()[phase_of(frequency, point.position[0], point.position[1])];
    }

    static Displacement limited(const Displacement& sum, double factor, double longest)
    {
        Displacement movement{sum[0] * factor, sum[1] * factor};
        const double length = std::sqrt(movement[0] * movement[0] + movement[1] * movement[1]);
        if (length > longest)
            for (double& x : movement) x *= longest / length;
        return movement;
    }
};

}

std::unique_ptr<JointEngine> make_joint_engine() { return std::make_unique<ReferenceJointEngine>(); }

}
