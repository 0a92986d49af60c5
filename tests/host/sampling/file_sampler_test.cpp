// The sampler `file`: which files a path means, in which order, and what makes them no series.
#include "host/sampling/file_sampler.hpp"

#include "base/points/point_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace poissonlab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// A config in a folder, and what its [[method]] asks for.
class FileSampler : public testing::Test
{
protected:
    Parameters parameters(const std::vector<std::string>& path) const
    {
        Parameters parameters;
        parameters.set("path", path, {(folder.path() / "experiment.toml").string(), 12});
        return parameters;
    }

    /// The x of the first point of each realization.
    std::vector<double> first_x(const std::vector<std::string>& path) const
    {
        const Parameters p = parameters(path);
        spec.check(p, request, {});
        const auto sampler = spec.create(p, request, Engine::reference, {});
        std::vector<double> x;
        for (std::uint32_t k = 0; k < spec.available_realizations(p); ++k) {
            x.push_back(sampler->sample(k).coordinates.at(0));
        }
        return x;
    }

    /// The message of the check, without the folder of the config.
    std::string error(const std::vector<std::string>& path) const
    {
        std::string message = message_of([&] { spec.check(parameters(path), request, {}); });
        const std::string prefix = folder.path().string() + "/";
        for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) message.erase(at, prefix.size());
        return message;
    }

    TemporaryFolder folder;
    SamplerSpec spec = file_sampler();
    SampleRequest request{.points = 2, .dimension = 2, .seed = 1};
};

TEST_F(FileSampler, FindsNamesAndGlobsBesideTheConfig)
{
    folder.write("sets/b.dat", "0.2 0\n");
    folder.write("sets/a.dat", "0.1 0\n");
    folder.write("sets/c.txt", "0.3 0\n");
    EXPECT_EQ(first_x({"sets/c.txt"}), (std::vector{0.3}));
    EXPECT_EQ(first_x({"sets/*.dat"}), (std::vector{0.1, 0.2}));
    EXPECT_EQ(first_x({"sets/c.txt", "sets/[ab].dat"}), (std::vector{0.3, 0.1, 0.2}));
    EXPECT_EQ(first_x({(folder.path() / "sets" / "?.txt").string()}), (std::vector{0.3}));
}

TEST_F(FileSampler, TakesOddNamesLiterally)
{
    folder.write("set [1].dat", "0.1 0\n");
    folder.write("set 1.dat", "0.2 0\n");
    EXPECT_EQ(first_x({"set [1].dat"}), (std::vector{0.1}));

    // A glob in a folder whose own name looks like one.
    folder.write("a[b]*/x.dat", "0.3 0\n");
    Parameters p;
    p.set("path", std::vector<std::string>{"*.dat"}, {(folder.path() / "a[b]*" / "experiment.toml").string(), 1});
    EXPECT_EQ(spec.available_realizations(p), 1U);
}

TEST_F(FileSampler, TakesEveryRealizationOfAFile)
{
    folder.write("a.dat", "0.1 0\n#\n0.2 0\n");
    folder.write("b.dat", "0.3 0\n");
    EXPECT_EQ(first_x({"?.dat"}), (std::vector{0.1, 0.2, 0.3}));
}

TEST_F(FileSampler, TakesNoSetTwice)
{
    folder.write("a.dat", "0.1 0\n");
    EXPECT_THAT(error({"a.dat", "*.dat"}), StartsWith("experiment.toml:12: path = \"*.dat\": a.dat is named twice"));
    EXPECT_THAT(error({"a.dat", "./a.dat"}), HasSubstr("named twice"));
}

TEST_F(FileSampler, SaysWhichNameHasNoFile)
{
    folder.write("a.dat", "0.1 0\n");
    EXPECT_EQ(error({"a.dat", "b*.dat"}), "experiment.toml:12: path = \"b*.dat\": no such file in " +
                                              folder.path().string() + ", the folder of the config");
    EXPECT_EQ(error({"/no/such/folder/*"}), "experiment.toml:12: path = \"/no/such/folder/*\": no such file");
}

TEST_F(FileSampler, RefusesSetsOfUnequalSize)
{
    folder.write("a.dat", "0.1 0\n0.2 0\n");
    folder.write("b.dat", "0.1 0\n0.2 0\n#\n0.3 0\n");
    EXPECT_EQ(error({"*.dat"}),
              "experiment.toml:12: path = \"*.dat\": all realizations must be of one size, but a.dat has 2 2D points, "
              "and b.dat has 1 2D points (realization 3)");
}

TEST_F(FileSampler, RefusesSetsOfAnotherDimension)
{
    folder.write("a.dat", "0.1 0 0.5\n");
    EXPECT_EQ(error({"a.dat"}),
              "experiment.toml:12: path = \"a.dat\": holds 3D points; the experiment has dimension = 2");
    folder.write("b.dat", "0.1 0\n");
    EXPECT_THAT(error({"b.dat", "a.dat"}), HasSubstr("b.dat has 1 2D points, and a.dat has 1 3D points"));
}

TEST_F(FileSampler, PassesOnWhatIsWrongInAFile)
{
    folder.write("a.dat", "0.1 0\n0.2 1.5\n");
    EXPECT_EQ(error({"a.dat"}), "a.dat:2: 1.5: must be a number in [0, 1); the numbers go from 0 to 1.5: region = "
                                "\"rectangle 0.1 0 0.21 1.6\" would fit");
}

TEST_F(FileSampler, RefusesWhatHasNoEndOrCanBeReadOnce)
{
    ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(error({"pipe"}), "experiment.toml:12: path = \"pipe\": pipe is a pipe or a device; a file is needed");
    EXPECT_THAT(error({"/dev/zero"}), HasSubstr("path = \"/dev/zero\": /dev/zero is a pipe or a device"));
}

TEST_F(FileSampler, NeedsAPath)
{
    EXPECT_EQ(message_of([&] {
                  spec.check({}, request, {"experiment.toml", 9});
              }),
              "experiment.toml:9: path: must be given: a file, a glob, or a list of these");
}

}
}
