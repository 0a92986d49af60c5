// Reads point sets from text: one point a line, realizations separated by a line with `#` alone, or CSV.
#include "base/files/text_lines.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/text/decimal_commas.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {

namespace {

/// Collects the points of a text file, and sees that they fit together.
class TextPoints
{
public:
    explicit TextPoints(const PointFileContent& file) : file_(file) {}

    /// The points of one set go on in pieces, and are not kept.
    TextPoints(const PointFileContent& file, const PieceSink& sink) : file_(file), sink_(&sink) {}

    /// Hands on what there is, unless it is still little: up to `place` of the file.
    void hand_on(const char* place, std::size_t least)
    {
        if (current_.size() <= least) return;
        (*sink_)(dimension_, current_, place);
        handed_on_ += current_.size();
        current_.clear();
    }

    void finish_pieces()
    {
        hand_on(file_.bytes.data() + file_.bytes.size(), 0);
        if (handed_on_ == 0) fail_without_points();
        const std::string points = std::to_string(handed_on_ / static_cast<std::size_t>(dimension_));
        if (!announced_.empty() && announced_ != points)
            fail_in_point_file(file_, announced_line_, announced_, "is not the number of points, which is " + points);
    }

    void add_line(std::string_view line, int number)
    {
        const std::string_view text = trimmed(line);
        if (text.empty()) return;
        if (text == "#") {
            end_realization(number);
        } else if (text.front() != '#' && !is_header(text)) {
            add_point(text, number);
        }
    }

    std::vector<PointSet> finish()
    {
        if (!current_.empty()) store();
        check_announced_number();
        if (sets_.empty()) fail_without_points();
        return std::move(sets_);
    }

private:
    [[noreturn]] void fail_without_points() const
    {
        fail_in_point_file(file_, 0, "no points",
                           fmt::format("must have one point a line, 2 or 3 coordinates in [{}, {})",
                                       file_.domain[0].low, file_.domain[0].high));
    }

    void add_point(std::string_view text, int line)
    {
        if (is_announced_number(text)) {
            announced_line_ = line;
            announced_ = text;
            return;
        }
        if (has_ended_) fail_in_point_file(file_, line, text, "a file that is read in pieces has one set");
        check_commas(text, line);
        const std::size_t before = current_.size();
        for (WordReader words(text); words.next();)
            append_coordinate(file_, line, current_.size() - before, words.word(), current_);
        const auto count = static_cast<int>(current_.size() - before);

        if (count != 2 && count != 3) {
            fail_in_point_file(file_, line, fmt::format("{} coordinate{}", count, count == 1 ? "" : "s"),
                               "a point has 2 or 3; a line that is not a point starts with `# `" +
                                   decimal_comma_words(text));
        }
        if (dimension_ == 0) dimension_ = count;
        if (count != dimension_) {
            fail_in_point_file(file_, line, fmt::format("{} coordinates", count),
                               fmt::format("must be {}, as on the lines before", dimension_));
        }
    }

    /// Throws where commas stand within numbers, as many languages write decimals: "12,5 7" is no point in space.
    void check_commas(std::string_view text, int line) const
    {
        const std::string_view number = decimal_comma_in(text);
        if (number.empty()) return;
        const bool has_other_separators = std::ranges::any_of(text, [&](const char& c) {
            const bool is_beside_comma =
                (&c > text.data() && *(&c - 1) == ',') || (&c < &text.back() && *(&c + 1) == ',');
            return c == ';' || ((c == ' ' || c == '\t') && !is_beside_comma);
        });
        if (has_other_separators)
            fail_in_point_file(file_, line, text, "commas separate numbers" + decimal_comma_words(text));
    }

    /// The names of columns, before all points.
    bool is_header(std::string_view text) const
    {
        return current_.empty() && sets_.empty() && handed_on_ == 0 && (text == csv_header_2d || text == csv_header_3d);
    }

    /// The number of points alone, before all of them.
    bool is_announced_number(std::string_view text) const
    {
        return current_.empty() && sets_.empty() && handed_on_ == 0 && announced_.empty() &&
               text.find_first_not_of("0123456789") == text.npos;
    }

    void check_announced_number() const
    {
        if (announced_.empty()) return;
        const std::size_t points = sets_.empty() ? 0 : sets_.front().size();
        if (sets_.size() < 2 && announced_ == std::to_string(points)) return;
        fail_in_point_file(file_, announced_line_, announced_,
                           sets_.size() < 2 ? fmt::format("is not the number of points, which is {}", points)
                                            : "the number of points can only be in a file of one set");
    }

    /// A separator is allowed before the first and after the last realization, too.
    void end_realization(int line)
    {
        if (sink_) {
            if (current_.empty() && handed_on_ == 0) return;
            has_ended_ = true; // a separator may stand at the end
            return;
        }
        if (current_.empty() && !sets_.empty()) {
            fail_in_point_file(file_, line, "#", "there must be points between two lines with `#` alone");
        }
        if (!current_.empty()) store();
    }

    void store()
    {
        sets_.push_back({dimension_, std::move(current_)});
        current_ = {};
    }

    const PointFileContent& file_;
    std::vector<PointSet> sets_;
    std::vector<double> current_;
    int dimension_ = 0;
    std::string_view announced_; ///< the number of points, as the file says
    int announced_line_ = 0;
    const PieceSink* sink_ = nullptr;
    std::size_t handed_on_ = 0; ///< coordinates
    bool has_ended_ = false;    ///< the set that is handed on
};

/// Editors of some systems put a byte order mark in front.
std::string_view without_mark(std::string_view text)
{
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    return text;
}

}

void stream_text_points(const PointFileContent& file, const PieceSink& sink)
{
    constexpr std::size_t numbers_of_piece = std::size_t{1} << 19;
    TextPoints points(file, sink);
    for (LineReader lines(without_mark(file.bytes)); lines.next();) {
        points.add_line(lines.line(), lines.number());
        points.hand_on(lines.rest().data(), numbers_of_piece);
    }
    points.finish_pieces();
}

std::vector<PointSet> read_text_points(const PointFileContent& file)
{
    TextPoints points(file);
    for (LineReader lines(without_mark(file.bytes)); lines.next();) points.add_line(lines.line(), lines.number());
    return points.finish();
}

}
