#include "host/tile_construction/joint/tile_conditions.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace poissonlab {
namespace {

/// Waves have so many half cycles a tile along an axis, at most.
constexpr int most_half_cycles = 3;

double power(double x, unsigned exponent)
{
    double result = 1;
    for (unsigned i = 0; i < exponent; ++i) result *= x;
    return result;
}

double value_at(const Monomial& m, const TileConditions::Position& at)
{
    return power(at[0], m[0]) * power(at[1], m[1]) * power(at[2], m[2]);
}

double slope_at(Monomial m, std::size_t axis, const TileConditions::Position& at)
{
    const std::uint8_t exponent = m[axis];
    if (exponent == 0) return 0;
    --m[axis];
    return exponent * value_at(m, at);
}

/// exp(i pi / 2 (wave . at)) of all waves: half a cycle is from one border of the tile to the other.
class WavesAt
{
public:
    explicit WavesAt(const TileConditions::Position& at)
    {
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double quarter_turns = std::numbers::pi / 2 * at[axis];
            const std::complex<double> first(std::cos(quarter_turns), std::sin(quarter_turns));
            powers_[axis][0] = 1;
            for (std::size_t n = 1; n <= most_half_cycles; ++n) powers_[axis][n] = powers_[axis][n - 1] * first;
        }
    }

    std::complex<double> operator()(const std::array<int, 2>& wave) const
    {
        const std::complex<double> x = powers_[0][static_cast<std::size_t>(std::abs(wave[0]))];
        return (wave[0] < 0 ? std::conj(x) : x) * powers_[1][static_cast<std::size_t>(wave[1])];
    }

private:
    std::array<std::array<std::complex<double>, most_half_cycles + 1>, 2> powers_;
};

}

TileConditions::TileConditions(const PoissonTileParameters& p)
    : dimension_(p.dimension), monomials_(monomials_up_to(p.equal_moments, p.dimension))
{
    if (p.border == TileBorder::chain) waves_ = low_waves();
}

/// One of each two opposite ones, in steps of half a cycle, which is what the width of a tile tells apart. Equal
/// moments hold the lowest.
std::vector<TileConditions::Wave> TileConditions::low_waves()
{
    constexpr int above_squared = 1, most_squared = most_half_cycles * most_half_cycles + 1;
    std::vector<Wave> waves;
    for (int y = 0; y <= most_half_cycles; ++y)
        for (int x = -most_half_cycles; x <= most_half_cycles; ++x) {
            const int squared = x * x + y * y;
            if ((y > 0 || x > 0) && squared > above_squared && squared <= most_squared) waves.push_back({x, y});
        }
    return waves;
}

void TileConditions::values(const Position& at, std::span<double> values) const
{
    std::size_t condition = 0;
    for (const Monomial& monomial : monomials_) values[condition++] = value_at(monomial, at);
    if (waves_.empty()) return;
    const WavesAt waves(at);
    for (const Wave& wave : waves_) {
        const std::complex<double> e = waves(wave);
        values[condition++] = e.real();
        values[condition++] = e.imag();
    }
}

void TileConditions::slopes(const Position& at, std::span<double> slopes) const
{
    std::size_t next = 0;
    const WavesAt waves(at);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension_); ++axis) {
        for (const Monomial& monomial : monomials_) slopes[next++] = slope_at(monomial, axis, at);
        for (const Wave& wave : waves_) {
            const std::complex<double> e = std::numbers::pi / 2 * wave[axis] * waves(wave);
            slopes[next++] = -e.imag();
            slopes[next++] = e.real();
        }
    }
}

/// With less, waves hardly change, but points are pushed from where they lie well, and pushing them apart again adds
/// more power than was saved; with more, nulling adds it.
double TileConditions::softness(std::size_t condition) const { return stays(condition) ? 2 : 0; }

}
