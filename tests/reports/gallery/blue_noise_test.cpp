// The verdict on blue noise agrees with the field's on all methods of the gallery.
#include "reports/gallery/gallery.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <numbers>

namespace poissonlab {
namespace {

/// The ring of the largest anisotropy. The tables have no numbers of samples: rings have as many as their area.
PeakAnisotropy peak_of(const Curve& curve)
{
    PeakAnisotropy peak{-99, 0, 1};
    for (const RadialBin& bin : curve.bins) {
        const double f = bin.frequency;
        const double samples = curve.dimension == 2 ? 2 * std::numbers::pi * f : 4 * std::numbers::pi * f * f;
        if (samples < 100 || bin.power < least_peak_power || bin.anisotropy_db <= peak.db) continue;
        peak = {bin.anisotropy_db, f, static_cast<std::size_t>(samples), {}, bin.power};
    }
    return peak;
}

Series series_of(const GalleryMethod& method)
{
    Series series;
    series.points = method.curve.points;
    series.realizations = method.curve.periodograms;
    series.spectrum_size = method.curve.dimension == 2 ? 1024 : 256;
    series.measures.numbers = method.measures;
    series.measures.peak_anisotropy = peak_of(method.curve);
    return series;
}

/// By the names of samplers. Sequences and tiles that are not listed are blue noise with peaks or directions: weakly.
std::string expected(const GalleryMethod& method)
{
    static const std::map<std::string, std::string> answers{{"random", "no"},
                                                            {"regular", "no"},
                                                            {"hexagonal", "no"},
                                                            {"jittered", "weakly"},
                                                            {"sobol", "weakly"},
                                                            {"halton", "weakly"},
                                                            {"best-candidate", "weakly"},
                                                            {"bridson", "yes"},
                                                            {"dart-throwing", "yes"},
                                                            {"relaxation-dart-throwing", "yes"},
                                                            {"voronoi-darts", "yes"},
                                                            {"sector-darts", "yes"},
                                                            {"lloyd", "yes"},
                                                            {"sample-elimination", "yes"},
                                                            {"gaussian-blue-noise", "yes"},
                                                            {"equal-areas", "yes"},
                                                            {"target-spectrum", "yes"},
                                                            {"farthest-point", "yes"}};
    const std::map<std::string, std::string> others{
        {"sobol-scrambling-none", "no"},          // nets without scrambling have spikes
        {"halton-scrambling-none", "no"},         //
        {"polyominoes-variant-P", "no"},          // one table of vectors, whose spectrum has spikes
        {"polyominoes-variant-G", "no"},          //
        {"isohedral-tiles", "no"},                // a tile repeats
        {"hat-tiles", "no"},                      // long-range order, whose peaks grow with the window
        {"spectre-tiles", "no"},                  //
        {"dodecagonal", "no"},                    //
        {"template-tiles-T-64-sets-10", "no"},    // spikes of 92 times the power around
        {"shade-tiles-sets-10", "no"},            //
        {"averaged-tiles-sets-10", "no"},         //
        {"dart-throwing-rho-0.65-3d", "weakly"},  // far from saturated, whose radius is 0.80: 16 % and
        {"dart-throwing-rho-0.70-3d", "weakly"}}; // 10.2 ± 0.1 % of the noise of random points
    if (const auto found = others.find(method.name); found != others.end()) return found->second;
    const auto found = answers.find(method.sampler);
    return found == answers.end() ? "weakly" : found->second;
}

TEST(BlueNoiseVerdict, AgreesWithTheFieldOnTheGallery)
{
    std::map<std::string, int> count;
    for (const GalleryMethod& method : reference_gallery()) {
        const auto verdict = blue_noise_verdict(series_of(method), method.curve.dimension);
        ASSERT_TRUE(verdict) << method.name;
        EXPECT_EQ(verdict->answer, expected(method)) << method.name << ": " << verdict->words();
        ++count[verdict->answer];
    }
    for (const char* answer : {"yes", "weakly", "no"}) EXPECT_GE(count[answer], 5) << answer;
}

Series small_series(double low, double nearest, std::size_t points = 1024)
{
    Series series;
    series.points = points;
    series.realizations = 1;
    series.spectrum_size = 256;
    series.measures.numbers["low_frequency_mean"] = {low, {}};
    series.measures.numbers["mean_nearest_distance"] = {nearest, {}};
    series.measures.numbers["effective_nyquist"] = {0.3, {}};
    series.measures.numbers["anisotropy_above_chance"] = {0, {}};
    series.measures.peak_anisotropy = PeakAnisotropy{0, 30, 200};
    return series;
}

std::string answer(const Series& series) { return blue_noise_verdict(series, 2)->answer; }

TEST(BlueNoiseVerdict, TakesTheErrorOfFewFrequenciesIntoAccount)
{
    // 16 points have pi / 2 pairs of frequencies up to root N / 4, 1,024 have 100: two errors are 1.6 and 0.2 of them.
    EXPECT_EQ(answer(small_series(0.3, 0.8, 1024)), "weakly");
    EXPECT_EQ(answer(small_series(0.3, 0.8, 16)), "no");
    EXPECT_EQ(answer(small_series(0.13, 0.8, 1024)), "weakly");
    EXPECT_EQ(answer(small_series(0.115, 0.8, 1024)), "yes");
    EXPECT_EQ(answer(small_series(0.05, 0.6, 1024)), "weakly");
}

TEST(BlueNoiseVerdict, TrustsErrorsOfFewSetsNoMoreThanThatOfExponentialPowers)
{
    for (const int sets : {2, 3, 4}) {
        Series series = small_series(0.3, 0.8, 16);
        series.realizations = sets;
        series.measures.numbers["low_frequency_mean"].standard_error = 1e-6;
        EXPECT_EQ(answer(series), sets < 4 ? "no" : "weakly") << sets;
    }
}

TEST(BlueNoiseVerdict, SpikesHavePower)
{
    Series series = small_series(0.05, 0.8);
    series.measures.numbers["anisotropy_above_chance"] = {15, {}};
    for (const double power : {0.02, 0.9, 1.1, 50.0}) { // 200 / (1 + 100) frequencies hold the power of 200
        series.measures.peak_anisotropy = PeakAnisotropy{20, 30, 200, {}, power};
        EXPECT_EQ(answer(series), power * 101 > 4 ? "no" : "weakly") << power;
    }
}

TEST(BlueNoiseVerdict, IsUnknownWhereABoundaryOrTapersHideWhatIsAsked)
{
    Series series = small_series(0.05, 0.8, 3000);
    RegionResult& region = series.region.emplace();
    region.area = 1;
    for (const double width : {6.0, 7.0}) { // of a strip, in mean distances: 0.3 is 2 / 6.7
        region.perimeter = 2 / width * std::sqrt(3000);
        EXPECT_EQ(answer(series), width < 6.6 ? "unknown" : "yes") << width;
    }
    region.tapers = 8;
    series.measures.numbers.erase("anisotropy_above_chance");
    EXPECT_EQ(answer(series), "unknown");
    series.measures.numbers["low_frequency_mean"].value = 1;
    EXPECT_EQ(answer(series), "no");
    region.perimeter = 2 / 6.0 * std::sqrt(3000); // narrow regions blur the spectra of tapers as well
    EXPECT_EQ(answer(series), "unknown");
}

TEST(BlueNoiseVerdict, IsUnknownWhereTheSpectrumIsNotTheSets)
{
    Series window = small_series(0.05, 0.8);
    window.is_window = true;
    EXPECT_EQ(answer(window), "unknown");
    Series early = small_series(0.05, 0.8);
    early.spectrum_size = 64; // ends at root N
    early.measures.peak_anisotropy.reset();
    EXPECT_EQ(answer(early), "unknown");
    EXPECT_THAT(short_spectrum_words(early, 2), testing::HasSubstr("They need spectrum_size = 256 or more."));
    EXPECT_EQ(short_spectrum_words(small_series(0.05, 0.8), 2), "");
    Series followed = small_series(0.05, 0.8);
    followed.region.emplace().has_density = true;
    EXPECT_FALSE(blue_noise_verdict(followed, 2));
    EXPECT_FALSE(blue_noise_verdict(Series{}, 2));
}

}
}
