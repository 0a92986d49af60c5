// Tapers of regions against sine tapers by numpy, Bessel's zeros, strips in closed form, and integrals by plain
// sums.
#include "analysis/regions/region_tapers.hpp"

#include "analysis/regions/random_in_region.hpp"
#include "base/regions/region_text.hpp"
#include "tests/support/errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <vector>

namespace poissonlab {
namespace {

std::shared_ptr<const FramedRegion> framed_text(const std::string& text)
{
    return std::make_shared<const FramedRegion>(read_region(text), "region");
}

constexpr const char* plate = "rectangle 0 0 4 1";
constexpr const char* bent = "POLYGON ((0 0, 3 0, 3 1, 1 1, 1 3, 0 3, 0 0))";

struct NumpyTaper
{
    double eigenvalue;
    std::array<double, 6> powers;
};

/// The first four sine tapers of `plate`, on 128 x 32 cells, by numpy: eigenvalues of linear elements in closed form,
/// powers by plain sums over points and Gauss's rule of twelve places in each cell.
constexpr std::array<NumpyTaper, 4> numpy_tapers{
    {{41.977661435, {0.140337704359, 0.151049961426, 0.815760467379, 1.5274892165, 1.81611620512, 3.05908651992}},
     {49.3817228234, {0.0262088830086, 0.191417271796, 0.6831657055, 0.779059713257, 1.40659432991, 0.237612431204}},
     {61.7267810119, {0.00979946436922, 0.568171130363, 0.858661267932, 1.13757116145, 0.874775082857, 0.923720660308}},
     {79.0202729403,
      {0.122082959204, 0.0879510030541, 0.000428043977181, 0.969601684152, 0.562827745314, 0.066734360358}}}};
constexpr std::array<std::array<int, 2>, 6> numpy_frequencies{{{0, 1}, {1, 0}, {1, -1}, {2, 3}, {5, -4}, {8, 7}}};
const PointSet ten{2, {0.31, 0.22, 1.05, 0.71, 1.9,  0.4,  2.2,  0.13, 2.75, 0.88,
                       3.3,  0.5,  3.61, 0.07, 0.93, 0.33, 1.47, 0.95, 2.5,  0.52}};

TEST(RegionTapers, OfARectangleAreThoseOfNumpy)
{
    const auto region = framed_text(plate);
    const auto tapers = std::make_shared<const RegionTapers>(*region, 4);
    TaperedPeriodogram exact(region, tapers, 16, true), fast(region, tapers, 16, false);
    const PointSet points = region->framed(ten, "ten");
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(tapers->eigenvalue(k), numpy_tapers[k].eigenvalue, 1e-8 * numpy_tapers[k].eigenvalue);
        HalfSpectrum a, b;
        exact.compute(points, k, a);
        fast.compute(points, k, b);
        for (std::size_t i = 0; i < numpy_frequencies.size(); ++i) {
            const auto [u, v] = numpy_frequencies[i];
            const std::size_t at = static_cast<std::size_t>(u) * 17 + static_cast<std::size_t>(v + 8);
            EXPECT_NEAR(a.power[at], numpy_tapers[k].powers[i], 1e-7) << k << ": " << u << ", " << v;
            EXPECT_NEAR(a.power[at], b.power[at], 1e-5);
        }
    }
}

/// Functions of the grid are a part of all functions that are 0 at the boundary, so that their eigenvalues are above
/// those of the disk; and they have all that is 0 outside a disk which is smaller by two diagonals of cells, nearly, as
/// linear functions are right to (pi step)^2 of a wave.
TEST(RegionTapers, OfADiskHaveTheEigenvaluesOfBesselsZeros)
{
    const auto region = framed_text("disk 5 5 3");
    const RegionTapers tapers(*region, 6);
    const double radius = 1 / std::sqrt(std::numbers::pi), diagonal = std::hypot(tapers.step()[0], tapers.step()[1]);
    const std::array<double, 6> zeros{2.404825557697724, 3.831705970207512, 3.831705970207512,
                                      5.135622301840683, 5.135622301840683, 5.520078110286311};
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_GT(tapers.eigenvalue(k), std::pow(zeros[k] / radius, 2)) << k;
        EXPECT_LT(tapers.eigenvalue(k), std::pow(zeros[k] / (radius - 2 * diagonal), 2)) << k;
    }
}

constexpr std::size_t five = 5;

/// The places of Gauss's rule of two along each axis, in each cell of the grid over `bent`, and tapers there. They are
/// exact for products of two bilinear functions.
struct GaussPlace
{
    std::array<double, 2> place{}; ///< in the frame
    std::array<double, five> tapers{};
};

std::vector<GaussPlace> gauss_places(const RegionTapers& tapers)
{
    const double near = 0.5 - 0.5 / std::sqrt(3.0), step = 1.0 / 128;
    std::vector<GaussPlace> places;
    for (int row = 0; row < 128; ++row)
        for (int column = 0; column < 128; ++column)
            for (const double dy : {near, 1 - near})
                for (const double dx : {near, 1 - near}) {
                    GaussPlace at{{(column + dx) * step, (row + dy) * step}, {}};
                    for (std::size_t k = 0; k < five; ++k) at.tapers[k] = tapers.at(k, at.place);
                    places.push_back(at);
                }
    return places;
}

/// The part of the region's area that a place stands for.
double weight_of_place(const RegionTapers& tapers) { return tapers.step()[0] * tapers.step()[1] / 4; }

TEST(RegionTapers, AreOrthogonalAndZeroOutside)
{
    const auto region = framed_text(bent);
    const RegionTapers tapers(*region, five);
    std::array<std::array<double, five>, five> products{};
    for (const GaussPlace& p : gauss_places(tapers)) {
        if (!region->contains(p.place)) {
            ASSERT_EQ(p.tapers, (std::array<double, five>{}));
        }
        for (std::size_t k = 0; k < five; ++k)
            for (std::size_t l = 0; l < five; ++l)
                products[k][l] += p.tapers[k] * p.tapers[l] * weight_of_place(tapers);
    }
    for (std::size_t k = 0; k < five; ++k)
        for (std::size_t l = 0; l < five; ++l) EXPECT_NEAR(products[k][l], k == l, 1e-9) << k << ", " << l;
}

struct Moments
{
    double mean = 0, square = 0; ///< of a value, of its square
};

/// Expectations of what an independent point adds to the sums of five tapers: g = h(x) exp(-2 pi i f x) - H, which is 0
/// on average.
class PointSums
{
public:
    PointSums(const std::vector<GaussPlace>& places, const RegionTapers& tapers, const std::array<double, 2>& frequency)
    {
        const double weight = weight_of_place(tapers);
        const auto wave = [&](const GaussPlace& p) {
            return std::polar(1.0, -2 * std::numbers::pi * (frequency[0] * p.place[0] + frequency[1] * p.place[1]));
        };
        std::array<Complex, five> transform{}, g{};
        for (const GaussPlace& p : places)
            for (std::size_t k = 0; k < five; ++k) transform[k] += weight * p.tapers[k] * wave(p);
        double inside = 0;
        for (const GaussPlace& p : places) {
            if (p.tapers == std::array<double, five>{}) continue;
            for (std::size_t k = 0; k < five; ++k) g[k] = p.tapers[k] * wave(p) - transform[k];
            add(g, weight);
            inside += weight;
        }
        for (std::size_t k = 0; k < five; ++k) g[k] = -transform[k]; // where tapers are 0
        add(g, 1 - inside);
    }

    /// The moments are those of the mean over tapers of periodograms of n points. To its square, only quadruples of
    /// points add that are two equal pairs or one point four times.
    Moments of_periodograms(double n) const
    {
        Moments moments;
        for (std::size_t k = 0; k < five; ++k) {
            moments.mean += conjugate_[k][k].real() / five;
            for (std::size_t l = 0; l < five; ++l) {
                const double pairs = conjugate_[k][k].real() * conjugate_[l][l].real() + std::norm(conjugate_[k][l]) +
                                     std::norm(product_[k][l]);
                moments.square += ((1 - 1 / n) * pairs + squares_[k][l] / n) / (five * five);
            }
        }
        return moments;
    }

private:
    using Complex = std::complex<double>;

    void add(const std::array<Complex, five>& g, double part)
    {
        for (std::size_t k = 0; k < five; ++k)
            for (std::size_t l = 0; l < five; ++l) {
                product_[k][l] += part * g[k] * g[l];
                conjugate_[k][l] += part * g[k] * std::conj(g[l]);
                squares_[k][l] += part * std::norm(g[k]) * std::norm(g[l]);
            }
    }

    std::array<std::array<Complex, five>, five> product_{}, conjugate_{}; ///< of g of two tapers
    std::array<std::array<double, five>, five> squares_{};                ///< of |g|^2 of two tapers
};

/// Values of independent sets, whose mean differs from what is expected by five of its standard errors at most.
void expect_mean(const std::vector<double>& values, double expected)
{
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    EXPECT_NEAR(mean, expected, 5 * std::sqrt(squares / (n - 1) / n));
}

/// The mean over tapers of random points has the mean and the spread that the tapers' integrals say.
TEST(TaperedPeriodogram, OfRandomPointsHasTheMomentsOfTapers)
{
    const auto region = framed_text(bent);
    constexpr std::size_t sets = 600, n = 50;
    const auto tapers = std::make_shared<const RegionTapers>(*region, five);
    const RandomInRegion random(*region, nullptr);
    TaperedPeriodogram periodogram(region, tapers, 16, false);
    constexpr std::array<std::array<int, 2>, 5> frequencies{{{0, 1}, {1, 0}, {3, -3}, {5, 4}, {8, -7}}};
    std::array<std::vector<double>, frequencies.size()> means, squares;
    for (std::uint32_t set = 0; set < sets; ++set) {
        const PointSet points = random.points(n, set);
        std::array<double, frequencies.size()> mean{};
        for (std::size_t k = 0; k < five; ++k) {
            HalfSpectrum power;
            periodogram.compute(points, k, power);
            for (std::size_t i = 0; i < mean.size(); ++i) {
                const auto [u, v] = frequencies[i];
                mean[i] += power.power[static_cast<std::size_t>(u) * 17 + static_cast<std::size_t>(v + 8)] / five;
            }
        }
        for (std::size_t i = 0; i < mean.size(); ++i) {
            means[i].push_back(mean[i]);
            squares[i].push_back(mean[i] * mean[i]);
        }
    }
    const std::vector<GaussPlace> places = gauss_places(*tapers);
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
        SCOPED_TRACE(i);
        const std::array<double, 2> in_frame{frequencies[i][0] / region->unit_length(),
                                             frequencies[i][1] / region->unit_length()};
        const Moments expected = PointSums(places, *tapers, in_frame).of_periodograms(n);
        expect_mean(means[i], expected.mean);
        expect_mean(squares[i], expected.square);
        if (i > 1) { // 2 is what a single periodogram has
            EXPECT_LT(expected.square, 1.3);
        }
    }
}

/// By SciPy's sparse solvers, on 810 x 20 cells: the integrals of squared gradients of the lowest modes of the
/// stiffness without the potential 1 / u.
constexpr std::array<double, 6> scipy_gradients{403.4839390758374,  407.0295259224583,  407.8209832666549,
                                                409.13946968069297, 410.98410145408536, 413.3536984005087};

TEST(LongTapers, AreThoseOfScipy)
{
    const RegionTapers tapers(*framed_text("rectangle 0 0 40 1"), 6);
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_NEAR(tapers.eigenvalue(k), scipy_gradients[k], 1e-6 * scipy_gradients[k]) << k;
}

/// Along a strip u is the parabola y (1 - y) / 2, and the functions g are cosines. At the ends, where u falls to 0, the
/// cosines begin less than a width late, which shifts their phases. Where the boundary crosses cells, u is off by at
/// most what a diagonal of a cell changes.
void expect_cosines_along(const std::string& text, double angle)
{
    constexpr double length = 400;
    const auto region = framed_text(text);
    const RegionTapers tapers(*region, 4);
    const double cell = std::hypot(tapers.step()[0], tapers.step()[1]) * std::sqrt(length); // in widths
    const double low = angle == 0 ? 0 : -std::sin(angle);                                   // of the box
    for (std::size_t k = 0; k < 4; ++k) {
        const double scale = std::sqrt(30.0) * (k == 0 ? 1 : std::sqrt(2.0)), peak = scale / 4;
        double sign = 0;
        for (double x = 7.3; x < length - 7; x += 3.7)
            for (double y = 0.05; y < 1; y += 0.15) {
                const std::array<double, 2> own{x * std::cos(angle) - y * std::sin(angle) - low,
                                                x * std::sin(angle) + y * std::cos(angle)};
                const double value = tapers.at(k, {own[0] / region->side(), own[1] / region->side()});
                const double turns = static_cast<double>(k) * std::numbers::pi / length;
                const double expected = scale * y * (1 - y) * std::cos(turns * x);
                if (sign == 0) sign = value * expected < 0 ? -1 : 1;
                // A cell from either boundary changes y (1 - y) by 2 cells / (1 - 2 cells), over its peak.
                ASSERT_NEAR(sign * value, expected, peak * (turns * 2 + (angle == 0 ? cell * cell : 4 * cell)))
                    << k << ": " << x << ", " << y;
            }
    }
}

TEST(LongTapers, OfStripsAreParabolasTimesCosines)
{
    expect_cosines_along("rectangle 0 0 400 1", 0);
    const double angle = std::atan2(3.0, 4.0);
    expect_cosines_along("POLYGON ((0 0, 320 240, 319.4 240.8, -0.6 0.8, 0 0))", angle);
}

constexpr const char* winding = "LINESTRING (0 0, 20 3, 40 -8, 60 1, 90 0, 88 20, 40 22)";

/// A road half a unit wide to either side.
std::shared_ptr<const FramedRegion> framed_road()
{
    RegionReading reading;
    reading.buffer = 0.5;
    return std::make_shared<const FramedRegion>(read_region(winding, reading), "road");
}

TEST(LongTapers, OfARoadAreOrthogonalAndCoverIt)
{
    const auto region = framed_road();
    const RegionTapers tapers(*region, five);
    const std::array<double, 2> step{tapers.step()[0] * tapers.unit_length(), tapers.step()[1] * tapers.unit_length()};
    std::array<std::array<double, five>, five> products{};
    const double near = 0.5 - 0.5 / std::sqrt(3.0), weight = tapers.step()[0] * tapers.step()[1] / 4;
    double fourth = 0;
    for (double y = 0; y < 1; y += step[1])
        for (double x = 0; x < 1; x += step[0])
            for (const double dy : {near, 1 - near})
                for (const double dx : {near, 1 - near}) {
                    const std::array<double, 2> place{x + dx * step[0], y + dy * step[1]};
                    std::array<double, five> at;
                    double squares = 0;
                    for (std::size_t k = 0; k < five; ++k) {
                        at[k] = tapers.at(k, place);
                        squares += at[k] * at[k] / five;
                    }
                    if (squares == 0) continue;
                    ASSERT_TRUE(region->contains(place));
                    fourth += weight * squares * squares;
                    for (std::size_t k = 0; k < five; ++k)
                        for (std::size_t l = 0; l < five; ++l) products[k][l] += weight * at[k] * at[l];
                }
    for (std::size_t k = 0; k < five; ++k)
        for (std::size_t l = 0; l < five; ++l) EXPECT_NEAR(products[k][l], k == l, 1e-9) << k << ", " << l;
    // The mean square of a parabola across and 1 along has an effective part of 0.7 of a strip; with cosines it is
    // smaller.
    EXPECT_GT(1 / fourth, 0.5);
    EXPECT_LT(1 / fourth, 0.7);
}

TEST(LongTapers, OfTwoIslandsFarApartCoverBoth)
{
    const auto region =
        framed_text("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((900 800, 901 800, 900 801, 900 800)))");
    const RegionTapers tapers(*region, 2);
    const PointSet nodes = tapers.nodes();
    std::array<double, 2> squares{};
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t k = 0; k < 2; ++k) squares[nodes[i][0] > 0.5] += tapers.values(k)[i] * tapers.values(k)[i] / 2;
    EXPECT_NEAR(squares[0] / squares[1], 1, 0.1); // sums over nodes instead of integrals
}

TEST(LongTapers, AreRefusedWhereTheyWouldLeaveIslandsOut)
{
    const auto region =
        framed_text("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((900 800, 901 800, 900 801, 900 800)), "
                    "((0 500, 1 500, 1 501, 0 501, 0 500)))");
    try {
        const RegionTapers tapers(*region, 2);
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "the region has 3 parts that are apart from each other: tapers must be at least as "
                                   "many, not 2");
    }
    EXPECT_EQ(RegionTapers(*region, 3).count(), 3U);
    const auto far = framed_text("MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((9e6 9e6, 9000001 9e6, 9e6 9000001, "
                                 "9e6 9e6)))");
    EXPECT_THROW(RegionTapers(*far, 2), InputError);
}

/// Random points have the power 1 - |H|^2 on average, and H is nearly 0 beyond some 4 / width.
TEST(LongTapers, GiveRandomPointsThePowerOne)
{
    const auto region = framed_road();
    const auto tapers = std::make_shared<const RegionTapers>(*region, five);
    const RandomInRegion random(*region, nullptr);
    constexpr int size = 256;
    TaperedPeriodogram periodogram(region, tapers, size, false);
    std::vector<double> means;
    HalfSpectrum power;
    for (std::uint32_t set = 0; set < 20; ++set) {
        double sum = 0, count = 0;
        for (std::size_t k = 0; k < five; ++k) {
            periodogram.compute(random.points(400, set), k, power);
            for (int u = 60; u <= size / 2; ++u)
                for (int v = -size / 2; v <= size / 2; ++v, ++count)
                    sum +=
                        power.power[static_cast<std::size_t>(u) * (size + 1) + static_cast<std::size_t>(v + size / 2)];
        }
        means.push_back(sum / count);
    }
    expect_mean(means, 1);
}

TEST(RegionTapers, NeedRoom)
{
    const auto thin = framed_text("POLYGON ((0 0, 0.000001 0, 1 1, 0.999999 1, 0 0))");
    EXPECT_THAT(message_of([&] { RegionTapers(*thin, 9); }), testing::HasSubstr("too thin for 9 tapers"));
}

}
}
