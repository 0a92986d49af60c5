// Numbers are int32 and float32, big-endian.
#include "base/surfaces/off_binary.hpp"

#include "base/errors/errors.hpp"
#include "base/files/byte_order.hpp"
#include "base/files/text_lines.hpp"
#include "base/surfaces/off_keyword.hpp"
#include "base/text/noun.hpp"

#include <fmt/format.h>

#include <cmath>

namespace poissonlab {
namespace {

class BinaryOffReader
{
public:
    explicit BinaryOffReader(const MeshBytes& file) : file_(file) {}

    PolygonSoup read()
    {
        LineReader lines(file_.bytes);
        lines.next();
        WordReader words(lines.line());
        words.next();
        keyword_ = off_keyword(words.word()).value();
        left_ = lines.rest();
        if (keyword_.has_dimension && integer("the dimension") != 3)
            fail("vertices of nOFF must have three coordinates");
        vertices_ = count("the number of vertices");
        const std::size_t faces = count("the number of faces");
        count("the number of edges");
        for (std::size_t i = 0; i < vertices_; ++i) read_vertex(i);
        for (std::size_t i = 0; i < faces; ++i) read_face(i);
        if (!left_.empty())
            fail(fmt::format("has {} {} after the last of {} {} and {} {}, which its head announces", left_.size(),
                             noun(left_.size(), "byte"), vertices_, noun(vertices_, "vertex", "vertices"), faces,
                             noun(faces, "face")));
        return std::move(soup_);
    }

private:
    void read_vertex(std::size_t i)
    {
        MeshPoint point{};
        for (double& c : point) c = number(i);
        const double weight = keyword_.has_weights ? number(i) : 1;
        if (!is_divided(point, weight)) fail(fmt::format("vertex {} has a coordinate that is not a finite number", i));
        const int others = 3 * keyword_.has_normals + 4 * keyword_.has_colors + 2 * keyword_.has_texture;
        for (int k = 0; k < others; ++k) number(i);
        soup_.points.push_back(point);
    }

    void read_face(std::size_t i)
    {
        const std::size_t size = count("the number of corners");
        for (std::size_t k = 0; k < size; ++k) {
            const std::int32_t corner = integer("a corner of a face");
            if (corner < 0 || static_cast<std::size_t>(corner) >= vertices_)
                fail(fmt::format("face {} has vertex {}, which is not there: they are 0 to {}", i, corner,
                                 static_cast<std::int64_t>(vertices_) - 1));
            soup_.corners.push_back(static_cast<std::uint32_t>(corner));
        }
        soup_.sizes.push_back(static_cast<std::uint32_t>(size));
        const std::size_t colors = count("the number of colours of a face");
        for (std::size_t k = 0; k < colors; ++k) number(i);
    }

    std::size_t count(std::string_view name)
    {
        const std::int32_t value = integer(name);
        if (value < 0) fail(fmt::format("{} is {}: must be at least 0", name, value));
        return static_cast<std::size_t>(value);
    }

    std::int32_t integer(std::string_view name)
    {
        if (left_.size() < 4) fail(fmt::format("ends before {}", name));
        const auto value = load<std::int32_t>(left_, std::endian::big);
        left_.remove_prefix(4);
        return value;
    }

    double number(std::size_t row)
    {
        if (left_.size() < 4) fail(fmt::format("ends within vertex or face {}", row));
        const auto value = load<float>(left_, std::endian::big);
        left_.remove_prefix(4);
        return static_cast<double>(value);
    }

    [[noreturn]] void fail(const std::string& problem) const { throw InputError::at({file_.name}, problem); }

    const MeshBytes& file_;
    std::string_view left_;
    OffKeyword keyword_;
    std::size_t vertices_ = 0;
    PolygonSoup soup_;
};

}

bool is_binary_off(std::string_view bytes)
{
    WordReader words(bytes.substr(0, std::min(bytes.size(), bytes.find('\n'))));
    if (!words.next() || !off_keyword(words.word()) || !words.next()) return false;
    return words.word() == "BINARY" || words.word() == "BINARY\r";
}

PolygonSoup read_binary_off(const MeshBytes& file) { return BinaryOffReader(file).read(); }

}
