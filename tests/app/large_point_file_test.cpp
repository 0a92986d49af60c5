// Point files of `tiles points` that are made in pieces: the same bytes from any number of processes, in memory that
// does not grow. Read back by NumPy and h5py.
#include "base/errors/errors.hpp"
#include "base/points/placed_file.hpp"
#include "host/tile_points/tile_points.hpp"
#include "tests/support/command_test.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/places.hpp"
#include "tests/support/random_tile_set.hpp"
#include "tiles/poisson/tile_set_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace poissonlab {
namespace {

using testing::HasSubstr;

class LargePointFiles : public test::CommandTest
{
protected:
    LargePointFiles() : CommandTest("tiles points")
    {
        write_tile_set(folder_.path() / "strips.ptiles", strips_);
        write_tile_set(folder_.path() / "chains.ptiles", with_random_ranks(random_chain_set(3, 20)));
    }

    std::string python(const std::string& script) const
    {
        folder_.write("script.py", script);
        const Outcome outcome = run_in_shell(folder_.path(), "/usr/bin/python3 script.py");
        EXPECT_EQ(outcome.status, 0) << outcome.error << " (package python3-h5py)";
        return outcome.out;
    }

    struct Taken
    {
        int status = -1;
        double memory = 0, addresses = 0; ///< the most, in MiB
    };

    /// The resources that the command takes of a system that grants so many MiB of addresses; 0: as many as there are.
    /// The address sanitizer needs all of them.
    Taken taken_by(const std::string& arguments, [[maybe_unused]] int most_addresses = 0) const
    {
#ifdef __SANITIZE_ADDRESS__
        most_addresses = 0;
#endif
        std::istringstream out(python(fmt::format(R"(import re, resource, subprocess, time
limit = {} << 20
process = subprocess.Popen('''exec {} tiles points {}''', shell=True, stderr=subprocess.DEVNULL,
                           preexec_fn=lambda: limit and resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
peak = 0
while process.poll() is None:
    time.sleep(0.005)
    with open(f'/proc/{{process.pid}}/status') as status:
        peak = max([peak] + [int(k) / 1024 for k in re.findall(r'VmPeak:\s+(\d+)', status.read())])
print(process.returncode, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024, peak)
)",
                                                  most_addresses, quoted(program_file()), arguments)));
        Taken taken;
        out >> taken.status >> taken.memory >> taken.addresses;
        return taken;
    }

    std::uint64_t size_of(const std::string& file) const { return std::filesystem::file_size(folder_.path() / file); }

    PoissonTileSet strips_ = random_tile_set(PoissonTileKind::corner, 2, 3, 9);
};

constexpr auto several_pieces = "strips.ptiles --window -3 5 700 701 --seed 7 --out "; // 4,416,300 points

TEST_F(LargePointFiles, HaveThePointsOfTheReferenceInOrder)
{
    ASSERT_EQ(run(std::string(several_pieces) + "points.npy").status, 0);
    const auto units = reference::exact_tile_points(strips_, {7, 0}, {{-3, 5, 0}, {700, 701, 1}});
    const std::string bytes = content_of(folder_.path() / "points.npy");
    ASSERT_EQ(bytes.size(), 128 + units.size() * sizeof(double));
    const auto* const values = reinterpret_cast<const double*>(bytes.data() + 128);
    for (std::size_t i = 0; i < units.size(); ++i) ASSERT_EQ(values[i], units[i] / 65536.0) << i;
}

TEST_F(LargePointFiles, AreTheSameInHdf5)
{
    for (const std::string file : {"points.npy", "points.h5"}) ASSERT_EQ(run(several_pieces + file).status, 0);
    EXPECT_EQ(python("import h5py, numpy\nf = h5py.File('points.h5', 'r')['points']\n"
                     "print(numpy.array_equal(f[:], numpy.load('points.npy')), f.dtype, f.shape, f.chunks)\n"
                     "print(list(f.attrs['domain']), f.attrs['unit'].decode())\n"),
              "True float64 (4416300, 2) (262144, 2)\n[0.0, 701.0] tiles\n");
    ASSERT_EQ(run("strips.ptiles --window 0 0 1 1 --out small.h5").status, 0);
    EXPECT_EQ(
        python("import h5py\nf = h5py.File('small.h5', 'r')['points']\nprint(f.shape, f.chunks, f[:].max() < 1)\n"),
        "(9, 2) (9, 2) True\n");
}

/// 4 and 19 million points, whose coordinates are 71 and 304 MB: both of several pieces. The addresses that the system
/// grants are a second witness.
TEST_F(LargePointFiles, TakeNoMemoryForMorePoints)
{
    const Taken few = taken_by(std::string(several_pieces) + "few.npy");
    ASSERT_EQ(few.status, 0);
    const std::string many = "strips.ptiles --window 0 0 1450 1450 --out ";
    const int granted = static_cast<int>(few.addresses);
    for (const std::string file : {"many.npy", "many.h5"}) {
        const Taken taken = taken_by(many + file, granted + 150);
        EXPECT_EQ(taken.status, 0) << file;
        EXPECT_NEAR(taken.memory, few.memory, 24) << file;
        EXPECT_GT(size_of(file), 4 * size_of("few.npy"));
        std::filesystem::remove(folder_.path() / file);
    }
    EXPECT_LT(few.memory, 500);
#ifndef __SANITIZE_ADDRESS__
    EXPECT_NE(taken_by(many + "refused.npy", granted / 2).status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "refused.npy"));
#endif
}

TEST_F(LargePointFiles, DoNotBeginWhereTheDiskHasNoRoom)
{
    const auto free = std::filesystem::space(folder_.path()).available;
    const PointFileHead head{.dimension = 3, .points = free / 24 + (std::uint64_t{1} << 30)};
    for (const std::string name : {"a.npy", "a.h5", "a.hdf5"}) {
        const std::string message = message_of<InputError>([&] { check_room(folder_.path() / name, head); });
        EXPECT_THAT(message, HasSubstr("a" + name.substr(1) + ": " + std::to_string(head.points) + " points take "));
        EXPECT_THAT(message, HasSubstr(" GB are free there: at most "));
        EXPECT_THAT(message, testing::EndsWith(" points fit"));
    }
    EXPECT_NO_THROW(check_room(folder_.path() / "a.npy", {.dimension = 3, .points = 1000}));
    const PoissonTileSet spheres = random_tile_set(PoissonTileKind::corner, 3, 2, 4096);
    write_tile_set(folder_.path() / "spheres.ptiles", spheres);
    const Outcome outcome = run("spheres.ptiles --torus 65535 --out endless.npy");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.error, HasSubstr("tiles: must be at most "));
    const Outcome large = run("spheres.ptiles --torus 2000 --out large.npy"); // 0.8 PB
    EXPECT_EQ(large.status, 2);
    EXPECT_THAT(large.error, HasSubstr("large.npy: 32768000000000 points take 7.86e+05 GB, and "));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "large.npy"));
}

}
}
