// Files that are read in pieces hold the points that read_points() finds, in their order. HDF5 is written by h5py:
// another program than ours.
#include "base/points/point_stream.hpp"

#include "base/errors/errors.hpp"
#include "base/files/scratch_folder.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class PointStream : public testing::Test
{
protected:
    std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

    void run_python(const std::string& lines) const
    {
        folder_.write("script.py", "import numpy\nx = numpy.arange(6000).reshape(-1, 3) / 6000\n" + lines);
        const Outcome outcome = run_in_shell(folder_.path(), "/usr/bin/python3 script.py");
        ASSERT_EQ(outcome.status, 0) << outcome.error;
    }

    void expect_same(const std::string& name, std::optional<CoordinateRange> range = {}) const
    {
        ASSERT_TRUE(can_be_streamed(file(name))) << name;
        const PointSet expected = read_points(file(name), range).at(0);
        const ScratchFolder scratch(file("strips"));
        std::vector<double> told;
        const PointStrips strips =
            read_into_strips(file(name), {.domain = range}, scratch.path(),
                             [&](std::span<const double> part) { told.insert(told.end(), part.begin(), part.end()); });
        EXPECT_EQ(told, expected.coordinates) << name;
        EXPECT_EQ(strips.dimension(), expected.dimension);
        EXPECT_EQ(strips.size(), expected.size());
        std::vector<double> kept;
        for (std::size_t strip = 0; strip < strips.count(); ++strip)
            std::ranges::copy(strips.strip(strip).coordinates, std::back_inserter(kept));
        std::ranges::sort(kept);
        std::ranges::sort(told);
        EXPECT_EQ(kept, told) << name;
        EXPECT_GE(points_at_most(file(name)), expected.size());
    }

    std::string error_of(const std::string& name) const
    {
        const ScratchFolder scratch(file("strips"));
        try {
            read_into_strips(file(name), {}, scratch.path(), [](std::span<const double>) {});
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    }

    TemporaryFolder folder_;
};

/// More than a piece of text and of NumPy has.
TEST_F(PointStream, ReadsWhatIsReadAtOnce)
{
    std::mt19937_64 random(1);
    PointSet set{2, {}};
    for (int i = 0; i < 600'000; ++i) set.coordinates.push_back(static_cast<double>(random() >> 11) * 0x1p-53);
    write_points(file("many.txt"), set, "");
    write_points(file("many.csv"), {2, {set.coordinates.begin(), set.coordinates.begin() + 2000}}, "");
    write_points(file("many.npy"), set, "");
    write_points(file("many.h5"), set, "");
    for (const char* name : {"many.txt", "many.csv", "many.npy", "many.h5"}) expect_same(name);
    EXPECT_EQ(known_shape(file("many.npy"))->points, 300'000u);
    folder_.write("domain.txt", "# domain 0:512\n3\n1 2\n3 4\n511.5 6\n#\n");
    expect_same("domain.txt");
}

TEST_F(PointStream, ReadsWhatOthersWrite)
{
    run_python(
        "import h5py\n"
        "numpy.save('float.npy', x.astype('f4'))\n"
        "numpy.save('columns.npy', numpy.asfortranarray(x))\n"
        "f = h5py.File('float.h5', 'w')\nf['points'] = (8 * x).astype('f4')\nf['points'].attrs['domain'] = [0, 8]\n"
        "g = h5py.File('glass.hdf5', 'w')\ng['PartType1/Coordinates'] = 92 * x\n"
        "g.create_group('Header').attrs['BoxSize'] = 92.0\n"
        "h = h5py.File('other.h5', 'w')\nh['stars'] = x\n"
        "i = h5py.File('outside.h5', 'w')\ni['points'] = 2 * x\n"
        "numpy.save('several.npy', x.reshape(2, -1, 3))\n");
    for (const char* name : {"float.npy", "columns.npy", "float.h5", "glass.hdf5"}) expect_same(name);
    EXPECT_EQ(read_points(file("glass.hdf5")).at(0)[500][1], 92 * (1501.0 / 6000) / 92);
    EXPECT_THAT(error_of("other.h5"), HasSubstr("has neither the table /points nor /PartType0/Coordinates"));
    EXPECT_THAT(error_of("outside.h5"), HasSubstr("point 1001: 1.0003333333333333: must be a number in [0, 1)"));
    EXPECT_FALSE(can_be_streamed(file("several.npy")));
    std::filesystem::resize_file(file("float.h5"), 3000);
    EXPECT_THAT(error_of("float.h5"), HasSubstr("cannot be read as HDF5: truncated file"));
}

TEST_F(PointStream, IsOfOneSet)
{
    folder_.write("two.txt", "0.1 0.2\n#\n0.3 0.4\n");
    EXPECT_FALSE(can_be_streamed(file("two.txt")));
    EXPECT_THAT(error_of("two.txt"), HasSubstr("two.txt:3: 0.3 0.4: a file that is read in pieces has one set"));
    folder_.write("count.txt", "4\n0.1 0.2\n0.3 0.4\n");
    EXPECT_THAT(error_of("count.txt"), HasSubstr("count.txt:1: 4: is not the number of points, which is 2"));
    folder_.write("none.txt", "# nothing\n");
    EXPECT_THAT(error_of("none.txt"), HasSubstr("no points"));
}

TEST_F(PointStream, PointsOfThePlaneMustHaveTwoCoordinates)
{
    folder_.write("flat.txt", "0.1 0.2 0.5\n0.3 0.4 0.5\n");
    EXPECT_THAT(error_of("flat.txt"), HasSubstr("flat.txt: all points have one coordinate in common"));
    folder_.write("one.txt", "0.1 0.2 0.5\n");
    expect_same("one.txt");
}

}
}
