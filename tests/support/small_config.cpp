#include "tests/support/small_config.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <vector>

namespace poissonlab::test {

namespace {

/// The largest values that keys keep. Spheres need more points, in tiles as in sets; so do coarse sets, of levels, and
/// tiles with equal second moments.
std::map<std::string, long> largest_values(const std::string& toml)
{
    std::map<std::string, long> values{
        {"points", 256},         {"realizations", 2}, {"sets", 2},   {"iterations", 5}, {"lloyd_iterations", 3},
        {"joint_iterations", 2}, {"attempts", 20},    {"levels", 1}, {"tiles", 16},     {"spectrum_size", 256},
        {"points_per_tile", 16}, {"size", 256},       {"colors", 2}, {"smooth", 0}};
    const auto has = [&](const char* line) { return toml.find(line) != std::string::npos; };
    if (has("dimension = 3")) values.at("points") = 2048, values.at("points_per_tile") = 128;
    if (has("equal_moments = 2")) values.at("points_per_tile") = 32;
    if (has("compare = true")) values.at("sets") = 1;
    if (has("levels = ")) values.at("points") = 1024;
    // The fourth power of these is the number of tiles to build. Lists keep several; textures are fast, and so are
    // tiles with classes.
    if (has("colors = [") || has("kind = \"classes\"")) values.at("colors") = 3;
    if (has("[[texture]]")) values.at("colors") = 4;
    return values;
}

/// "[2, 3, 4, 6]" or "4", each number at most so large, and each once.
std::string limited(const std::string& value, long largest)
{
    static const std::regex number("-?[0-9]+");
    std::vector<long> numbers;
    for (auto found = std::sregex_iterator(value.begin(), value.end(), number); found != std::sregex_iterator();
         ++found) {
        const long limit = std::min(std::stol(found->str()), largest);
        if (std::ranges::find(numbers, limit) == numbers.end()) numbers.push_back(limit);
    }
    std::string text;
    for (const long each : numbers) text += (text.empty() ? "" : ", ") + std::to_string(each);
    return value.starts_with('[') ? "[" + text + "]" : text;
}

/// Adds lines after each line that is `line`.
void add_after(std::string& toml, const std::string& line, const std::string& lines)
{
    for (auto at = toml.find(line + "\n"); at != std::string::npos; at = toml.find(line + "\n", at + line.size()))
        toml.insert(at + line.size() + 1, lines + "\n");
}

/// Adds lines to each series of a sampler that has none of the key, and has the other line.
void add_missing(std::string& toml, const std::string& sampler, const std::string& key, const std::string& value,
                 const std::string& other = "")
{
    const std::string line = "\nsampler = \"" + sampler + "\"\n";
    for (auto at = toml.find(line); at != std::string::npos; at = toml.find(line, at + 1)) {
        const std::string series = toml.substr(toml.rfind("[[", at), toml.find("\n[", at + 1) - toml.rfind("[[", at));
        if (series.find("\n" + key + " = ") == std::string::npos && series.find(other) != std::string::npos)
            toml.insert(at + line.size(), key + " = " + value + "\n");
    }
}

/// Comparisons of textures take seconds each, and so do times of full screens: two comparisons are left, of one
/// exemplar.
std::string with_two_comparisons(std::string toml)
{
    const std::string comparison = "compare = true\n";
    std::size_t at = 0;
    for (int kept = 0; kept < 2 && at != std::string::npos; ++kept) at = toml.find(comparison, at + 1);
    if (at == std::string::npos) return toml;
    while ((at = toml.find(comparison, at + 1)) != std::string::npos) toml.erase(at, comparison.size());
    static const std::regex head(R"(\n# [a-z]+\.png\n)");
    const auto parts = std::sregex_iterator(toml.begin(), toml.end(), head);
    if (std::distance(parts, {}) < 2) return toml;
    return std::regex_replace(toml.substr(0, static_cast<std::size_t>(std::next(parts)->position())),
                              std::regex("timing = true\n"), "");
}

}

std::string small_config(const std::string& whole)
{
    const std::string toml = with_two_comparisons(whole);
    const std::map<std::string, long> values = largest_values(toml);
    static const std::regex assignment(R"(\b([a-z_]+) = (\[[-0-9, ]*\]|[0-9]+))");
    std::string result;
    auto rest = toml.begin();
    for (auto found = std::sregex_iterator(toml.begin(), toml.end(), assignment); found != std::sregex_iterator();
         ++found) {
        const auto largest = values.find((*found)[1]);
        if (largest == values.end()) continue;
        result.append(rest, (*found)[2].first);
        result += limited((*found)[2], largest->second);
        rest = (*found)[2].second;
    }
    result.append(rest, toml.end());
    result = std::regex_replace(result, std::regex(R"(min_distance = \[.*\])"), "min_distance = [0.06, 0.05]");
    result = std::regex_replace(result, std::regex(R"(variant = \["P", "G"\])"), "variant = \"P\"");
    // Defaults that are large.
    static const std::regex tiles(R"(\nkind = "(corner|wang|omega|compact|marked|cross)[^"]*")");
    if (result.find("compare = true") == std::string::npos)
        add_after(result, "[[texture]]", "size = 16\ncandidates = 2");
    else
        result = std::regex_replace(result, tiles, "$&\nsize = 16\ncandidates = 2");
    add_missing(result, "averaged-tiles", "iterations", "2");
    for (const char* sampler : {"corner-tiles", "edge-tiles", "template-tiles"})
        add_missing(result, sampler, "points_per_tile", "16");
    // Repulsion reaches the distance after few of them; without it the tiles need them all.
    for (const char* sampler : {"corner-tiles", "edge-tiles", "template-tiles", "sphere-tiles"})
        add_missing(result, sampler, "lloyd_iterations", "3", "repulsion = true");
    add_missing(result, "gaussian-blue-noise", "iterations", "5");
    add_after(result, "sampler = \"recursive-wang-tiles\"", "points_per_tile = 128");
    return result;
}

}
