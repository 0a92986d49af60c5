#include "base/surfaces/ply_rows.hpp"

#include "base/errors/errors.hpp"
#include "base/text/decimal_commas.hpp"
#include "base/text/noun.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {

PlyRows::PlyRows(const std::string& file, const PlyHeader& header) : file_(file), header_(header), left_(header.body)
{
    if (header.ascii) words_.emplace(file, header.body, MeshWords::Lines::plain, header.lines);
}

void PlyRows::check_room(const PlyElement& element) const
{
    const std::size_t left = words_ ? words_->bytes_left() + 1 : left_.size();
    std::size_t least = element.row_bytes; // of text, each number takes two bytes, but for the last one
    for (const PlyColumn& column : element.columns)
        if (column.count && !words_) least += size_of(*column.count);
    if (words_) least = 2 * element.columns.size();
    if (least > 0 && element.count > left / least)
        throw InputError::at({file_}, fmt::format("the file ends before the {} {} of the element `{}`, which its "
                                                  "header announces",
                                                  element.count, noun(element.count, "row"), element.name));
}

void PlyRows::next_row(const PlyElement& element, std::size_t row)
{
    element_ = &element;
    row_ = row;
    if (row == 0) check_room(element);
    if (words_ && !words_->next_filled_line())
        fail(fmt::format("the file ends before it: the header announces {} {}", element.count,
                         noun(element.count, "row")));
}

double PlyRows::value(PlyType type)
{
    if (words_) {
        if (!words_->next()) fail("has fewer numbers than the header announces");
        double number = 0;
        if (!parse_number(words_->word(), number))
            fail(fmt::format("\"{}\": must be a number{}", shortened(words_->word()),
                             decimal_comma_words(words_->word())));
        return type == PlyType::float32 ? static_cast<double>(static_cast<float>(number)) : number;
    }
    if (left_.size() < size_of(type)) fail("the file ends within it");
    const double number = load_ply_value(left_, type, header_.byte_order);
    left_.remove_prefix(size_of(type));
    return number;
}

std::size_t PlyRows::count(PlyType type, PlyType of)
{
    const double number = value(type);
    if (!(number >= 0) || number != std::floor(number) || number > static_cast<double>(UINT32_MAX))
        fail(fmt::format("{}: a list must have a whole number of entries", number));
    const auto count = static_cast<std::size_t>(number);
    if (!words_ && count > left_.size() / size_of(of))
        fail(fmt::format("the file ends before the {} {} of a list", count, noun(count, "entry", "entries")));
    return count;
}

void PlyRows::end_row()
{
    if (words_ && words_->next())
        fail(fmt::format("\"{}\": is more than the properties that the header announces", shortened(words_->word())));
}

void PlyRows::end_file()
{
    if (words_) {
        if (words_->next_filled_line() && words_->next())
            words_->fail(
                fmt::format("\"{}\": stands after the last row that the header announces", shortened(words_->word())));
    } else if (!left_.empty()) {
        throw InputError::at({file_}, fmt::format("has {} {} after the last row that its header announces",
                                                  left_.size(), noun(left_.size(), "byte")));
    }
}

void PlyRows::fail(const std::string& problem) const
{
    throw InputError::at({file_, words_ ? words_->line() : 0},
                         fmt::format("row {} of the element `{}`: {}", row_ + 1, element_->name, problem));
}

}
