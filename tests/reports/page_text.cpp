#include "page_text.hpp"

#include <regex>
#include <stdexcept>

namespace poissonlab::test {

namespace {

// The attributes of a tag: name="value", nothing else.
bool attributes_are_quoted(const std::string& text)
{
    static const std::regex attributes("(\\s+[a-z-]+=\"[^\"<]*\")*\\s*");
    return std::regex_match(text, attributes);
}

}

std::string first_markup_error(const std::string& page)
{
    const auto text = without_data_uris(page);
    std::vector<std::string> open;
    for (auto at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const auto end = text.find('>', at);
        if (end == std::string::npos) return "a tag without end: " + text.substr(at, 40);
        auto tag = text.substr(at + 1, end - at - 1);
        if (tag.starts_with('!')) continue;
        if (tag.starts_with('/')) {
            if (open.empty() || open.back() != tag.substr(1)) return "unexpected <" + tag + ">";
            open.pop_back();
            continue;
        }
        const bool is_void = tag.ends_with('/');
        if (is_void) tag.pop_back();
        const auto name = tag.substr(0, tag.find_first_of(" \n"));
        if (!attributes_are_quoted(tag.substr(name.size()))) return "bad attributes: <" + tag + ">";
        if (!is_void) open.push_back(name);
    }
    return open.empty() ? "" : "never closed: <" + open.back() + ">";
}

std::vector<std::string> attribute_values(const std::string& page, const std::string& name)
{
    std::vector<std::string> values;
    const auto key = " " + name + "=\"";
    for (auto at = page.find(key); at != std::string::npos; at = page.find(key, at + 1)) {
        const auto begin = at + key.size();
        values.push_back(page.substr(begin, page.find('"', begin) - begin));
    }
    return values;
}

std::string without_data_uris(const std::string& page)
{
    const std::string mark = ";base64,";
    std::string result;
    std::size_t copied = 0;
    for (auto at = page.find(mark); at != std::string::npos; at = page.find(mark, copied)) {
        result += page.substr(copied, at + mark.size() - copied);
        copied = page.find('"', at);
    }
    return result + page.substr(copied);
}

std::string decode_data_uri(const std::string& uri)
{
    const std::string mark = ";base64,";
    const auto begin = uri.find(mark);
    if (!uri.starts_with("data:") || begin == std::string::npos)
        throw std::runtime_error("not a data URI: " + uri.substr(0, 60));
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned buffer = 0;
    int bits = 0;
    for (auto i = begin + mark.size(); i < uri.size() && uri[i] != '='; ++i) {
        const auto digit = alphabet.find(uri[i]);
        if (digit == std::string::npos) throw std::runtime_error("not base64");
        buffer = (buffer << 6 | static_cast<unsigned>(digit)) & 0xffffU;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(buffer >> bits & 0xffU);
    }
    return bytes;
}

}
