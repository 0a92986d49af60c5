// Small meshes by hand, one a habit of those who write files, beside their areas; and the same with other ends of
// lines.
#include "base/files/whole_file.hpp"
#include "base/surfaces/triangle_mesh.hpp"
#include "tests/support/corpus.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace poissonlab {
namespace {

/// The size of a mesh; see right.txt.
struct Extent
{
    double triangles = 0, vertices = 0, area = 0, shadow = 0, volume = 0;
};

Extent extent_of(const TriangleMesh& mesh)
{
    Extent extent{static_cast<double>(mesh.triangles.size()), static_cast<double>(mesh.vertices.size())};
    for (const MeshTriangle& t : mesh.triangles) {
        const MeshPoint &a = mesh.vertices.at(t[0]), &b = mesh.vertices.at(t[1]), &c = mesh.vertices.at(t[2]);
        MeshPoint normal{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
            normal[k] = ((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])) / 2;
            extent.volume += normal[k] * a[k] / 3;
        }
        extent.area += std::hypot(normal[0], normal[1], normal[2]);
        extent.shadow += normal[2];
    }
    return extent;
}

const std::filesystem::path mesh_corpus = std::filesystem::path(source_folder()) / "tests/base/surfaces/meshes";

/// Returns the numbers of right.txt by the names of meshes, in the order of Extent.
std::map<std::string, std::vector<double>> right_meshes() { return test::right_numbers(mesh_corpus, 5); }

void expect_extent(const TriangleMesh& mesh, const std::vector<double>& numbers)
{
    const Extent found = extent_of(mesh);
    const Extent right{numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3), numbers.at(4)};
    EXPECT_EQ(found.triangles, right.triangles);
    EXPECT_EQ(found.vertices, right.vertices);
    EXPECT_NEAR(found.area, right.area, 1e-13 * right.area);
    EXPECT_NEAR(found.shadow, right.shadow, 1e-13 * right.area);
    EXPECT_NEAR(found.volume, right.volume, 2e-13 * right.area);
}

TEST(MeshCorpus, HasItsRightSizes)
{
    for (const auto& [file, numbers] : right_meshes()) {
        SCOPED_TRACE(file);
        expect_extent(read_triangle_mesh(mesh_corpus / file), numbers);
    }
}

TEST(MeshCorpus, IsKnown) { test::expect_numbers_of_all(mesh_corpus, right_meshes()); }

std::string replaced(const std::string& text, const std::string& from, const std::string& to)
{
    std::string result;
    std::size_t begin = 0;
    for (std::size_t at; (at = text.find(from, begin)) != text.npos; begin = at + from.size())
        result += text.substr(begin, at - begin) + to;
    return result + text.substr(begin);
}

/// Ends of lines of three systems, blanks before them, no end of the last line, and a byte order mark.
TEST(MeshCorpus, IsTheSameFromOtherSystems)
{
    const TemporaryFolder folder;
    for (const auto& [name, numbers] : right_meshes()) {
        const std::string text = read_whole_file(mesh_corpus / name);
        const TriangleMesh mesh = read_triangle_mesh(mesh_corpus / name);
        std::vector<std::string> others{replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), "\xef\xbb\xbf" + text,
                                        text.substr(0, text.size() - 1)};
        if (!name.ends_with("continued.obj")) others.push_back(replaced(text, "\n", " \t\n"));
        if (!name.ends_with(".ply")) others.push_back(replaced(text, " ", "\t"));
        for (std::size_t i = 0; i < others.size(); ++i) {
            SCOPED_TRACE(name + ", " + std::to_string(i));
            const std::filesystem::path file = folder.path() / std::filesystem::path(name).filename();
            write_whole_file(file, others[i]);
            const TriangleMesh other = read_triangle_mesh(file);
            EXPECT_EQ(other.vertices, mesh.vertices);
            EXPECT_EQ(other.triangles, mesh.triangles);
        }
    }
}

/// A note says what is left out.
TEST(MeshCorpus, IsLeftOutWithAWord)
{
    const auto notes = [](const char* file) { return read_triangle_mesh(mesh_corpus / file).notes; };
    using testing::ElementsAre;
    EXPECT_THAT(notes("obj/triangles.obj"), ElementsAre());
    EXPECT_THAT(notes("obj/lines.obj"),
                ElementsAre("3 lines or points of the file, which have no area, were left out"));
    EXPECT_THAT(notes("gltf/lines.gltf"),
                ElementsAre("the extension EXT_mesh_gpu_instancing of the file is not known here and was left out",
                            "2 lines or points of the file, which have no area, were left out"));
    EXPECT_THAT(notes("gltf/morphed.gltf"),
                ElementsAre("morph targets of the file were left out: the mesh has the shape without them",
                            "skins of the file were left out: the mesh has the shape without them"));
    EXPECT_THAT(notes("ply/elements.ply"),
                ElementsAre("2 lines or points of the file, which have no area, were left out"));
    EXPECT_THAT(notes("gltf/named-scene.gltf"),
                ElementsAre("scene 2 of 2 was read, which is the one that the file shows"));
    EXPECT_THAT(notes("gltf/unnamed-scene.gltf"),
                ElementsAre("scene 1 of 2 was read, which is the first: the file names none"));
    EXPECT_EQ(read_triangle_mesh(mesh_corpus / "obj/numbers.obj").dropped, 2U);
}

}
}
