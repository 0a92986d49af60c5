// `poissonlab analyze` of sets in periodic rectangles and boxes.
#include "tests/support/program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <vector>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::Not;

using Places = std::vector<std::array<double, 3>>;

class PeriodicBoxCommand : public testing::Test
{
protected:
    /// Random points of a box, written with their own coordinates.
    void write(const char* name, const std::vector<double>& sides, std::size_t points, const std::string& head = {})
    {
        std::mt19937_64 random(7);
        std::string text = head;
        places_.assign(points, {});
        for (auto& place : places_) {
            for (std::size_t k = 0; k < sides.size(); ++k) {
                place[k] = std::uniform_real_distribution<double>(0, sides[k])(random);
                text += fmt::format("{} ", place[k]);
            }
            text += "\n";
        }
        folder_.write(name, text);
    }

    Outcome analyze(const char* file, std::vector<std::string> more) const
    {
        std::vector<std::string> words{"analyze", file, "--out", "o", "--label", "set"};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(folder_.path(), words);
    }

    nlohmann::json series() const
    {
        return nlohmann::json::parse(content_of(folder_.path() / "o/results.json"))["series"][0];
    }

    std::string stored(const char* file) const { return content_of(folder_.path() / "o/set" / file); }

    /// The power in rings one wide by the sum over points, in cycles per root of the box's area.
    std::map<long, std::pair<double, int>> direct_rings(const std::vector<double>& sides, int most) const
    {
        std::map<long, std::pair<double, int>> rings;
        const double root = std::sqrt(sides[0] * sides[1]);
        for (int v = -most; v <= most; ++v)
            for (int u = -most; u <= most; ++u) {
                std::complex<double> sum;
                for (const auto& place : places_)
                    sum += std::polar(1.0, -2 * std::numbers::pi * (u * place[0] / sides[0] + v * place[1] / sides[1]));
                auto& [power, samples] = rings[std::lround(root * std::hypot(u / sides[0], v / sides[1]))];
                power += std::norm(sum) / static_cast<double>(places_.size());
                ++samples;
            }
        return rings;
    }

    TemporaryFolder folder_;
    Places places_;
};

TEST_F(PeriodicBoxCommand, MeasuresOnTheBoxsOwnFrequencies)
{
    write("set.txt", {6, 2}, 120);
    const Outcome outcome = analyze("set.txt", {"--domain", "0:6 0:2"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    auto rings = direct_rings({6, 2}, 45);
    std::istringstream rows(stored("radial.csv"));
    std::string row;
    std::getline(rows, row);
    int seen = 0;
    for (; std::getline(rows, row) && seen < 20; ++seen) {
        double frequency = 0, power = 0, anisotropy = 0;
        int samples = 0;
        ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf,%d", &frequency, &power, &anisotropy, &samples), 4) << row;
        EXPECT_EQ(samples, rings[std::lround(frequency)].second) << frequency;
        EXPECT_NEAR(power, rings[std::lround(frequency)].first / samples, 1e-6 * power) << frequency;
    }
    EXPECT_EQ(seen, 20);

    double least = 10; // in the units of the file
    for (std::size_t i = 0; i < places_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const double x = std::abs(places_[i][0] - places_[j][0]), y = std::abs(places_[i][1] - places_[j][1]);
            least = std::min(least, std::hypot(std::min(x, 6 - x), std::min(y, 2 - y)));
        }
    const auto json = series();
    EXPECT_NEAR(json["min_distance"]["min"].get<double>() * std::sqrt(12), least, 1e-7);
    EXPECT_EQ(json["box"]["sides"], (std::vector<double>{6, 2}));
    EXPECT_FALSE(json["measures"].contains("voronoi"));
    EXPECT_FALSE(json["measures"].contains("largest_empty"));
    EXPECT_THAT(stored("index.html"),
                HasSubstr("in a periodic box of 6 × 2: lengths are in roots of its area, 3.4641"));
    EXPECT_THAT(stored("index.html"), HasSubstr("<div class=\"axis\"><span>0</span><span>6</span></div>"));
    EXPECT_THAT(stored("index.html"), Not(HasSubstr("Voronoi")));
    EXPECT_THAT(stored("number-variance.csv"), HasSubstr("radius"));
}

TEST_F(PeriodicBoxCommand, IsDeclaredByFilesByCornersOrByTheConfig)
{
    write("set.txt", {6, 2}, 50);
    ASSERT_EQ(analyze("set.txt", {"--domain", "0:6 0:2"}).status, 0);
    const std::string radial = stored("radial.csv"), pairs = stored("pair-correlation.csv");
    ASSERT_EQ(analyze("set.txt", {"--domain", "0 0 6 2"}).status, 0);
    EXPECT_EQ(stored("radial.csv"), radial);
    write("declared.txt", {6, 2}, 50, "# domain 0:6 0:2\n");
    ASSERT_EQ(analyze("declared.txt", {}).status, 0);
    EXPECT_EQ(stored("radial.csv"), radial);
    EXPECT_EQ(stored("pair-correlation.csv"), pairs);
    // Stored points have each coordinate over its side.
    folder_.write("unit.txt", stored("realization-000.dat"));
    ASSERT_EQ(analyze("unit.txt", {"--set", "analysis.box=[3,1]"}).status, 0);
    EXPECT_EQ(stored("radial.csv"), radial);
    folder_.write("c.toml", "[analysis]\nbox = [3, 1]\n[[method]]\nsampler = \"file\"\npath = \"unit.txt\"\n");
    const Outcome run = run_program(folder_.path(), {"run", "c.toml", "--out", "r"});
    ASSERT_EQ(run.status, 0) << run.error;
    const auto of_run = nlohmann::json::parse(content_of(folder_.path() / "r/results.json"))["series"][0];
    EXPECT_EQ(content_of(folder_.path() / "r" / of_run["radial"]["file"].get<std::string>()), radial);
}

TEST_F(PeriodicBoxCommand, OfEqualSidesIsASquareToTheLastByte)
{
    write("set.txt", {1, 1}, 80);
    ASSERT_EQ(analyze("set.txt", {}).status, 0);
    std::map<std::string, std::string> files;
    for (const char* file : {"radial.csv", "pair-correlation.csv", "number-variance.csv", "spectrum.exr"})
        files[file] = stored(file);
    const auto measures = series()["measures"];
    for (const auto& words :
         std::vector<std::vector<std::string>>{{"--domain", "0:1 0:1"}, {"--set", "analysis.box=[5,5]"}}) {
        ASSERT_EQ(analyze("set.txt", words).status, 0);
        for (const auto& [file, content] : files) EXPECT_EQ(stored(file.c_str()), content) << file;
        EXPECT_EQ(series()["measures"], measures);
        EXPECT_FALSE(series().contains("box"));
    }
}

TEST_F(PeriodicBoxCommand, MeasuresInSpace)
{
    write("set.txt", {10, 10, 30}, 400);
    const Outcome outcome = analyze("set.txt", {"--domain", "10 10 30"});
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(series()["box"]["sides"], (std::vector<double>{10, 10, 30}));
    EXPECT_THAT(stored("index.html"),
                HasSubstr("in a periodic box of 10 × 10 × 30: lengths are in roots of its volume"));
    EXPECT_THAT(stored("index.html"), HasSubstr("Close-ups"));
    EXPECT_THAT(stored("index.html"), Not(HasSubstr("Cube of frequencies")));
}

}
}
