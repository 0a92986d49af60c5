// The numbers in the rows of a PLY file, of text or binary.
#pragma once

#include "base/points/ply_header.hpp"
#include "base/surfaces/mesh_words.hpp"

#include <optional>

namespace poissonlab {

/// Goes through the rows of all elements, one after the other. Throws InputError.
class PlyRows
{
public:
    /// `header` must live as long.
    PlyRows(const std::string& file, const PlyHeader& header);

    /// Moves to the first or next row of an element of the header. Where its rows do not fit in what is left of the
    /// file, the first one is refused.
    void next_row(const PlyElement& element, std::size_t row);
    /// The next number of the row.
    double value(PlyType type);
    /// Reads how many numbers of that type follow.
    std::size_t count(PlyType type, PlyType of);
    /// Ends the row, of which nothing may be left.
    void end_row();
    /// Ends the file, of which nothing may be left.
    void end_file();

    /// Throws InputError for the row.
    [[noreturn]] void fail(const std::string& problem) const;

private:
    void check_room(const PlyElement& element) const;

    const std::string file_;
    const PlyHeader& header_;
    std::optional<MeshWords> words_; ///< of text
    std::string_view left_;          ///< of a binary file
    const PlyElement* element_ = nullptr;
    std::size_t row_ = 0;
};

}
