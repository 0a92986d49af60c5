#include "base/points/ply_header.hpp"

#include "base/files/byte_order.hpp"
#include "base/files/text_lines.hpp"

#include <charconv>
#include <cstdint>
#include <map>

namespace poissonlab {

namespace {

std::vector<std::string_view> words_of(std::string_view line)
{
    std::vector<std::string_view> words;
    for (WordReader reader(line); reader.next();) words.push_back(reader.word());
    return words;
}

/// Builds a header from its lines.
class HeaderReader
{
public:
    explicit HeaderReader(const PointFileContent& file) : file_(file) {}

    PlyHeader read()
    {
        LineReader lines(file_.bytes);
        lines.next(); // "ply", which brought us here
        while (lines.next()) {
            line_ = lines.number();
            const std::vector<std::string_view> words = words_of(lines.line());
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "end_header") {
                if (!has_format_) fail("end_header", "a line `format ...` must come before");
                header_.body = lines.rest();
                header_.lines = line_;
                return std::move(header_);
            }
            add(words, lines.line());
        }
        line_ = 0;
        fail("PLY header", "must end with a line `end_header`");
    }

private:
    void add(const std::vector<std::string_view>& words, std::string_view line)
    {
        if (words[0] == "format" && words.size() == 3) {
            set_format(words[1]);
        } else if (words[0] == "element" && words.size() == 3) {
            add_element(words[1], words[2]);
        } else if (words[0] == "property" && words.size() == 3) {
            add_property(words[1], words[2]);
        } else if (words[0] == "property" && words.size() == 5 && words[1] == "list") {
            add_list(words[2], words[3], words[4]);
        } else {
            fail(line, "must be a `format`, `element`, `property`, `comment` or `end_header` line of PLY");
        }
    }

    void set_format(std::string_view format)
    {
        header_.ascii = format == "ascii";
        header_.byte_order = format == "binary_big_endian" ? std::endian::big : std::endian::little;
        has_format_ = header_.ascii || format == "binary_little_endian" || format == "binary_big_endian";
        if (!has_format_) fail(format, "must be ascii, binary_little_endian or binary_big_endian");
    }

    void add_element(std::string_view name, std::string_view count_word)
    {
        std::size_t count = 0;
        const char* const end = count_word.data() + count_word.size();
        const auto [stop, error] = std::from_chars(count_word.data(), end, count);
        if (error != std::errc() || stop != end) fail(count_word, "must be a number of rows");
        PlyElement& element = header_.elements.emplace_back();
        element.name = name;
        element.count = count;
    }

    void add_property(std::string_view type_word, std::string_view name)
    {
        const PlyType type = type_of(type_word);
        PlyElement& element = current_element();
        element.columns.push_back({std::string(name), type, std::nullopt});
        element.properties.push_back({std::string(name), type, element.row_bytes});
        element.row_bytes += size_of(type);
    }

    void add_list(std::string_view count_word, std::string_view type_word, std::string_view name)
    {
        PlyElement& element = current_element();
        element.columns.push_back({std::string(name), type_of(type_word), type_of(count_word)});
        element.has_lists = true;
    }

    PlyType type_of(std::string_view word) const
    {
        static const std::map<std::string_view, PlyType> types{
            {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
            {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
            {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
            {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
            {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
            {"float64", PlyType::float64}};
        const auto type = types.find(word);
        if (type == types.end()) fail(word, "must be a type of PLY, such as float or double");
        return type->second;
    }

    PlyElement& current_element()
    {
        if (header_.elements.empty()) fail("property", "an `element` line must come before");
        return header_.elements.back();
    }

    [[noreturn]] void fail(std::string_view value, std::string_view allowed) const
    {
        fail_in_point_file(file_, line_, value, allowed);
    }

    const PointFileContent& file_;
    PlyHeader header_;
    bool has_format_ = false;
    int line_ = 1;
};

}

std::size_t size_of(PlyType type)
{
    switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
        return 1;
    case PlyType::int16:
    case PlyType::uint16:
        return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
        return 4;
    case PlyType::float64:
        return 8;
    }
    return 0;
}

double load_ply_value(std::string_view bytes, PlyType type, std::endian order)
{
    switch (type) {
    case PlyType::int8:
        return load<std::int8_t>(bytes, order);
    case PlyType::uint8:
        return load<std::uint8_t>(bytes, order);
    case PlyType::int16:
        return load<std::int16_t>(bytes, order);
    case PlyType::uint16:
        return load<std::uint16_t>(bytes, order);
    case PlyType::int32:
        return load<std::int32_t>(bytes, order);
    case PlyType::uint32:
        return load<std::uint32_t>(bytes, order);
    case PlyType::float32:
        return load<float>(bytes, order);
    case PlyType::float64:
        return load<double>(bytes, order);
    }
    return 0;
}

PlyHeader read_ply_header(const PointFileContent& file) { return HeaderReader(file).read(); }

}
