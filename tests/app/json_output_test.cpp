// Every command that has --json prints one JSON object with it, and nothing else.
#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <sstream>

namespace poissonlab {
namespace {

std::string without_backslashes(std::string text)
{
    std::erase(text, '\\');
    return text;
}

/// The commands whose help has --json, by the manual page.
std::set<std::string> commands_with_json(const TemporaryFolder& folder)
{
    std::istringstream page(run_program(folder.path(), {"help", "man-page"}).out);
    std::set<std::string> commands;
    std::string command;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with(".SS ")) command = without_backslashes(line.substr(4));
        if (line == "\\fB\\-\\-json\\fR") commands.insert(command);
    }
    return commands;
}

struct JsonCase
{
    std::string arguments; ///< in shell words
    std::string member;    ///< that the object has; empty: it is a list
    std::string value{};   ///< of that member, where it is known; as JSON
};

/// Small work of each command, in an order in which files are there.
const std::vector<std::pair<std::string, JsonCase>>& json_cases()
{
    static const std::vector<std::pair<std::string, JsonCase>> cases{
        {"tiles build",
         {"corner --colors 2 --points 4 --lloyd 1 --relative-radius 0.4 --out set.ptiles", "tiles", "16"}},
        {"tiles points", {"set.ptiles --window 0 0 3 2 --out points.npy", "points", "24"}},
        {"tiles verify", {"set.ptiles", "tiles", "16"}},
        {"tiles build",
         {"corner --colors 2 --points 4 --lloyd 1 --relative-radius 0.4 --ranked --out ranked.ptiles", "tiles", "16"}},
        {"tiles picture", {"ranked.ptiles --torus 3 --out points.png", "points", "36"}},
        {"tiling", {"corner --colors 2 --window 0 0 3 2", "tiles"}},
        {"tiling", {"cube --colors 2 --window 0 0 0 2 1 2", "layers"}},
        {"packing", {"corner --colors 2", "tiles"}},
        {"packing", {"corner --colors 2 --all", "packings"}},
        {"packing", {"corner --colors 2 --count", "packings", "32"}},
        {"distribute warp", {"--density 1 --points 16 --method random --out a.txt", "least_spacing"}},
        {"distribute rank", {"--density 1 --points 64 --out a.txt", "asked_for", "64"}},
        {"distribute darts", {"--region 'rectangle 0 0 3 2' --points 9 --quiet --out a.txt", "area", "6"}},
        {"distribute points",
         {"--region 'rectangle 0 0 3 2' --method lloyd --iterations 2 --points 9 --quiet --out a.txt", "area", "6"}},
        {"distribute points",
         {"--region 'rectangle 0 0 3 2' --min-distance 0.3+0.1*x --between mean --quiet --out a.txt", "too_near", "0"}},
        {"points dart-throwing", {"--points 20 --relative-radius 0.6 --quiet --out p.npy", "points", "20"}},
        {"points lloyd", {"--points 20 --iterations 1 --quiet --out p.npy", "points", "20"}},
        {"points gaussian-blue-noise", {"--points 200 --iterations 1 --quiet --out p.npy", "iteration", "1"}},
        {"distribute classes", {"--points 5 20 --quiet --engine reference --out a.csv", "points", "25"}},
        {"distribute surface-classes",
         {"square.off --points 2 5 --quiet --engine reference --out a.ply", "points", "7"}},
        {"distribute surface", {"square.off --points 5 --quiet --engine reference --out a.ply", "area", "1"}},
        {"distribute mri-mask", {"--shape 32 32 --acceleration 4 --out a.npy", "samples", "256"}},
        {"distribute dither-mask", {"--size 16 --out a.png", "least_distance_4"}},
        {"distribute stipple", {"--image 0.2 --points 16 --by warping --method random --out a.svg", "marks", "16"}},
        {"distribute hatch", {"--image 0.2 --points 16 --by warping --method random --out a.svg", "marks", "16"}},
        {"distribute icons", {"--u=-y --v x --points 16 --method random --out a.csv", "disk_radius"}},
        {"distribute instances", {"forest --window 0 0 0.1 0.1 --out a.csv", "expected", "20"}},
        {"distribute recursive", {"--points 20 --quiet --out a.csv", "points", "20"}},
        {"aperiodic sets", {"", ""}},
        {"aperiodic convert", {"ammann --construction rotation", ""}},
        {"aperiodic verify", {"ammann --width 2", "periodic", "false"}},
        {"aperiodic tile", {"kari --window 0 0 3 2 --engine reference", "tiles"}},
        {"aperiodic tables", {"", "tables"}},
        {"isohedral list", {"", ""}},
        {"texture advise", {"grey.pgm", "size", "16"}},
        {"texture build",
         {"corner --colors 2 --exemplar grey.pgm --size 16 --candidates 1 --out texture", "tiles", "16"}},
        {"texture verify", {"texture", "tiles", "16"}},
        {"texture surface",
         {"cube.off --exemplar grey.pgm --size 16 --candidates 1 --pixels 32 --quiet --out a.png", "quads", "6"}},
        {"distribute objects", {"cube.off --points 200 --texels 8 --pixels 32 --quiet --out a.png", "quads", "6"}},
        {"texture cells", {"cells.toml --window 0 0 5 4 --quiet --out a.csv", "cells", "20"}},
        {"texture export", {"texture --formats dds --out engine", "layers", "16"}},
        {"texture endless", {"hexagons --exemplar grey.pgm --window 0 0 16 9 --quiet --out a.png", "height", "9"}},
        {"texture map", {"texture --size 4 3 --engine reference --quiet --out a.png", "height", "3"}},
        {"merge", {"run --out all", "merged"}},
        {"diff", {"run run", "changed", "false"}},
        {"devices", {"", "devices"}},
        {"samplers", {"", "samplers"}},
        {"kinds", {"", "kinds"}}};
    return cases;
}

TEST(JsonOutput, IsOneObjectOfEachCommandThatHasIt)
{
    const TemporaryFolder folder;
    folder.write("c.toml", "[analysis]\npoints = 16\nrealizations = 1\n[[method]]\nsampler = \"random\"\n");
    std::set<std::string> missing = commands_with_json(folder);
    EXPECT_EQ(missing.erase("run"), 1); // one object a line while it works
    ASSERT_EQ(run_program(folder.path(), {"run", "c.toml", "--out", "run", "--quiet"}).status, 0);
    std::string picture = "P2 32 32 255\n";
    for (int i = 0; i < 32 * 32; ++i) picture += std::to_string(i * 7 % 256) + "\n";
    folder.write("grey.pgm", picture);
    folder.write("cells.toml", "[[corner]]\ncolor = \"#000000\"\n[[corner]]\ncolor = \"#ffffff\"\n[rule]\n");
    folder.write("cube.off", "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                             "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n");
    folder.write("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    for (const auto& [command, sample] : json_cases()) {
        missing.erase(command);
        const Outcome outcome = run_program_line(folder.path(), command + " --json " + sample.arguments);
        EXPECT_EQ(outcome.status, 0) << command;
        EXPECT_EQ(outcome.error, "") << command;
        const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
        ASSERT_FALSE(json.is_discarded()) << command << ":\n" << outcome.out;
        if (sample.member.empty()) {
            EXPECT_TRUE(json.is_array()) << command;
            continue;
        }
        ASSERT_TRUE(json.contains(sample.member)) << command << ":\n" << outcome.out;
        if (!sample.value.empty()) {
            EXPECT_EQ(json.at(sample.member), nlohmann::json::parse(sample.value)) << command;
        }
        if (const auto meanings = json.find("meanings"); meanings != json.end()) {
            EXPECT_EQ(meanings->size() + 1, json.size()) << command << ": each number has one";
        }
    }
    EXPECT_TRUE(missing.empty()) << "no case of " << *missing.begin();
}

}
}
