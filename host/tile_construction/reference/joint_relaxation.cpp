// Relaxes tiles together sequentially: the plain twin of kernels/joint_nulling.cl, with Voronoi cells by CGAL.
#include "host/tile_construction/joint/joint_relaxation.hpp"

#include "host/sampling/cells/voronoi_cells.hpp"

#include <cmath>

namespace poissonlab::reference {
namespace {

class ReferenceJointEngine final : public JointEngine
{
public:
    explicit ReferenceJointEngine(int dimension) : dimension_(dimension) {}

    std::vector<double> centroid_displacements(const PointSet& points) override
    {
        return voronoi_cells(points).displacements;
    }

    std::vector<Displacement> nulling_displacements(std::span<const WeightedPoint> points,
                                                    std::span<const TileFrequency> frequencies, double longest) override
    {
        std::vector<std::complex<double>> transform;
        for (const TileFrequency& frequency : frequencies) {
            std::complex<double> sum;
            for (const WeightedPoint& point : points) sum += point.weight * wave(frequency, point);
            transform.push_back(sum);
        }
        const double step = nulling_step(points);
        std::vector<Displacement> displacements(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!points[i].moves) continue;
            Displacement sum{};
            for (std::size_t k = 0; k < frequencies.size(); ++k) {
                const std::complex<double> e = wave(frequencies[k], points[i]);
                const double slope = transform[k].real() * e.imag() - transform[k].imag() * e.real();
                const double part = slope / squared_length(frequencies[k]);
                for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += frequencies[k][axis] * part;
            }
            displacements[i] = limited(sum, -step * points[i].weight, longest);
        }
        return displacements;
    }

private:
    static std::complex<double> wave(const TileFrequency& frequency, const WeightedPoint& point)
    {
        return unit_circle()[phase_of(frequency, point.position)];
    }

    template <class Number>
    static double squared_length(const std::array<Number, 3>& vector)
    {
        double squared = 0;
        for (const Number x : vector) squared += static_cast<double>(x) * x;
        return squared;
    }

    static Displacement limited(const Displacement& sum, double factor, double longest)
    {
        Displacement movement = sum;
        for (double& x : movement) x *= factor;
        const double length = std::sqrt(squared_length(movement));
        const double scale = length > longest ? longest / length : 1;
        for (double& x : movement) x *= scale;
        return movement;
    }

    int dimension_;
};

}

std::unique_ptr<JointEngine> make_joint_engine(int dimension)
{
    return std::make_unique<ReferenceJointEngine>(dimension);
}

}
