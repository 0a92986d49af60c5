// Some two hundred wrong inputs, and what the program says of each: tests/app/wrong_inputs.txt, which people read.
//
// A case is a few lines with an empty one after them: `$` and the words of a command, and what c.toml holds; without a
// command it is `run c.toml`; then `=>`, the exit status, and the message. The messages are printed anew, into the file
// itself, by
//
//     POISSONLAB_PRINT_WRONG_INPUTS=1 build/release/test_app --gtest_filter=WrongInputs.*
//
// and `git diff` shows what became of them. Cases run in this process: starting two hundred programs takes a minute.
#include "app/command_line.hpp"
#include "base/crew/failure.hpp"
#include "base/errors/errors.hpp"
#include "base/points/point_file.hpp"
#include "tests/support/places.hpp"
#include "tests/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <utility>

namespace poissonlab {
namespace {

struct WrongInput
{
    std::string command;  ///< empty: `run c.toml`
    std::string config;   ///< what c.toml holds
    std::string said;     ///< status and message
    std::string comments; ///< lines before the case
};

std::vector<WrongInput> read_wrong_inputs(const std::filesystem::path& path)
{
    std::vector<WrongInput> cases;
    std::ifstream file(path);
    WrongInput next;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("#") || (line.empty() && next.command.empty() && next.config.empty()))
            next.comments += line + "\n";
        else if (line.starts_with("$ "))
            next.command = line.substr(2);
        else if (line.starts_with("=>")) {
            next.said = line.substr(std::min<std::size_t>(3, line.size()));
            cases.push_back(std::exchange(next, {}));
        } else
            next.config += line + "\n";
    }
    return cases;
}

std::string text_of(const std::vector<WrongInput>& cases)
{
    std::string text;
    for (const WrongInput& input : cases)
        text += fmt::format("{}{}{}=> {}\n", input.comments, input.command.empty() ? "" : "$ " + input.command + "\n",
                            input.config, input.said);
    return text;
}

/// Words with blanks between them; single quotes keep words together.
std::vector<std::string> shell_words(const std::string& text)
{
    std::vector<std::string> words;
    bool is_quoted = false, is_word = false;
    for (const char letter : text) {
        if (letter == '\'') {
            is_quoted = !is_quoted;
            if (is_quoted && !is_word) words.emplace_back();
            is_word = true;
        } else if (letter == ' ' && !is_quoted) {
            is_word = false;
        } else {
            if (!is_word) words.emplace_back();
            is_word = true;
            words.back() += letter;
        }
    }
    return words;
}

/// Exit status and message of the program with these words, in the current folder. Which devices a machine has is left
/// out.
std::string said_of(const std::string& command)
{
    std::vector<std::string> words = shell_words(command);
    words.insert(words.begin(), "poissonlab");
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    try {
        int status = 0;
        for (const Action& action : actions_called_for(static_cast<int>(arguments.size()), arguments.data()))
            if (status == 0) status = action();
        return fmt::format("{}", status);
    } catch (...) {
        const Failure failure = Failure::current();
        const int status = failure.kind == Failure::Kind::input ? 2 : failure.kind == Failure::Kind::device ? 3 : 1;
        return fmt::format("{} {}", status, failure.message.substr(0, failure.message.find("; there are: 0:")));
    }
}

class WrongInputs : public testing::Test
{
protected:
    WrongInputs()
    {
        std::string picture = "P2 32 32 255\n";
        for (int i = 0; i < 32 * 32; ++i) picture += std::to_string(i * 7 % 256) + "\n";
        folder_.write("grey.pgm", picture);
        folder_.write("tiny.pgm", "P2 2 1 255\n0 255\n");
        folder_.write("text.txt", "this is no picture, no tile set and no point set\n");
        folder_.write("points.txt", "0.1 0.1\n0.6 0.1\n0.1 0.6\n0.6 0.6\n");
        folder_.write("three.txt", "0.1 0.1\n0.6 0.1\n0.1 0.6\n");
        folder_.write("square.geojson", R"({"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,9],[0,0]]]})");
        folder_.write("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
        folder_.write("line.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
        folder_.write("empty.obj", "");
        folder_.write("corner.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n");
        folder_.write("infinite.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1e999 1 0\n3 0 1 2\n");
        folder_.write("far.off", "OFF\n3 1 0\n1e12 0 0\n1000000000001 0 0\n1e12 1e-5 0\n3 0 1 2\n");
        folder_.write("textured.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
        folder_.write("line.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/2 3/2\n");
        folder_.write("wrong.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nf 1/1 2/2 3/2\n");
        folder_.write("broken.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"meshes\": 5");
        folder_.write("packed.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"extensionsRequired\": "
                                     "[\"KHR_materials_unlit\", \"EXT_meshopt_compression\"]}");
        folder_.write("page/index.html", "<html><body>The page of another.</body></html>");
        folder_.write("commas.txt", "0,5 0,25\n0,75 0,5\n");
        folder_.write("commas.csv", "x,y\n0,5;0,25\n");
        folder_.write("names.csv", "east,north\n7.1,50.2\n");
        folder_.write("degrees.csv", "lon,lat\n4.35,50.85\n4.36,50.84\n");
        folder_.write("degrees.geojson", R"({"type": "MultiPoint", "coordinates": [[4.35, 50.85], [4.36, 50.84]]})");
        folder_.write("far.csv", "x,y\n4.35,50.85\n4.36,50.84\n");
        folder_.write("fields.csv", "id,x,y\n1,0.5\n");
        folder_.write("trees.csv", "x,y,kind,one\n0.1,0.2,oak,a\n0.5,0.5,ash,a\n");
        folder_.write("holes.csv", "x,y,kind\n0.1,0.2,oak\n0.5,0.5,\n");
        folder_.write("control.csv", "x,y,kind\n0.1,0.2,oak\n0.5,0.5,a\x1b[31msh\n");
        folder_.write("latin.csv", "x,y,kind\n0.1,0.2,oak\n0.5,0.5,h\xeatre\n");
        const std::string ply = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                                "property float kind\nend_header\n0.1 0.2 1\n0.5 0.5 ";
        folder_.write("trees.ply", ply + "01.0\n");
        folder_.write("words.ply", ply + "ash\n");
        folder_.write("nan.ply", ply + "-nan\n");
        folder_.write("trees.geojson",
                      R"({"type": "FeatureCollection", "crs": null, "features": [{"type": "Feature", )"
                      R"("properties": {"kind": [1]}, "geometry": {"type": "Point", "coordinates": [0.1, 0.2]}}]})");
        folder_.write("mixed.csv", "x;y\n0,5;0.25\n");
        folder_.write("wide.csv", "x,y\n120.5,8\n511.7,300\n12,64.5\n88,500.5\n");
        write_points(folder_.path() / "glass.hdf5", {3, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}});
        folder_.write("utf16.geojson", std::string_view("\xff\xfe{\0", 4));
        folder_.write("array.npz", "PK\x03\x04");
        folder_.write("long3.txt", "# domain 0:2 0:1 0:1\n1.5 0.5 0.5\n0.5 0.1 0.1\n");
        folder_.write("long.txt", "# domain 0:1000 0:1\n5 0.5\n");
        folder_.write("packed.obj", "\x1f\x8b\x08");
        folder_.write("lines.geojson", "{\"type\": \"Point\", \"coordinates\": [1, 2]}\n{\"type\": 1\n");
        std::filesystem::create_symlink("nowhere", folder_.path() / "link");
        std::filesystem::create_directory(folder_.path() / "folder");
        std::filesystem::current_path(folder_.path());
        said_of("tiles build corner --colors 2 --points 4 --relative-radius 0.4 --lloyd 1 --engine reference --quiet "
                "--out set.ptiles");
        std::filesystem::copy_file(source_folder() + "/runtime/tile_sets/hat-n4.ptiles", "hat.ptiles");
    }
    ~WrongInputs() override { std::filesystem::current_path(before_); }

    TemporaryFolder folder_;

private:
    std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(WrongInputs, AreRefusedInTheseWords)
{
    const std::filesystem::path list = std::filesystem::path(source_folder()) / "tests/app/wrong_inputs.txt";
    std::vector<WrongInput> cases = read_wrong_inputs(list);
    EXPECT_GE(cases.size(), 200);
    const bool is_printed = std::getenv("POISSONLAB_PRINT_WRONG_INPUTS") != nullptr;
    for (WrongInput& input : cases) {
        folder_.write("c.toml", input.config);
        std::string said = said_of(input.command.empty() ? "run c.toml --quiet" : input.command);
        const std::string folder = folder_.path().string();
        if (const auto place = said.find(folder); place != said.npos) said.replace(place, folder.size(), "FOLDER");
        EXPECT_NE(said.front(), '0') << input.command << "\n" << input.config;
        if (!is_printed) {
            EXPECT_EQ(said, input.said) << input.command << "\n" << input.config;
        }
        input.said = said;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "out")) << "wrong input leaves nothing behind";
    if (is_printed) std::ofstream(list) << text_of(cases);
}

}
}
