#include "reports/plots/key_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>

namespace poissonlab {

namespace {

using Lines = std::vector<std::string>;

constexpr auto ellipsis = "…";
constexpr auto indent = "    "; // of second lines
constexpr double least_first_line = 0.4;

// Advance widths of DejaVu Sans from blank to tilde, in thousandths of the font size.
constexpr std::array<int, 95> ascii_widths = {
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
constexpr int blank_width = 318;
constexpr int two_byte_width = 950; // hardly any letter of Latin, Greek or Cyrillic is wider
constexpr int wide_width = 1250;    // symbols, and letters of scripts that other fonts have

// The end of the character that begins at `begin`.
std::size_t next_character(const std::string& text, std::size_t begin)
{
    std::size_t end = begin + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U) ++end;
    return end;
}

double character_width(const std::string& text, std::size_t begin)
{
    const auto first = static_cast<unsigned char>(text[begin]);
    int width = blank_width; // control characters are drawn as blanks
    if (first >= ' ' && first <= '~')
        width = ascii_widths[first - std::size_t{' '}];
    else if (first >= 0xe0)
        width = wide_width;
    else if (first >= 0x7f)
        width = two_byte_width;
    return width / 1000.0;
}

// The longest prefix, in whole characters, that is at most so wide.
std::string widest_prefix(const std::string& text, double width)
{
    std::size_t end = 0;
    while (end < text.size() && (width -= character_width(text, end)) >= 0) end = next_character(text, end);
    return text.substr(0, end);
}

std::string widest_suffix(const std::string& text, double width)
{
    double rest = text_width(text);
    std::size_t begin = 0;
    while (begin < text.size() && rest > width) {
        rest -= character_width(text, begin);
        begin = next_character(text, begin);
    }
    return text.substr(begin);
}

std::string trimmed(std::string text)
{
    while (text.starts_with(' ')) text.erase(0, 1);
    while (text.ends_with(' ')) text.pop_back();
    return text;
}

// The text with an ellipsis where it is too wide; `share` of the room is for its beginning.
std::string shortened(const std::string& text, double width, double share)
{
    if (text_width(text) <= width) return text;
    const double room = width - text_width(ellipsis);
    auto begin = widest_prefix(text, share * room);
    auto end = widest_suffix(text, room - text_width(begin));
    // Whole words where that costs little.
    if (const auto blank = begin.rfind(' '); blank != std::string::npos && 2 * blank > begin.size())
        begin.resize(blank + 1);
    if (const auto blank = end.find(' '); blank != std::string::npos && 3 * blank < end.size()) end.erase(0, blank);
    return begin + ellipsis + end;
}

// Where lines may end, best first.
const std::vector<std::string> commas = {", "};
const std::vector<std::string> commas_and_blanks = {", ", " "};

// Where the first line ends: behind the last of the marks that leaves it neither too wide nor very short; the
// first kind of mark that there is decides. With `rest_width`, only where the rest is at most so wide.
std::optional<std::size_t> line_end(const std::string& label, double width, const std::vector<std::string>& marks,
                                    std::optional<double> rest_width = {})
{
    for (const std::string& mark : marks) {
        std::optional<std::size_t> found;
        for (auto at = label.find(mark); at != std::string::npos; at = label.find(mark, at + 1)) {
            const std::size_t end = at + mark.size() - 1; // without the blank
            const double first = text_width(label.substr(0, end));
            if (first < least_first_line * width) continue;
            if (first > width) break;
            if (!rest_width || text_width(trimmed(label.substr(end))) <= *rest_width) found = end;
        }
        if (found) return found;
    }
    return {};
}

double second_line_width(double width) { return width - text_width(indent); }

// The label in one line or two without an ellipsis; nothing where that does not do.
std::optional<Lines> unshortened(const std::string& label, double width, const std::vector<std::string>& marks)
{
    if (text_width(label) <= width) return Lines{label};
    const auto end = line_end(label, width, marks, second_line_width(width));
    if (!end) return {};
    return Lines{label.substr(0, *end), indent + trimmed(label.substr(*end))};
}

// In two lines, with an ellipsis in the second if need be, and with `suffix` at the end.
Lines in_two_lines(const std::string& label, double width, double share, const std::string& suffix)
{
    if (const auto lines = unshortened(label + suffix, width, commas_and_blanks)) return *lines;
    const auto end = line_end(label, width, commas_and_blanks).value_or(widest_prefix(label, width).size());
    const double room = second_line_width(width) - text_width(suffix);
    return {label.substr(0, end), indent + shortened(trimmed(label.substr(end)), room, share) + suffix};
}

// The width of texts at a scale, in units of their font size.
double width_at(double scale, const KeyRoom& room)
{
    return (room.width - scale * room.sample_size) / (scale * room.font_size);
}

using LineUp = std::function<std::optional<Lines>(std::size_t index)>;

std::optional<std::vector<Lines>> line_up(std::size_t count, const LineUp& one)
{
    std::vector<Lines> result;
    for (std::size_t i = 0; i < count; ++i) {
        auto lines = one(i);
        if (!lines) return {};
        result.push_back(std::move(*lines));
    }
    return result;
}

// Whether labels that differ have lines that differ.
bool all_told_apart(const std::vector<std::string>& labels, const std::vector<Lines>& lines)
{
    std::map<Lines, std::string> label_of;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (label_of.emplace(lines[i], labels[i]).first->second != labels[i]) return false;
    return true;
}

}

double text_width(const std::string& text)
{
    double width = 0;
    for (std::size_t at = 0; at < text.size(); at = next_character(text, at)) width += character_width(text, at);
    return width;
}

KeyLayout lay_out_key(const std::vector<std::string>& labels, const KeyRoom& room)
{
    double widest = 0;
    for (const auto& label : labels) widest = std::max(widest, text_width(label));
    const double one_line = room.width / (widest * room.font_size + room.sample_size) * (1 - 1e-9);
    if (one_line >= least_key_scale) {
        KeyLayout layout{std::min(one_line, 1.0), {}};
        for (const auto& label : labels) layout.lines.push_back({label});
        return layout;
    }

    for (const auto& marks : {commas, commas_and_blanks})
        for (int percent = 100; percent >= 65; percent -= 5) {
            const double scale = percent / 100.0;
            const auto lines = line_up(
                labels.size(), [&](std::size_t i) { return unshortened(labels[i], width_at(scale, room), marks); });
            if (lines && all_told_apart(labels, *lines)) return {scale, *lines};
        }

    const double width = width_at(least_key_scale, room);
    for (const double share : {0.5, 0.3, 0.7, 0.1, 0.9}) {
        const auto lines =
            line_up(labels.size(), [&](std::size_t i) { return in_two_lines(labels[i], width, share, ""); });
        if (all_told_apart(labels, *lines)) return {least_key_scale, *lines};
    }
    const auto numbered = line_up(
        labels.size(), [&](std::size_t i) { return in_two_lines(labels[i], width, 0.5, fmt::format(" [{}]", i + 1)); });
    return {least_key_scale, *numbered};
}

}
