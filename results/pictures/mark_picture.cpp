#include "results/pictures/mark_picture.hpp"

#include "base/files/json_file.hpp"
#include "base/files/json_members.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace poissonlab {
namespace {

constexpr const char* mark_format = "poissonlab-marks";
constexpr int mark_format_version = 1;
constexpr int most_mark_pixels = 32'768;

/// All numbers in one list, mark after mark.
template <std::size_t n>
void flat(JsonMembers& m, const std::string& name, const std::vector<std::array<double, n>>& marks)
{
    std::vector<double> numbers;
    for (const auto& mark : marks) numbers.insert(numbers.end(), mark.begin(), mark.end());
    m.member(name, std::as_const(numbers));
}

template <std::size_t n>
void flat(JsonMembers& m, const std::string& name, std::vector<std::array<double, n>>& marks)
{
    const std::vector<double> numbers = m.stored().numbers(name);
    if (numbers.size() % n != 0) throw m.stored().error(name, fmt::format("must have {} numbers for each mark", n));
    marks.resize(numbers.size() / n);
    for (std::size_t i = 0; i < numbers.size(); ++i) marks[i / n][i % n] = numbers[i];
}

/// All numbers in one list: of each polygon the number of its corners, then these. Absent where there are none.
void polygons(JsonMembers& m, const std::vector<std::vector<std::array<double, 2>>>& polygons)
{
    std::vector<double> numbers;
    for (const auto& polygon : polygons) {
        numbers.push_back(static_cast<double>(polygon.size()));
        for (const auto& corner : polygon) numbers.insert(numbers.end(), corner.begin(), corner.end());
    }
    m.if_any("polygons", std::as_const(numbers));
}

void polygons(JsonMembers& m, std::vector<std::vector<std::array<double, 2>>>& polygons)
{
    polygons.clear();
    if (!m.stored().has("polygons")) return;
    const std::vector<double> numbers = m.stored().numbers("polygons");
    for (std::size_t at = 0; at < numbers.size();) {
        const double corners = numbers[at++];
        if (!(corners >= 3 && corners <= static_cast<double>(numbers.size() - at) / 2))
            throw m.stored().error("polygons", "must have the number of corners, from 3, and two numbers for each");
        polygons.emplace_back();
        for (; static_cast<double>(polygons.back().size()) < corners; at += 2)
            polygons.back().push_back({numbers[at], numbers[at + 1]});
    }
}

bool is_color(const std::string& text)
{
    return text.size() == 7 && text[0] == '#' && text.find_first_not_of("0123456789abcdef", 1) == std::string::npos;
}

void describe_group(JsonMembers& m, Stored<MarkGroup> auto& group)
{
    m.member("color", group.color);
    polygons(m, group.polygons);
    flat(m, "disks", group.disks);
    flat(m, "strokes", group.strokes);
    m.check([&](const StoredObject& object) {
        if (!is_color(group.color)) throw object.error("color", "must be #rrggbb");
    });
}

void describe_words(JsonMembers& m, Stored<MarkWords> auto& words)
{
    m.member("x", words.place[0]);
    m.member("y", words.place[1]);
    m.member("size", words.size);
    m.member("words", words.words);
}

void describe_marks(JsonMembers& m, Stored<MarkPicture> auto& picture)
{
    m.format(mark_format, mark_format_version);
    m.member("width", picture.width);
    m.member("height", picture.height);
    m.member("pixels", picture.pixels, 1);
    m.if_any("ground", picture.ground);
    m.objects("groups", picture.groups, [](JsonMembers& n, auto& group) { describe_group(n, group); });
    m.objects("words", picture.words, [](JsonMembers& n, auto& words) { describe_words(n, words); });
    m.check([&](const StoredObject& object) {
        if (!(picture.width > 0 && picture.height > 0))
            throw object.error("width", "must be a rectangle with an inside");
        if (picture.pixels > most_mark_pixels)
            throw object.error("pixels", fmt::format("must be at most {}", most_mark_pixels));
    });
}

}

std::string mark_picture_json(const MarkPicture& picture)
{
    return json_text([&](JsonMembers& root) { describe_marks(root, picture); }) + "\n";
}

MarkPicture read_mark_picture(const std::filesystem::path& file)
{
    const nlohmann::json json = read_json_file(file);
    JsonMembers root(StoredObject(json, file));
    MarkPicture picture;
    describe_marks(root, picture);
    return picture;
}

}
