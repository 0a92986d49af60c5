#include "tests/reports/support/page_text.hpp"

#include "base/files/whole_file.hpp"

#include <regex>
#include <set>

namespace poissonlab::test {

namespace fs = std::filesystem;

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

std::map<std::string, std::string> pages_below(const fs::path& folder)
{
    std::map<std::string, std::string> pages;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".html")
            pages[entry.path().lexically_relative(folder).string()] = read_whole_file(entry.path());
    return pages;
}

namespace {

std::string link_errors(const fs::path& folder, const std::string& page, const std::set<std::string>& ids)
{
    std::string errors;
    for (const char* attribute : {"href", "src"})
        for (const auto& link : attribute_values(page, attribute)) {
            if (link == "data:,") continue; // no icon
            const bool good = link.starts_with('#') ? ids.contains(link.substr(1))
                                                    : fs::is_regular_file(folder / link.substr(0, link.find('#')));
            if (!good) errors += std::string(attribute) + " " + link + "\n";
        }
    return errors;
}

std::string page_errors(const fs::path& folder, const std::string& page)
{
    auto errors = first_markup_error(page);
    std::set<std::string> ids;
    for (const auto& id : attribute_values(page, "id"))
        if (!ids.insert(id).second) errors += "id twice: " + id + "\n";
    errors += link_errors(folder, page, ids);
    for (const char* word : {"http:", "https:", "url(", "@import"})
        if (page.find(word) != std::string::npos) errors += std::string(word) + "\n";
    for (const auto& alt : attribute_values(page, "alt"))
        if (alt.size() <= 10) errors += "alt " + alt + "\n";
    if (attribute_values(page, "alt").size() != count_of(page, "<img ")) errors += "an image without alt\n";
    if (page.find("<title></title>") != std::string::npos) errors += "no title\n";
    return errors;
}

}

std::string site_errors(const fs::path& folder)
{
    std::string errors;
    for (const auto& [name, page] : pages_below(folder))
        if (const auto found = page_errors((folder / name).parent_path(), page); !found.empty())
            errors += name + ": " + found + "\n";
    return errors;
}

std::size_t count_of(const std::string& text, const std::string& part)
{
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

}
