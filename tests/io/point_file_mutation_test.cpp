// Damaged files: whatever bytes they hold, they are read as points in [0, 1) or refused with an InputError.
#include "errors/errors.hpp"
#include "io/point_file.hpp"
#include "io/whole_file.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace poissonlab {
namespace {

class MutatedPointFile : public testing::TestWithParam<const char*>
{
};

/// One to four changes: a byte replaced, a digit replaced, bytes doubled, the end cut off.
std::string damaged(std::string content, std::mt19937& random)
{
    for (unsigned change = 0; change <= random() % 4; ++change) {
        if (content.empty()) break;
        const std::size_t at = random() % content.size();
        switch (random() % 4) {
        case 0:
            content[at] = static_cast<char>(random() % 256);
            break;
        case 1:
            content[at] = static_cast<char>('0' + random() % 10);
            break;
        case 2:
            content.insert(at, content.substr(at, 1 + random() % 20));
            break;
        default:
            content.resize(at);
            break;
        }
    }
    return content;
}

TEST_P(MutatedPointFile, IsReadOrRefused)
{
    const TemporaryFolder folder;
    const auto file = folder.path() / GetParam();
    write_points(file, PointSet{2, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}, "a comment");
    const std::string content = read_whole_file(file);

    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        std::filesystem::remove(file); // some file systems are slow to write over a file
        folder.write(GetParam(), damaged(content, random));
        try {
            for (const PointSet& points : read_points(file)) {
                ASSERT_TRUE(points.dimension == 2 || points.dimension == 3);
                ASSERT_GT(points.size(), 0U);
                ASSERT_EQ(points.coordinates.size() % static_cast<std::size_t>(points.dimension), 0U);
                for (const double x : points.coordinates) ASSERT_TRUE(x >= 0 && x < 1);
            }
        } catch (const InputError&) {
            // Any other exception fails the test.
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, MutatedPointFile, testing::Values("points.dat", "points.ply", "points.npy"),
                         [](const auto& parameter) { return std::string(parameter.param).substr(7); });

}
}
