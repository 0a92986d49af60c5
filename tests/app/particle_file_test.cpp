// Particle files of `tiles points`, read back by h5py: HDF5 by another program than ours.
#include "base/points/placed_file.hpp"

#include "base/errors/errors.hpp"
#include "host/tile_points/tile_points.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class ParticleFiles : public test::CommandTest
{
protected:
    ParticleFiles() : CommandTest("tiles points")
    {
        write_tile_set(folder_.path() / "spheres.ptiles", tiles_);
        write_tile_set(folder_.path() / "plane.ptiles", random_tile_set(PoissonTileKind::corner, 2, 3, 9));
    }

    /// The output of Python, which has the file open as f.
    std::string read_back(const std::string& file, const std::string& expression) const
    {
        folder_.write("script.py",
                      "import h5py, numpy\nf = h5py.File('" + file + "', 'r')\nprint(" + expression + ")\n");
        const Outcome outcome = run_in_shell(folder_.path(), "/usr/bin/python3 script.py");
        EXPECT_EQ(outcome.status, 0) << outcome.error << " (package python3-h5py)";
        return outcome.out;
    }

    /// The coordinates of the torus of 3 x 3 x 3 tiles, in tiles, as Python has them.
    std::string expected_script(double side) const
    {
        std::string numbers;
        for (const double x : reference::torus_points(tiles_, 7, 3).coordinates)
            numbers += fmt::format("{}{:.17g}", numbers.empty() ? "" : ",", x * side);
        return "numpy.array([" + numbers + "]).reshape(-1, 3)";
    }

    void expect_error_with(const std::string& arguments, const std::string& message) const
    {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_THAT(outcome.error, HasSubstr(message));
    }

    PoissonTileSet tiles_ = random_tile_set(PoissonTileKind::corner, 3, 2, 8);
};

TEST_F(ParticleFiles, SnapshotsAreAsGadgetHasThem)
{
    const Outcome outcome = run("spheres.ptiles --torus 3 --seed 7 --out glass.hdf5");
    ASSERT_EQ(outcome.status, 0) << outcome.error;
    EXPECT_EQ(read_back("glass.hdf5", "numpy.array_equal(f['PartType1/Coordinates'][:], " + expected_script(3) + ")"),
              "True\n");
    EXPECT_EQ(read_back("glass.hdf5", "f['PartType1/Coordinates'].dtype, f['PartType1/Coordinates'].shape"),
              "float64 (216, 3)\n");
    EXPECT_EQ(read_back("glass.hdf5", "numpy.array_equal(f['PartType1/ParticleIDs'][:], numpy.arange(1, 217)), "
                                      "f['PartType1/ParticleIDs'].dtype"),
              "True uint64\n");
    EXPECT_EQ(read_back("glass.hdf5", "f['Header'].attrs['BoxSize'], list(f['Header'].attrs['NumPart_ThisFile']), "
                                      "list(f['Header'].attrs['NumPart_Total']), "
                                      "list(f['Header'].attrs['NumPart_Total_HighWord']), "
                                      "list(f['Header'].attrs['MassTable'])"),
              "3.0 [0, 216, 0, 0, 0, 0] [0, 216, 0, 0, 0, 0] [0, 0, 0, 0, 0, 0] [0.0, 0.125, 0.0, 0.0, 0.0, 0.0]\n");
    EXPECT_EQ(read_back("glass.hdf5", "f['Header'].attrs['NumFilesPerSnapshot'], f['PartType1/Coordinates'].attrs["
                                      "'Units'].decode()"),
              "1 tiles, BoxSize of them along each axis\n");
}

TEST_F(ParticleFiles, H5PartFilesHaveTheUnitCube)
{
    ASSERT_EQ(run("spheres.ptiles --torus 3 --seed 7 --out glass.h5part").status, 0);
    EXPECT_EQ(read_back("glass.h5part", "list(f), numpy.abs(numpy.stack([f['Step#0'][a][:] for a in 'xyz'], 1) - " +
                                            expected_script(1) + ").max() < 1e-15"),
              "['Step#0'] True\n");
}

TEST_F(ParticleFiles, AreTheSameBytesEachTime)
{
    ASSERT_EQ(run("spheres.ptiles --window 0 0 0 2 2 2 --out a.hdf5").status, 0);
    ASSERT_EQ(run("spheres.ptiles --window 0 0 0 2 2 2 --out b.hdf5").status, 0);
    EXPECT_EQ(content_of(folder_.path() / "a.hdf5"), content_of(folder_.path() / "b.hdf5"));
}

TEST_F(ParticleFiles, TorusesHaveThePointsOfTheReference)
{
    for (const std::string set : {"spheres", "plane"})
        ASSERT_EQ(run(set + ".ptiles --torus 5 --seed 3 --out " + set + ".txt").status, 0);
    EXPECT_EQ(read_points(folder_.path() / "spheres.txt").at(0), reference::torus_points(tiles_, 3, 5));
    const PoissonTileSet chains = random_chain_set(3, 20);
    write_tile_set(folder_.path() / "chains.ptiles", chains);
    ASSERT_EQ(run("chains.ptiles --torus 4 --out chains.txt").status, 0);
    EXPECT_EQ(read_points(folder_.path() / "chains.txt").at(0), reference::torus_points(chains, 1, 4));
}

TEST_F(ParticleFiles, BadArgumentsLeaveNothingBehind)
{
    expect_error(
        "spheres.ptiles --window 0 0 0 2 2 3 --out a.hdf5",
        "tiles points: --out a.hdf5: particles are in a cube: --window must have as many tiles along each axis");
    expect_error_with("plane.ptiles --torus 4 --out a.h5part",
                      "a.h5part: particles of simulations are in 3D; these points are in 2D");
    expect_error_with("spheres.ptiles --out a.hdf5", "tiles points: needs one of --window, --torus and --region");
    expect_error_with("spheres.ptiles --torus 2 --window 0 0 0 1 1 1 --out a.hdf5",
                      "needs one of --window, --torus and --region");
    expect_error_with("spheres.ptiles --torus 65536 --out a.hdf5",
                      "--torus 65536: must be an integer from 1 to 65535 ");
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "a.hdf5"));
}

TEST_F(ParticleFiles, TakeAsManyPointsAsTheySay)
{
    const std::vector<double> two(6, 0.5);
    for (const std::size_t said : {1u, 3u}) {
        const auto write = [&](const PointSink& sink) { sink(two); };
        for (const std::string name : {"a.hdf5", "a.h5", "a.npy"}) {
            const PointFileHead head{.dimension = 3, .points = said};
            EXPECT_THROW(write_placed_points(folder_.path() / name, head, write), InputError);
            EXPECT_FALSE(std::filesystem::exists(folder_.path() / name));
        }
    }
}

}
}
