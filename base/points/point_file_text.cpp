// Reads point sets from text: one point a line, realizations separated by a line with `#` alone, or tables.
#include "base/files/text_lines.hpp"
#include "base/points/point_file_formats.hpp"
#include "base/points/text_table.hpp"
#include "base/points/unit_coordinates.hpp"
#include "base/text/decimal_commas.hpp"

#include <fmt/format.h>

namespace poissonlab {

namespace {

/// Collects the points of a text file, and sees that they fit together.
class TextPoints
{
public:
    explicit TextPoints(const PointFileContent& file) : file_(file), table_(file), units_(file) {}

    /// The points of one set go on in pieces, and are not kept.
    TextPoints(const PointFileContent& file, const PieceSink& sink)
        : file_(file), table_(file), units_(file), sink_(&sink)
    {}

    /// Hands on what there is, unless it is still little: up to `place` of the file.
    void hand_on(const char* place, std::size_t least)
    {
        if (current_.size() <= least) return;
        if (!units_.are_refused()) (*sink_)(dimension_, current_, place);
        handed_on_ += current_.size();
        current_.clear();
    }

    void finish_pieces()
    {
        hand_on(file_.bytes.data() + file_.bytes.size(), 0);
        if (handed_on_ == 0) fail_without_points();
        check_degrees();
        units_.finish();
        const std::string points = std::to_string(handed_on_ / static_cast<std::size_t>(dimension_));
        if (!announced_.empty() && announced_ != points)
            fail_in_point_file(file_, announced_line_, announced_, "is not the number of points, which is " + points);
    }

    void add_line(std::string_view line, int number, std::string_view rest)
    {
        const std::string_view text = trimmed(line);
        if (text.empty()) return;
        if (text == "#") {
            end_realization(number);
        } else if (text.front() != '#') {
            add_point(text, number, rest);
        }
    }

    std::vector<PointSet> finish()
    {
        if (!current_.empty()) store();
        check_degrees();
        units_.finish();
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

    void check_degrees() const
    {
        constexpr double most_longitude = 360;
        if (table_.degrees_line() > 0)
            units_.check_degrees({table_.degrees_line(), table_.names_in_words()}, most_longitude,
                                 "columns of lengths are named x and y");
    }

    void add_point(std::string_view text, int line, std::string_view rest)
    {
        if (is_announced_number(text)) {
            announced_line_ = line;
            announced_ = text;
            return;
        }
        if (has_ended_) fail_in_point_file(file_, line, text, "a file that is read in pieces has one set");
        if (is_before_points() && table_.takes(text, line, rest)) return;
        const auto words = table_.coordinates(text, line);
        const auto count = static_cast<int>(words.size());
        for (std::size_t axis = 0; axis < words.size(); ++axis) {
            const double value = number_in(file_, line, words[axis]);
            if (axis < 3)
                current_.push_back(units_(value, axis, 0, [&] {
                    return CoordinatePlace{line, std::string(words[axis])};
                }));
        }
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
        if (file_.has_classes()) file_.classes.take(table_.class_name());
    }

    bool is_before_points() const { return current_.empty() && sets_.empty() && handed_on_ == 0; }

    /// The number of points alone, before all of them.
    bool is_announced_number(std::string_view text) const
    {
        return is_before_points() && announced_.empty() && text.find_first_not_of("0123456789") == text.npos;
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
    TextTable table_;
    UnitCoordinates units_;
    std::vector<PointSet> sets_;
    std::vector<double> current_;
    int dimension_ = 0;
    std::string_view announced_; ///< the number of points, as the file says
    int announced_line_ = 0;
    const PieceSink* sink_ = nullptr;
    std::size_t handed_on_ = 0; ///< coordinates
    bool has_ended_ = false;    ///< the set that is handed on
};

}

void stream_text_points(const PointFileContent& file, const PieceSink& sink)
{
    constexpr std::size_t numbers_of_piece = std::size_t{1} << 19;
    TextPoints points(file, sink);
    for (LineReader lines(file.bytes); lines.next();) {
        points.add_line(lines.line(), lines.number(), lines.rest());
        points.hand_on(lines.rest().data(), numbers_of_piece);
    }
    points.finish_pieces();
}

std::vector<PointSet> read_text_points(const PointFileContent& file)
{
    TextPoints points(file);
    for (LineReader lines(file.bytes); lines.next();) points.add_line(lines.line(), lines.number(), lines.rest());
    return points.finish();
}

}
