// The periodogram by the exact sum (dissertation, equation 6.1) in double precision, as real matrix products.
//
// P(f) = |sum_j exp(-2 pi i f.x_j)|^2 / N separates into phases along the leading axes (x; in 3D x and y) and
// along the last one (y; z). With c, s the cosines and sines of each, the four real sums
//   CC = sum c_lead c_last,  SC = sum s_lead c_last,  CS = sum c_lead s_last,  SS = sum s_lead s_last
// give (u, v) and (u, -v):  P(u, +-v) = ((CC -+ SS)^2 + (SC +- CS)^2) / N,  and P(-f) = P(f) gives u < 0.
//
// The last axis goes through strip moments (strip_expansion.hpp): for a block of leading frequencies
//   1. moments: G_kr = sum over the points of strip k of (c_lead, s_lead) T_r(t), a product for each strip;
//   2. fold G to a quarter, apart for even and odd v;
//   3. multiply the coefficients C_v and S_v with the folded moments: CC, SC and CS, SS for all v >= 0.
// For 16,384 points and 1,024 x 1,024 frequencies these are 4 GFlop; the plain products of the phases would
// be 34, which takes longer even in single precision.
//
// Error. Phases are integers modulo 2^64, exact until the call of cos and sin at the head of a block; within it they
// advance by at most 64 complex rotations, an error below 64 * 3.3 * 2^-53 = 2.4e-14. The magnitudes of a phase's R
// terms add up to at most sqrt(2 R) < 12 (Cauchy-Schwarz: J_0^2 + 2 sum J_r^2 = 1), so that products with chains of L
// additions are off by at most 12 L 2^-53 of N: 2e-12 for the L = 1,250 of the example, below 1e-11 for L < 7,000
// (strips of 1,000 points, 4,096 samples an axis). Each transform value is within 1e-11 N of the exact sum (rounding in
// T_r, r^2 2^-53 at most, included), and in practice, where rounding errors have both signs, within 1e-14 N.
//
// Determinism. The blocks are fixed by N and M alone, each is computed by one thread with single-threaded
// BLAS and owns the values that it writes: any number of threads gives the same bytes.
#include "analysis/spectra/spectrum.hpp"
#include "analysis/spectra/strip_expansion.hpp"

#include <cblas.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace poissonlab {

namespace {

constexpr std::size_t max_block = 64;  // leading frequencies a block: bounds the rotations, fills BLAS kernels
constexpr std::size_t max_chunk = 512; // points a product: bounds the memory of clustered strips

/// A coordinate in [0, 1) as a fraction of 2^64: products with integers wrap around like phases do.
std::uint64_t to_turn(double x) { return static_cast<std::uint64_t>(std::ldexp(x, 64)); }

/// The angle of a turn, in (-pi, pi].
double angle(std::uint64_t turn)
{
    return 2.0 * std::numbers::pi * std::ldexp(static_cast<double>(static_cast<std::int64_t>(turn)), -64);
}

/// The points, sorted by the strip of their last coordinate; within a strip in the order of the set.
struct StripPoints
{
    std::vector<std::size_t> start;             ///< first point of strip k; B + 1 values
    std::vector<std::uint64_t> x, y;            ///< leading coordinates as turns; y is 0 in 2D
    std::vector<double> step_cosine, step_sine; ///< of 2 pi x: the rotation from one u to the next
    std::vector<double> chebyshev;              ///< strip after strip, row r holds T_r(t) of its points

    StripPoints(const PointSet& points, const StripExpansion& expansion);
};

StripPoints::StripPoints(const PointSet& points, const StripExpansion& expansion)
    : start(static_cast<std::size_t>(expansion.strips) + 1), x(points.size()), y(points.size()),
      step_cosine(points.size()), step_sine(points.size()),
      chebyshev(points.size() * static_cast<std::size_t>(expansion.terms))
{
    const std::size_t n = points.size();
    const std::size_t last = static_cast<std::size_t>(points.dimension) - 1;
    const int strip_bits = std::countr_zero(static_cast<unsigned>(expansion.strips));
    const auto strip_of = [&](std::size_t i) { return to_turn(points[i][last]) >> (64 - strip_bits); };

    // Counting sort.
    for (std::size_t i = 0; i < n; ++i) ++start[strip_of(i) + 1];
    for (std::size_t k = 1; k < start.size(); ++k) start[k] += start[k - 1];
    std::vector<std::size_t> next(start.begin(), start.end() - 1);
    std::vector<double> t(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t at = next[strip_of(i)]++;
        x[at] = to_turn(points[i][0]);
        y[at] = points.dimension == 3 ? to_turn(points[i][1]) : 0;
        // The point's place in its strip, from -1 to 1, is the bits below the strip's number, as a signed fraction.
        const std::uint64_t within = (to_turn(points[i][last]) << strip_bits) ^ (std::uint64_t{1} << 63);
        t[at] = std::ldexp(static_cast<double>(static_cast<std::int64_t>(within)), -63);
    }

    tbb::parallel_for(0, expansion.strips, [&](int k) {
        const std::size_t begin = start[k], count = start[k + 1] - begin;
        double* row = chebyshev.data() + begin * expansion.terms;
        for (std::size_t i = begin; i < begin + count; ++i) {
            step_cosine[i] = std::cos(angle(x[i]));
            step_sine[i] = std::sin(angle(x[i]));
        }
        for (int r = 0; r < expansion.terms; ++r, row += count) {
            for (std::size_t i = 0; i < count; ++i) {
                row[i] = r == 0   ? 1.0
                         : r == 1 ? t[begin + i]
                                  : 2.0 * t[begin + i] * row[i - count] - row[i - 2 * count];
            }
        }
    });
}

/// Leading frequencies (first_u + i, v), i = 0 .. count - 1; v is 0 in 2D.
struct FrequencyBlock
{
    int first_u = 0;
    int count = 0;
    int v = 0;
};

/// The fixed division of the leading frequencies u = 0 .. M/2 (3D: times v = -M/2 .. M/2) into equal blocks.
std::vector<FrequencyBlock> frequency_blocks(int dimension, int size)
{
    const int columns = size / 2 + 1;
    const int blocks = (columns + static_cast<int>(max_block) - 1) / static_cast<int>(max_block);
    const int half_v = dimension == 3 ? size / 2 : 0;
    std::vector<FrequencyBlock> result;
    for (int v = -half_v; v <= half_v; ++v) {
        for (int b = 0; b < blocks; ++b) {
            const int first = columns * b / blocks;
            result.push_back({first, columns * (b + 1) / blocks - first, v});
        }
    }
    return result;
}

/// Memory of one thread, kept from block to block.
struct Workspace
{
    std::vector<double> phases;                 ///< cosines, then sines: a row a frequency, a column a point
    std::array<std::vector<double>, 4> moments; ///< of four strips: a row a polynomial
    std::array<std::array<std::vector<double>, 2>, 2> folded_by_parity;
    std::array<std::array<std::vector<double>, 2>, 2> sums;
};

class Periodogram
{
public:
    Periodogram(const PointSet& points, int size)
        : dimension_(points.dimension), size_(size), expansion_(cheapest_expansion(points.size(), size)),
          points_(points, expansion_), coefficients_(strip_coefficients(expansion_, size / 2)),
          scale_(1.0 / static_cast<double>(points.size()))
    {}

    std::vector<double> compute() const;

private:
    void fill_phases(const FrequencyBlock& block, std::size_t begin, std::size_t count, double* phases) const;
    void strip_moments(const FrequencyBlock& block, int strip, Workspace& work, std::vector<double>& moments) const;
    void folded_moments(const FrequencyBlock& block, Workspace& work) const;
    void multiply(const FrequencyBlock& block, Workspace& work) const;
    void store(const FrequencyBlock& block, const Workspace& work, std::vector<double>& power) const;
    std::size_t index(int u, int v, int w) const;

    int dimension_, size_;
    StripExpansion expansion_;
    StripPoints points_;
    StripCoefficients coefficients_;
    double scale_;
};

/// cos and sin of 2 pi (u x + v y) for `count` points from `begin`: exact at the first u, then by rotation.
void Periodogram::fill_phases(const FrequencyBlock& block, std::size_t begin, std::size_t count, double* phases) const
{
    const std::size_t sines = static_cast<std::size_t>(block.count) * count;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint64_t turn = static_cast<std::uint64_t>(block.first_u) * points_.x[begin + i] +
                                   static_cast<std::uint64_t>(block.v) * points_.y[begin + i];
        phases[i] = std::cos(angle(turn));
        phases[sines + i] = std::sin(angle(turn));
    }
    const double* __restrict a = points_.step_cosine.data() + begin;
    const double* __restrict b = points_.step_sine.data() + begin;
    for (int u = 1; u < block.count; ++u) {
        const double* __restrict c = phases + static_cast<std::size_t>(u - 1) * count;
        const double* __restrict s = c + sines;
        double* __restrict next_c = phases + static_cast<std::size_t>(u) * count;
        double* __restrict next_s = next_c + sines;
        for (std::size_t i = 0; i < count; ++i) {
            next_c[i] = c[i] * a[i] - s[i] * b[i];
            next_s[i] = s[i] * a[i] + c[i] * b[i];
        }
    }
}

/// Step 1 for one strip: R rows of block.count cosine and block.count sine moments.
void Periodogram::strip_moments(const FrequencyBlock& block, int strip, Workspace& work,
                                std::vector<double>& moments) const
{
    const int columns = 2 * block.count;
    const std::size_t begin = points_.start[strip], total = points_.start[strip + 1] - begin;
    const double* chebyshev = points_.chebyshev.data() + begin * expansion_.terms;
    std::fill(moments.begin(), moments.end(), 0.0);
    for (std::size_t done = 0; done < total; done += max_chunk) {
        const std::size_t count = std::min(max_chunk, total - done);
        fill_phases(block, begin + done, count, work.phases.data());
        cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasTrans, expansion_.terms, columns, static_cast<int>(count), 1.0,
                    chebyshev + done, static_cast<int>(total), work.phases.data(), static_cast<int>(count), 1.0,
                    moments.data(), columns);
    }
}

/// Steps 1 and 2 for all strips.
void Periodogram::folded_moments(const FrequencyBlock& block, Workspace& work) const
{
    const std::size_t columns = 2 * static_cast<std::size_t>(block.count);
    const std::size_t panel = static_cast<std::size_t>(expansion_.terms) * columns;
    work.phases.resize(columns * max_chunk);
    for (auto& moments : work.moments) moments.resize(panel);
    for (auto& parity : work.folded_by_parity)
        for (auto& folded : parity) folded.resize(expansion_.folded_moments() * columns);

    for (int k = 0; k < expansion_.strips / 4; ++k) {
        const auto strips = folded_strips(expansion_, k);
        for (std::size_t i = 0; i < 4; ++i) strip_moments(block, strips[i], work, work.moments[i]);
        for (std::size_t odd = 0; odd < 2; ++odd) {
            auto& [cosine, sine] = work.folded_by_parity[odd];
            fold({work.moments[0].data(), work.moments[1].data(), work.moments[2].data(), work.moments[3].data()},
                 expansion_.terms, columns, odd == 1, cosine.data() + k * panel, sine.data() + k * panel);
        }
    }
}

/// Step 3: sums[parity][0] holds CC and SC, sums[parity][1] CS and SS; a row for each v >= 0 of that parity.
void Periodogram::multiply(const FrequencyBlock& block, Workspace& work) const
{
    const int columns = 2 * block.count;
    const int inner = static_cast<int>(expansion_.folded_moments());
    for (int odd = 0; odd < 2; ++odd) {
        const int rows = (size_ / 2 - odd) / 2 + 1;
        for (int trig = 0; trig < 2; ++trig) {
            const auto& table = trig == 0 ? coefficients_.cosine[odd] : coefficients_.sine[odd];
            auto& sums = work.sums[odd][trig];
            sums.resize(static_cast<std::size_t>(rows) * columns);
            cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, rows, columns, inner, 1.0, table.data(), inner,
                        work.folded_by_parity[odd][trig].data(), columns, 0.0, sums.data(), columns);
        }
    }
}

std::size_t Periodogram::index(int u, int v, int w) const
{
    const int half = size_ / 2;
    const std::size_t row = dimension_ == 3 ? static_cast<std::size_t>(w + half) * size_ + (v + half) : w + half;
    return row * size_ + (u + half);
}

/// Power at (u, v, +-w) and, by symmetry, at the opposite frequencies. Column u = 0 is its own opposite and
/// is taken as computed, so that every value is written by one block only.
void Periodogram::store(const FrequencyBlock& block, const Workspace& work, std::vector<double>& power) const
{
    const int half = size_ / 2;
    const auto set = [&](int u, int v, int w, double value) {
        if (u < half && v < half && w < half) power[index(u, v, w)] = value;
        if (u > 0 && v > -half && w > -half) power[index(-u, -v, -w)] = value;
    };
    for (int w = 0; w <= half; ++w) {
        const std::size_t row = static_cast<std::size_t>(w / 2) * 2 * block.count;
        const double* cc = work.sums[w % 2][0].data() + row;
        const double* cs = work.sums[w % 2][1].data() + row;
        const double* sc = cc + block.count;
        const double* ss = cs + block.count;
        for (int i = 0; i < block.count; ++i) {
            const auto norm = [](double re, double im) { return re * re + im * im; };
            set(block.first_u + i, block.v, w, scale_ * norm(cc[i] - ss[i], sc[i] + cs[i]));
            set(block.first_u + i, block.v, -w, scale_ * norm(cc[i] + ss[i], sc[i] - cs[i]));
        }
    }
}

std::vector<double> Periodogram::compute() const
{
    std::vector<double> power(dimension_ == 3 ? static_cast<std::size_t>(size_) * size_ * size_
                                              : static_cast<std::size_t>(size_) * size_);
    const auto blocks = frequency_blocks(dimension_, size_);
    tbb::enumerable_thread_specific<Workspace> workspaces;
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
        Workspace& work = workspaces.local();
        folded_moments(blocks[b], work);
        multiply(blocks[b], work);
        store(blocks[b], work, power);
    });
    return power;
}

}

std::vector<double> exact_periodogram(const PointSet& points, int size)
{
    if (size <= 0 || size % 2 != 0) throw std::invalid_argument("exact_periodogram: size must be even and positive");
    if (points.size() == 0) throw std::invalid_argument("exact_periodogram: no points");
    openblas_set_num_threads(1); // the blocks are the parallel work
    return Periodogram(points, size).compute();
}

}
