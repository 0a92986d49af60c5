#include "analysis/zone_plate/false_rings.hpp"

#include "analysis/spectra/fftw_plan.hpp"
#include "analysis/zone_plate/zone_plate_reference.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace poissonlab {

namespace {

using Complex = std::complex<double>;

constexpr int neighbourhood = 16; ///< frequencies to either side that say what noise is
constexpr int own = 2;            ///< those that a strong plate spills into
constexpr int plate_itself = 16;  ///< frequencies to either side of 0: centres within 1.05 of the origin

/// The picture's error times exp(-i |x|^2).
std::vector<Complex> dechirped(const SquareImage& picture, const SquareImage& reference)
{
    const double pixel = plate_side / picture.size;
    std::vector<Complex> line(static_cast<std::size_t>(picture.size));
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double x = (static_cast<double>(i) + 0.5) * pixel;
        line[i] = std::polar(1.0, -x * x);
    }
    std::vector<Complex> field(picture.pixels.size());
    for (std::size_t row = 0; row < line.size(); ++row)
        for (std::size_t column = 0; column < line.size(); ++column) {
            const std::size_t i = row * line.size() + column;
            field[i] = (picture.pixels[i] - reference.pixels[i]) * line[row] * line[column];
        }
    return field;
}

void transform(std::vector<Complex>& field, int size)
{
    fftw_complex* const data = fftw(field.data());
    fftw_execute(make_fftw_plan(fftw_plan_dft_2d, size, size, data, data, FFTW_FORWARD, FFTW_ESTIMATE).get());
}

/// Powers with their sums over squares, around the ends.
class PowerMap
{
public:
    PowerMap(const std::vector<Complex>& field, int size) : size_(size), power_(field.size())
    {
        std::ranges::transform(field, power_.begin(), [](const Complex& value) { return std::norm(value); });
    }

    double at(int column, int row) const { return power_[index(column, row)]; }

    /// The sum over the square of this half width, of all places.
    std::vector<double> sums(int half) const
    {
        const auto rows = line_sums(power_, half, [&](int line, int place) { return index(place, line); });
        return line_sums(rows, half, [&](int line, int place) { return index(line, place); });
    }

    std::size_t index(int column, int row) const
    {
        const auto wrapped = [&](int i) { return static_cast<std::size_t>((i + size_) % size_); };
        return wrapped(row) * static_cast<std::size_t>(size_) + wrapped(column);
    }

private:
    // Sums along lines, each from the one before; index(line, place) says where a place of a line is.
    template <typename Index>
    std::vector<double> line_sums(const std::vector<double>& values, int half, const Index& at) const
    {
        std::vector<double> sums(values.size());
        for (int line = 0; line < size_; ++line) {
            double sum = 0;
            for (int d = -half; d <= half; ++d) sum += values[at(line, d)];
            for (int place = 0; place < size_; ++place) {
                sums[at(line, place)] = sum;
                sum += values[at(line, place + half + 1)] - values[at(line, place - half)];
            }
        }
        return sums;
    }

    int size_;
    std::vector<double> power_;
};

constexpr int side_of(int half) { return 2 * half + 1; }

}

double false_rings_bound(std::size_t pixels) { return std::log(static_cast<double>(pixels) / 0.01); }

FalseRings strongest_false_rings(const SquareImage& picture, const SquareImage& reference)
{
    const int size = picture.size;
    if (size < smallest_false_rings_picture)
        throw std::invalid_argument("false rings need a picture of at least 64 x 64 pixels");
    if (reference.size != size) throw std::invalid_argument("false rings need a reference of the picture's size");
    auto field = dechirped(picture, reference);
    transform(field, size);
    const PowerMap powers(field, size);
    const auto around = powers.sums(neighbourhood);
    const auto inside = powers.sums(own);
    constexpr double count = side_of(neighbourhood) * side_of(neighbourhood) - side_of(own) * side_of(own);

    const auto strength_at = [&](std::size_t i, double power) {
        const double noise = (around[i] - inside[i]) / count;
        return noise > 0 ? power / noise : 0;
    };
    FalseRings strongest;
    strongest.at_the_plate = strength_at(0, powers.at(0, 0));
    const auto frequency = [&](int i) { return i < size / 2 ? i : i - size; };
    for (int row = 0; row < size; ++row)
        for (int column = 0; column < size; ++column) {
            const int u = frequency(column), v = frequency(row);
            if (std::max(std::abs(u), std::abs(v)) <= plate_itself) continue;
            const double strength = strength_at(powers.index(column, row), powers.at(column, row));
            if (strength <= strongest.strength) continue;
            // A plate around c is exp(-2 i c.x): frequency -c 48 / pi.
            strongest.strength = strength;
            strongest.x = -u * std::numbers::pi / plate_side;
            strongest.y = -v * std::numbers::pi / plate_side;
        }
    return strongest;
}

}
