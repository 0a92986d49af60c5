// Points are read back bit for bit as they were written, in every format, dimension and locale.
#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "base/points/point_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <clocale>
#include <cstdint>
#include <cstdlib>
#include <locale>

namespace poissonlab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// RapidCheck takes its seed from the clock unless told otherwise; ours are the same in every run.
const bool seed_is_fixed = ::setenv("RC_PARAMS", "seed=1", 0) == 0;

/// A double of [0, 1) from any 64 bits: all of them can occur, tiny ones and zero as well.
double coordinate_from_bits(std::uint64_t bits)
{
    return std::bit_cast<double>(bits % std::bit_cast<std::uint64_t>(1.0));
}

std::vector<std::uint64_t> bits_of(const PointSet& points)
{
    std::vector<std::uint64_t> bits;
    for (const double x : points.coordinates) bits.push_back(std::bit_cast<std::uint64_t>(x));
    return bits;
}

RC_GTEST_PROP(PointFileRoundTrip, GivesTheSameBits, ())
{
    RC_ASSERT(seed_is_fixed);
    const int dimension = *rc::gen::inRange(2, 4);
    const auto points = *rc::gen::inRange<std::size_t>(1, 50);
    const auto bits = *rc::gen::container<std::vector<std::uint64_t>>(
        points * static_cast<std::size_t>(dimension), rc::gen::scale(100.0, rc::gen::arbitrary<std::uint64_t>()));
    PointSet set{dimension, {}};
    for (const std::uint64_t word : bits) set.coordinates.push_back(coordinate_from_bits(word));
    // A coordinate that is the same everywhere, or a z that is 0 of a single point, is no dimension.
    for (std::size_t axis = 0; dimension == 3 && axis < 3; ++axis)
        set.coordinates[axis] = set.coordinates[set.coordinates.size() - 3 + axis] == 0.5 ? 0.25 : 0.5;

    const TemporaryFolder folder;
    for (const char* name : {"points.dat", "points.ply", "points.npy", "points.csv"}) {
        write_points(folder.path() / name, set, "a comment\n\nof several lines");
        const std::vector<PointSet> sets = read_points(folder.path() / name);
        RC_ASSERT(sets.size() == 1U);
        RC_ASSERT(sets[0].dimension == dimension);
        RC_ASSERT(bits_of(sets[0]) == bits_of(set));
    }
}

TEST(PointFileRoundTrip, TellsTheFormatByContentNotByName)
{
    const TemporaryFolder folder;
    const PointSet set{2, {0.1, 0.2}};
    for (const char* name : {"points.ply", "points.npy"}) {
        write_points(folder.path() / name, set);
        std::filesystem::rename(folder.path() / name, folder.path() / "points.dat");
        EXPECT_THAT(read_points(folder.path() / "points.dat"), ElementsAre(set)) << name;
    }
}

TEST(PointFileRoundTrip, WritesTextAsDocumented)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "points.dat";
    write_points(file, PointSet{3, {0.1, 0.5, 0}}, "made by hand\n\ntwice");
    EXPECT_EQ(read_whole_file(file), "# made by hand\n# twice\n0.10000000000000001 0.5 0\n");
}

TEST(PointFileRoundTrip, WritesNpyThatStartsItsNumbersAtAMultipleOf64)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "points.npy";
    write_points(file, PointSet{2, {0.1, 0.2}});
    const std::string content = read_whole_file(file);
    EXPECT_EQ((content.size() - 16) % 64, 0);
    EXPECT_THAT(content.substr(10), StartsWith("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 2), }"));
    EXPECT_EQ(content[content.size() - 17], '\n');
}

TEST(PointFileRoundTrip, SaysThatItCannotWrite)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "missing" / "points.npy";
    EXPECT_THAT(message_of<StorageError>([&] {
                    write_points(file, PointSet{2, {0.1, 0.2}});
                }),
                HasSubstr("missing/points.npy: cannot be written: "));
}

/// While it lives, C and C++ both write 0,5 for a half.
class DecimalCommaLocale
{
public:
    DecimalCommaLocale() : c_locale_(std::setlocale(LC_ALL, nullptr))
    {
        // The locale of C is set only where such a one is installed, that of C++ always.
        for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8", "nl_BE.UTF-8"}) {
            if (std::setlocale(LC_ALL, name) != nullptr) break;
        }
        cpp_locale_ = std::locale::global(std::locale(std::locale(), new Comma));
    }
    DecimalCommaLocale(const DecimalCommaLocale&) = delete;
    DecimalCommaLocale& operator=(const DecimalCommaLocale&) = delete;
    ~DecimalCommaLocale()
    {
        std::locale::global(cpp_locale_);
        std::setlocale(LC_ALL, c_locale_.c_str());
    }

private:
    struct Comma : std::numpunct<char>
    {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };

    std::string c_locale_;
    std::locale cpp_locale_;
};

TEST(PointFileRoundTrip, DoesNotDependOnTheLocale)
{
    PointSet set{2, {}};
    for (int i = 0; i < 5000; ++i) set.coordinates.insert(set.coordinates.end(), {i / 5000.0, 0.5});
    const TemporaryFolder folder;
    for (const char* name : {"points.dat", "points.ply", "points.npy"}) {
        write_points(folder.path() / name, set);
        const std::string expected = read_whole_file(folder.path() / name);
        const DecimalCommaLocale comma;
        write_points(folder.path() / name, set);
        EXPECT_EQ(read_whole_file(folder.path() / name), expected) << name;
        EXPECT_THAT(read_points(folder.path() / name), ElementsAre(set)) << name;
    }
}

TEST(PointFileInPieces, IsThatOfTheWhole)
{
    PointSet set{2, {}};
    for (int i = 0; i < 20'000; ++i) set.coordinates.push_back(i / 20'000.0);
    const TemporaryFolder folder;
    for (const std::string extension : {".dat", ".ply", ".npy"}) {
        write_points(folder.path() / ("whole" + extension), set, "a comment");
        write_points_in_pieces(
            folder.path() / ("pieces" + extension), 2, set.size(), "a comment", [&](const PointSink& sink) {
                for (std::size_t first = 0; first < set.size(); first += 3333)
                    sink(std::span(set.coordinates)
                             .subspan(2 * first, 2 * std::min<std::size_t>(3333, set.size() - first)));
            });
        EXPECT_EQ(read_whole_file(folder.path() / ("pieces" + extension)),
                  read_whole_file(folder.path() / ("whole" + extension)));
    }
}

TEST(PointFileCsv, HasNamesOfColumns)
{
    const TemporaryFolder folder;
    write_points(folder.path() / "flat.csv", {2, {0.5, 0.25, 0.75, 0}}, "left out");
    EXPECT_EQ(read_whole_file(folder.path() / "flat.csv"), "x,y\n0.5,0.25\n0.75,0\n");
    write_points(folder.path() / "deep.csv", {3, {0.5, 0.25, 0.125}});
    EXPECT_EQ(read_whole_file(folder.path() / "deep.csv"), "x,y,z\n0.5,0.25,0.125\n");
}

TEST(PointFileUsd, IsAPointInstancerOfSpheres)
{
    const TemporaryFolder folder;
    write_points(folder.path() / "points.usda", {2, {0.5, 0.25, 0.75, 0}}, "two \"points\"\nhere");
    EXPECT_EQ(read_whole_file(folder.path() / "points.usda"), R"(#usda 1.0
(
    defaultPrim = "Points"
    doc = "two \"points\"; here"
    upAxis = "Z"
)

def PointInstancer "Points"
{
    rel prototypes = </Points/Prototypes/Sphere>
    int[] protoIndices = [0, 0]
    point3f[] positions = [(0.5, 0.25, 0),
        (0.75, 0, 0)]

    def Scope "Prototypes"
    {
        def Sphere "Sphere"
        {
            double radius = 0.1326
        }
    }
}
)");
    // Pieces join without a gap.
    PointSet many{3, {}};
    for (int i = 0; i < 3 * 10'000; ++i) many.coordinates.push_back(i / 30'000.0);
    write_points(folder.path() / "many.usda", many);
    const std::string text = read_whole_file(folder.path() / "many.usda");
    const auto count = [](const std::string& all, const std::string& words) {
        std::size_t found = 0;
        for (std::size_t at = all.find(words); at != std::string::npos; at = all.find(words, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count(text, "),\n"), 9'999U);
    EXPECT_EQ(count(text.substr(0, text.find("positions")), ", 0"), 9'999U);
}

}
}
