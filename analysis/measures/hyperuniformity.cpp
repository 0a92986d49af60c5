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
constexpr double of_one_length = 1e-9; ///< as a share of a frequency

/// Calls visit(f) for one of each two opposite frequencies along x, y and z of at most `reach` along each.
template <class Visit>
void for_each_pair(const std::array<int, 3>& reach, const Visit& visit)
{
    for (int w = 0; w <= reach[2]; ++w)
        for (int v = w > 0 ? -reach[1] : 0; v <= reach[1]; ++v)
            for (int u = w > 0 || v > 0 ? -reach[0] : 1; u <= reach[0]; ++u) visit(std::array{u, v, w});
}

/// The shells of a range in a box: of frequencies whose lengths differ by no more than rounding.
std::vector<PowerShell> shells_in_box(const auto& spectrum, const FrequencyRange& range)
{
    const auto& sides = spectrum.box.sides;
    const double end = std::min(range.end, (spectrum.size / 2 - 1.0) / spectrum.box.longest());
    std::array<int, 3> reach{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(spectrum.dimension); ++k)
        reach[k] = static_cast<int>(end * sides[k]);
    std::vector<PowerShell> samples;
    for_each_pair(reach, [&](const std::array<int, 3>& f) {
        const double length = std::hypot(f[0] / sides[0], f[1] / sides[1], f[2] / sides[2]);
        if (length >= range.begin && length <= end) samples.push_back({length, frequency_power(spectrum, f), 1});
    });
    std::ranges::stable_sort(samples, {}, &PowerShell::frequency);
    std::vector<PowerShell> shells;
    for (const PowerShell& sample : samples) {
        if (shells.empty() || sample.frequency > shells.back().frequency * (1 + of_one_length))
            shells.push_back({sample.frequency, 0, 0});
        shells.back().power += sample.power;
        ++shells.back().pairs;
    }
    for (PowerShell& shell : shells) shell.power /= static_cast<double>(shell.pairs);
    return shells;
}

/// The shells of a range in a spectrum, or in a half of one.
std::vector<PowerShell> shells_in(const auto& spectrum, const FrequencyRange& range)
{
    if (!spectrum.box.is_unit()) return shells_in_box(spectrum, range);
    const double end = std::min(range.end, spectrum.size / 2 - 1.0);
    if (end < 1) return {};
    const auto most = static_cast<std::size_t>(end * end);
    std::vector<PowerShell> all(most + 1);
    const int reach = static_cast<int>(end);
    for_each_pair({reach, reach, spectrum.dimension == 3 ? reach : 0}, [&](const std::array<int, 3>& f) {
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

/// Raises powers below `least` to it. Returns no shells where they are too few to fit, or where most have no more than
/// `least`.
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

/// The likelihood ratio over a fixed list of s / t and c, for shells with the same frequencies.
class RatioTest
{
    static constexpr int ratios = 33, curvatures = 8, models = ratios * curvatures;
    static constexpr int models_at_once = 12; ///< whose sums fit into registers
    static_assert(models % models_at_once == 0);
    using PerModel = std::array<double, models>;
    using Some = std::array<double, models_at_once>;

public:
    RatioTest(const std::vector<PowerShell>& shells, int realizations)
        : samples_(realizations * total_pairs(shells)), weights_(shells.size() * (models / models_at_once))
    {
        for (int m = 0; m < models; ++m) {
            const double s = ratio(m);
            double logarithms = 0;
            std::vector<double> power;
            for (const PowerShell& shell : shells) {
                power.push_back(s + (1 - s) * hyperuniform_power(shells, shell, m));
                logarithms += static_cast<double>(shell.pairs) * std::log(power.back());
            }
            const double pairs = total_pairs(shells), factor = std::exp(logarithms / pairs) / pairs;
            for (std::size_t i = 0; i < shells.size(); ++i)
                weights_[static_cast<std::size_t>(m / models_at_once) * shells.size() + i][m % models_at_once] =
                    static_cast<double>(shells[i].pairs) / power[i] * factor;
        }
    }

    /// T of powers in the order of the shells.
    double statistic(const std::vector<double>& power) const
    {
        const PerModel misfit = misfits(power);
        return 2 * samples_ * std::log(misfit[best_hyperuniform(misfit)] / *std::ranges::min_element(misfit));
    }

    /// The powers of the hyperuniform model that is most likely, but for a factor.
    std::vector<double> hyperuniform_powers(const std::vector<PowerShell>& shells,
                                            const std::vector<double>& power) const
    {
        const std::size_t best = best_hyperuniform(misfits(power));
        std::vector<double> powers;
        for (const PowerShell& shell : shells)
            powers.push_back(hyperuniform_power(shells, shell, static_cast<int>(best)));
        return powers;
    }

private:
    /// s / (s + t) of the list, where frequencies are in units of the range's end: 0 comes first.
    static double ratio(int model)
    {
        constexpr double step = 1.44;
        return model % ratios == 0 ? 0 : std::pow(step, model % ratios - ratios + 1);
    }

    /// f^2 exp(-c f^2), with f in units of the range's end.
    static double hyperuniform_power(const std::vector<PowerShell>& shells, const PowerShell& shell, int model)
    {
        const double root = 0.1 * (model / ratios), squared = std::pow(shell.frequency / shells.back().frequency, 2);
        return squared * std::exp(-root * root * squared);
    }

    /// The most that each model's likelihood can be with the best factor for it, as exp(-L / samples).
    PerModel misfits(const std::vector<double>& power) const
    {
        PerModel misfit;
        const Some* weights = weights_.data();
        for (int first = 0; first < models; first += models_at_once, weights += power.size()) {
            Some sums{};
            for (std::size_t i = 0; i < power.size(); ++i)
                for (int m = 0; m < models_at_once; ++m) sums[m] += weights[i][m] * power[i];
            std::ranges::copy(sums, misfit.begin() + first);
        }
        return misfit;
    }

    static std::size_t best_hyperuniform(const PerModel& misfit)
    {
        std::size_t best = 0;
        for (std::size_t m = 0; m < models; m += ratios)
            if (misfit[m] < misfit[best]) best = m;
        return best;
    }

    double samples_;            ///< pairs of all realizations
    std::vector<Some> weights_; ///< of some models after others, of each shell: what its power adds to their misfits
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

}

std::vector<PowerShell> power_shells(const Spectrum& spectrum, const FrequencyRange& range)
{
    return shells_in(spectrum, range);
}

std::vector<PowerShell> power_shells(const HalfSpectrum& periodogram, const FrequencyRange& range)
{
    return shells_in(periodogram, range);
}

std::vector<double> powers_of(const std::vector<PowerShell>& shells)
{
    std::vector<double> powers;
    for (const PowerShell& shell : shells) powers.push_back(shell.power);
    return powers;
}

FrequencyRange hyperuniform_range(std::size_t points, int dimension, int tiles, const PeriodicBox& box)
{
    FrequencyRange range = low_frequency_range(points, dimension);
    if (!box.is_unit()) range.begin = (1 - of_one_length) / box.longest();
    if (tiles > 0) range.end = std::min(range.end, part_of_tile_frequency * tiles);
    return range;
}

FrequencyRange hyperuniformity_test_range(std::size_t points, int dimension, int tiles, const PeriodicBox& box)
{
    FrequencyRange range = hyperuniform_range(points, dimension, tiles, box);
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
    const std::vector<double> powers = powers_of(shells), mean = test.hyperuniform_powers(shells, powers);
    const double found = test.statistic(powers);
    if (found == 0) return 1; // as large as the least that there is
    RandomWords words(stream_key(0, Purpose::hyperuniformity_test, 0), 0);
    std::vector<double> power(shells.size());
    int as_large = 1;
    for (int draw = 0; draw < draws; ++draw) {
        for (std::size_t i = 0; i < shells.size(); ++i)
            power[i] = mean[i] * gamma_of_mean_1(words, realizations * static_cast<double>(shells[i].pairs));
        if (test.statistic(power) >= found) ++as_large;
    }
    return as_large / (draws + 1.0);
}

}
