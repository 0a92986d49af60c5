#include "host/texture/regular/wave_tracking.hpp"

#include "host/texture/regular/wave_spectrum.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <complex>
#include <numbers>
#include <vector>

namespace poissonlab {
namespace {

/// Along each axis; a wave moves by a small part of a period from one to the next.
constexpr int blocks_a_side = 64;

/// Columns or rows of the middle of a picture.
struct PixelRange
{
    int first = 0;
    int count = 0;

    PixelRange(int pixels, double part) : first(static_cast<int>(pixels * (1 - part) / 2)), count(pixels - 2 * first) {}

    int block_begin(int block) const { return first + count * block / blocks_a_side; }
    double weight(int at) const { return 0.5 - 0.5 * std::cos(2 * std::numbers::pi * (at - first + 0.5) / count); }
};

/// Sums of a block, weighted by the window of von Hann over all blocks.
struct Block
{
    Place middle; ///< in the picture, in halves of its sides
    double weight = 0, sum = 0, squares = 0;
    std::array<std::complex<double>, wave_harmonics> turned{}, turned_weight{};
};

std::complex<double> turn(double periods) { return std::polar(1.0, -2 * std::numbers::pi * periods); }

class TurnedPicture
{
public:
    TurnedPicture(const LightMap& light, double part, const SeenWave& wave)
        : wave_(wave), blocks_(blocks_a_side * blocks_a_side)
    {
        const PixelRange columns(light.width, part), rows(light.height, part);
        std::vector<double> across;
        for (int x = 0; x < light.width; ++x) across.push_back(columns.weight(x));
        tbb::parallel_for(0, blocks_a_side, [&](int j) {
            for (int y = rows.block_begin(j); y < rows.block_begin(j + 1); ++y)
                for (int i = 0; i < blocks_a_side; ++i)
                    add(light, y, {columns.block_begin(i), columns.block_begin(i + 1)}, rows.weight(y), across,
                        blocks_[static_cast<std::size_t>(j * blocks_a_side + i)]);
            for (int i = 0; i < blocks_a_side; ++i)
                blocks_[static_cast<std::size_t>(j * blocks_a_side + i)].middle = {
                    (columns.block_begin(i) + columns.block_begin(i + 1)) / static_cast<double>(light.width) - 1,
                    (rows.block_begin(j) + rows.block_begin(j + 1)) / static_cast<double>(light.height) - 1};
        });
        for (const Block& block : blocks_) {
            weight_ += block.weight;
            sum_ += block.sum;
            squares_ += block.squares;
        }
    }

    /// The share of the variance of a wave that is nearly the one that the picture was turned by, with its harmonics.
    double share(const SeenWave& wave) const
    {
        const double mean = sum_ / weight_, variance = squares_ / weight_ - mean * mean;
        if (!(variance > 0)) return 0;
        std::array<std::complex<double>, wave_harmonics> sums{};
        for (const Block& block : blocks_) {
            const std::complex<double> further = turn(wave.periods(block.middle) - wave_.periods(block.middle));
            std::complex<double> power = further;
            for (std::size_t k = 0; k < sums.size(); ++k, power *= further)
                sums[k] += power * (block.turned[k] - mean * block.turned_weight[k]);
        }
        double share = 0;
        for (const std::complex<double>& sum : sums) share += 2 * std::norm(sum) / (weight_ * weight_);
        return share / variance;
    }

private:
    void add(const LightMap& light, int y, std::pair<int, int> columns, double weight,
             const std::vector<double>& across, Block& block) const
    {
        const double v = (2 * y + 1.0) / light.height - 1;
        for (int x = columns.first; x < columns.second; ++x) {
            const double its = weight * across[static_cast<std::size_t>(x)], value = light.at(x, y);
            block.weight += its;
            block.sum += its * value;
            block.squares += its * value * value;
            const std::complex<double> once = turn(wave_.periods({(2 * x + 1.0) / light.width - 1, v}));
            double re = once.real(), im = once.imag();
            for (std::size_t k = 0; k < wave_harmonics; ++k) {
                block.turned[k] += std::complex(its * value * re, its * value * im);
                block.turned_weight[k] += std::complex(its * re, its * im);
                const double next = re * once.real() - im * once.imag();
                im = re * once.imag() + im * once.real();
                re = next;
            }
        }
    }

    SeenWave wave_;
    std::vector<Block> blocks_;
    double weight_ = 0, sum_ = 0, squares_ = 0;
};

/// Moves a wave's numbers to where its share is largest, in steps down to a hundredth of a period at the rim of a part.
double refine(SeenWave& wave, const TurnedPicture& picture, double part, bool has_slope)
{
    const SeenWave start = wave;
    const double periods = std::hypot(wave.x, wave.y);
    std::array<int, 4> at{}; // in hundredths: of periods to the east and south, and of the slopes that add as many
    const auto moved = [&](const std::array<int, 4>& to) {
        const auto steps = [&](std::size_t i) { return to[i] * 0.01 / part; };
        SeenWave other = start;
        other.x += steps(0);
        other.y += steps(1);
        other.slope.east += steps(2) / (periods * part);
        other.slope.south += steps(3) / (periods * part);
        return other;
    };
    double best = picture.share(wave);
    for (int step = 32; step > 0;) {
        std::array<int, 4> next = at;
        for (std::size_t i = 0; i < (has_slope ? 4u : 2u); ++i)
            for (const int sign : {1, -1}) {
                std::array<int, 4> to = at;
                to[i] += sign * step;
                if (const double share = picture.share(moved(to)); share > best) {
                    best = share;
                    next = to;
                }
            }
        if (next == at) step /= 2;
        at = next;
    }
    wave = moved(at);
    return best;
}

}

TrackedWave tracked(const LightMap& light, double part, const SeenWave& wave, bool has_slope)
{
    TrackedWave found{wave, 0, 0};
    double first = 0;
    for (bool is_whole = false; !is_whole; part = std::min(1.0, 2 * part)) {
        is_whole = part == 1;
        found.share = refine(found.wave, TurnedPicture(light, part, found.wave), part, has_slope);
        if (first == 0) first = found.share;
    }
    found.kept = first > 0 ? found.share / first : 0;
    return found;
}

}
