#include "host/settings/keys/command_words.hpp"

#include <algorithm>
#include <cctype>

namespace poissonlab {

std::string in_words_of_commands(const std::string& text,
                                 const std::function<std::string(const std::string& key)>& name_of)
{
    const auto is_letter = [&](std::size_t i) {
        return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
    };
    std::string words;
    int braces = 0;
    for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end) {
        for (end = begin; is_letter(end);) ++end;
        const std::string word = text.substr(begin, std::max<std::size_t>(end - begin, 1));
        end = begin + word.size();
        braces += word == "{" ? 1 : word == "}" ? -1 : 0;
        const bool has_value = text.compare(end, 3, " = ") == 0;
        const bool may_be_key = braces == 0 && (has_value || word.find('_') != std::string::npos);
        const std::string name = may_be_key ? name_of(word) : "";
        words += name.empty() ? word : name;
        if (!name.empty() && has_value) end += 2;
    }
    return words;
}

}
