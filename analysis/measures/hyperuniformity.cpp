#include "analysis/measures/hyperuniformity.hpp"

#include "analysis/spectra/frequency_power.hpp"
#include "base/random/random_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace poissonlab {
namespace {

constexpr double part_of_tile_frequency = 0.4;
constexpr double most_tested_2d = 16, most_tested_3d = 6;
constexpr std::size_t least_shells = 3;
constexpr int draws = 9999;

/// Calls visit(f) for one of each two opposite frequencies along x, y and z of at most `reach` each.
template <class Visit>
void for_each_pair(int dimension, int reach, const Visit& visit)
{
    const int slices = dimension == 3 ? reach : 0;
    for (int w = 0; w <= slices; ++w)
        for (int v = w > 0 ? -reach : 0; v <= reach; ++v)
            for (int u = w > 0 || v > 0 ? -reach : 1; u <= reach; ++u) visit(std::array{u, v, w});
}

/// The shells of a spectrum, or of a half of one.
std::vector<PowerShell> shells_in(const auto& spectrum, const FrequencyRange& range)
{
    const double end = std::min(range.end, spectrum.size / 2 - 1.0);
    if (end < 1) return {};
    const auto most = static_cast<std::size_t>(end * end);
    std::vector<PowerShell> all(most + 1);
    for_each_pair(spectrum.dimension, static_cast<int>(end), [&](const std::array<int, 3>& f) {
        const auto squared =
            static_cast<std::size_t>(std::int64_t{f[0]} * f[0] + std::int64_t{f[1]} * f[1] + std::int64_t{f[2]} * f[2]);
        if (squared > most) return;
        all[squared].power += frequency_power(spectrum, f);
        ++all[squared].pairs;
    });
    std::vector<PowerShell> shells;
    for (std::size_t squared = 1; squared <= most; ++squared) {
        const double frequency = std::sqrt(static_cast<double>(squared));
        const PowerShell& shell = all[squared];
        if (shell.pairs > 0 && frequency >= range.begin)
            shells.push_back({frequency, shell.power / static_cast<double>(shell.pairs), shell.pairs});
    }
    return shells;
}

/// The same shells with no power below `least`; empty where there is nothing to measure.
std::vector<PowerShell> shells_above(std::vector<PowerShell> shells, double least)
{
    const auto empty = std::ranges::count_if(shells, [&](const PowerShell& shell) { return !(shell.power > least); });
    if (shells.size() < least_shells || 2 * static_cast<std::size_t>(empty) > shells.size()) return {};
    for (PowerShell& shell : shells) shell.power = std::max(shell.power, least);
    return shells;
}

/// The shells without the longest beginning of which half or more have no power above `least`. Where power goes down
/// to rounding, its curve ends: shells below would have it level out.
std::vector<PowerShell> shells_above_rounding(std::vector<PowerShell> shells, double least)
{
    std::size_t begin = 0, empty = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        empty += !(shells[i].power > least);
        if (2 * empty > i) begin = i + 1;
    }
    shells.erase(shells.begin(), shells.begin() + static_cast<std::ptrdiff_t>(begin));
    return shells_above(std::move(shells), least);
}

double total_pairs(const std::vector<PowerShell>& shells)
{
    double pairs = 0;
    for (const PowerShell& shell : shells) pairs += static_cast<double>(shell.pairs);
    return pairs;
}

/// The logarithms of the shells' frequencies, less their mean over pairs.
std::vector<double> centred_logarithms(const std::vector<PowerShell>& shells)
{
    double mean = 0;
    for (const PowerShell& shell : shells) mean += static_cast<double>(shell.pairs) * std::log(shell.frequency);
    mean /= total_pairs(shells);
    std::vector<double> x;
    for (const PowerShell& shell : shells) x.push_back(std::log(shell.frequency) - mean);
    return x;
}

/// Moments of x where shell i weighs pairs P exp(-b x).
struct Tilted
{
    double weight = 0, mean = 0, variance = 0;
};

Tilted tilted(const std::vector<PowerShell>& shells, const std::vector<double>& x, double b)
{
    Tilted t;
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        const double weight = static_cast<double>(shells[i].pairs) * shells[i].power * std::exp(-b * x[i]);
        t.weight += weight;
        sum += weight * x[i];
        squares += weight * x[i] * x[i];
    }
    t.mean = sum / t.weight;
    t.variance = squares / t.weight - t.mean * t.mean;
    return t;
}

/// The b for which the tilted mean is 0: it falls as b grows. Newton's steps, halved intervals where they leave them.
double root_of_tilt(const std::vector<PowerShell>& shells, const std::vector<double>& x)
{
    double low = -50, high = 50, b = 0;
    for (int step = 0; step < 100 && high - low > 1e-12; ++step) {
        const Tilted t = tilted(shells, x, b);
        (t.mean > 0 ? low : high) = b;
        const double next = b + t.mean / t.variance;
        const double to = next > low && next < high ? next : (low + high) / 2;
        if (std::abs(to - b) < 1e-12) break;
        b = to;
    }
    return b;
}

/// The likelihood ratio over a fixed list of s / t, for shells with the same frequencies.
class RatioTest
{
    static constexpr int models = 65;
    using PerModel = std::array<double, models>;

public:
    RatioTest(const std::vector<PowerShell>& shells, int realizations)
        : pairs_(total_pairs(shells)), realizations_(realizations), weights_(shells.size())
    {
        constexpr double step = 1.2;
        const double unit = shells.back().frequency * shells.back().frequency;
        for (int m = 0; m < models; ++m) {
            const double s = m == 0 ? 0 : std::pow(step, m - models + 1);
            for (std::size_t i = 0; i < shells.size(); ++i) {
                const double power = s + (1 - s) * shells[i].frequency * shells[i].frequency / unit;
                const auto n = static_cast<double>(shells[i].pairs);
                weights_[i][m] = n / power / pairs_;
                logarithms_[m] += n * std::log(power);
            }
        }
    }

    /// T of powers in the order of the shells.
    double statistic(const std::vector<double>& power) const { return statistic(scales(power)); }

    /// It tells of many powers whether their T is `found` or more.
    class Reaches
    {
    public:
        Reaches(const RatioTest& test, double found) : test_(test), found_(found)
        {
            const double needed = found / (2 * test.realizations_);
            for (int m = 0; m < models; ++m)
                parts_[m] = std::exp((test.logarithms_[0] - test.logarithms_[m] - needed) / test.pairs_);
        }

        /// A model reaches it whose best scale is at most a part of the first model's. Logarithms take most of the time
        /// and are left to the cases that rounding could decide, which moves that part by far less than `rounding`.
        bool operator()(const std::vector<double>& power) const
        {
            constexpr double rounding = 1e-9;
            const PerModel scale = test_.scales(power);
            bool is_near = false;
            for (int m = 0; m < models; ++m) {
                const double most = parts_[m] * scale[0];
                if (scale[m] < (1 - rounding) * most) return true;
                is_near = is_near || scale[m] <= (1 + rounding) * most;
            }
            return is_near && test_.statistic(scale) >= found_;
        }

    private:
        const RatioTest& test_;
        double found_;
        PerModel parts_{};
    };

private:
    /// The best scale of each model, of one realization.
    PerModel scales(const std::vector<double>& power) const
    {
        PerModel scale{};
        for (std::size_t i = 0; i < power.size(); ++i)
            for (int m = 0; m < models; ++m) scale[m] += weights_[i][m] * power[i];
        return scale;
    }

    double statistic(const PerModel& scale) const
    {
        const double without = log_likelihood(0, scale);
        double best = without;
        for (int m = 1; m < models; ++m) best = std::max(best, log_likelihood(m, scale));
        return 2 * realizations_ * (best - without);
    }

    /// Returns the logarithm of the likelihood of one realization.
    double log_likelihood(int m, const PerModel& scale) const { return -pairs_ * std::log(scale[m]) - logarithms_[m]; }

    double pairs_;
    int realizations_;
    std::vector<PerModel> weights_; ///< of each shell: pairs / model / all pairs
    PerModel logarithms_{};         ///< the sum of pairs ln model
};

double uniform(RandomWords& words) { return (words.next() + 0.5) * 0x1p-32; }

double normal(RandomWords& words)
{
    const double radius = std::sqrt(-2 * std::log(uniform(words)));
    return radius * std::cos(2 * std::numbers::pi * uniform(words));
}

/// A gamma variable of mean 1 and a shape of at least 1. Marsaglia and Tsang, A simple method for generating gamma
/// variables, ACM TOMS 26(3), 2000.
double gamma_of_mean_1(RandomWords& words, double shape)
{
    const double d = shape - 1.0 / 3, c = 1 / std::sqrt(9 * d);
    for (;;) {
        const double x = normal(words), root = 1 + c * x;
        if (root <= 0) continue;
        const double v = root * root * root, chance = uniform(words), squared = x * x;
        // Theirs, which spares two logarithms in nine of ten cases: the exact bound is above this one.
        if (chance < 1 - 0.0331 * squared * squared) return d * v / shape;
        if (std::log(chance) < 0.5 * squared + d * (1 - v + std::log(v))) return d * v / shape;
    }
}

std::vector<double> powers_of(const std::vector<PowerShell>& shells)
{
    std::vector<double> powers;
    for (const PowerShell& shell : shells) powers.push_back(shell.power);
    return powers;
}

}

std::vector<PowerShell> power_shells(const Spectrum& spectrum, const FrequencyRange& range)
{
    return shells_in(spectrum, range);
}

std::vector<PowerShell> power_shells(const HalfSpectrum& periodogram, const FrequencyRange& range)
{
    return shells_in(periodogram, range);
}

FrequencyRange hyperuniform_range(std::size_t points, int dimension, int tiles)
{
    FrequencyRange range = low_frequency_range(points, dimension);
    if (tiles > 0) range.end = std::min(range.end, part_of_tile_frequency * tiles);
    return range;
}

FrequencyRange hyperuniformity_test_range(std::size_t points, int dimension, int tiles)
{
    FrequencyRange range = hyperuniform_range(points, dimension, tiles);
    range.end = std::min(range.end / 2, dimension == 3 ? most_tested_3d : most_tested_2d);
    return range;
}

std::optional<HyperuniformityExponent> hyperuniformity_exponent(const std::vector<PowerShell>& measured,
                                                                int realizations, double least)
{
    const std::vector<PowerShell> shells = shells_above_rounding(measured, least);
    if (shells.empty()) return std::nullopt;
    const std::vector<double> x = centred_logarithms(shells);
    HyperuniformityExponent exponent{root_of_tilt(shells, x), 0};

    const double pairs = total_pairs(shells);
    const double scale = tilted(shells, x, exponent.value).weight / pairs;
    double information = 0, scatter = 0;
    for (std::size_t i = 0; i < shells.size(); ++i) {
        const double samples = realizations * static_cast<double>(shells[i].pairs);
        const double deviation = shells[i].power / (scale * std::exp(exponent.value * x[i])) - 1;
        information += samples * x[i] * x[i];
        scatter += samples * deviation * deviation;
    }
    const double excess = std::max(1.0, scatter / static_cast<double>(shells.size() - 2));
    exponent.standard_error = std::sqrt(excess / information);
    return exponent;
}

double hyperuniformity_statistic(const std::vector<PowerShell>& shells, int realizations)
{
    return RatioTest(shells, realizations).statistic(powers_of(shells));
}

std::optional<double> hyperuniformity_p_value(const std::vector<PowerShell>& measured, int realizations, double least)
{
    const std::vector<PowerShell> shells = shells_above(measured, least);
    if (shells.empty()) return std::nullopt;
    const RatioTest test(shells, realizations);
    const double found = test.statistic(powers_of(shells));
    if (found == 0) return 1; // as large as the least that there is
    const RatioTest::Reaches reaches(test, found);
    RandomWords words(stream_key(0, Purpose::hyperuniformity_test, 0), 0);
    std::vector<double> power(shells.size());
    int as_large = 1;
    for (int draw = 0; draw < draws; ++draw) {
        for (std::size_t i = 0; i < shells.size(); ++i)
            power[i] = shells[i].frequency * shells[i].frequency *
                       gamma_of_mean_1(words, realizations * static_cast<double>(shells[i].pairs));
        if (reaches(power)) ++as_large;
    }
    return as_large / (draws + 1.0);
}

}
