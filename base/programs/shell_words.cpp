#include "base/programs/shell_words.hpp"

#include <filesystem>
#include <string_view>

namespace poissonlab {
namespace {

constexpr std::string_view blanks = " \t\n";

/// Reads words off a text from front to back.
class ShellWordReader
{
public:
    explicit ShellWordReader(std::string_view text) : text_(text) {}

    /// Goes to the next word; false if there is none.
    bool skip_blanks()
    {
        while (at_ < text_.size() && blanks.find(text_[at_]) != std::string_view::npos) ++at_;
        return at_ < text_.size();
    }

    /// The word that begins here; false where it has no end.
    bool read(std::string& word)
    {
        while (at_ < text_.size() && blanks.find(text_[at_]) == std::string_view::npos) {
            const char c = text_[at_++];
            if (c == '\'' ? !read_verbatim(word) : c == '"' ? !read_quoted(word) : !read_plain(c, word)) return false;
        }
        return true;
    }

private:
    bool read_plain(char c, std::string& word)
    {
        if (c == '\\') {
            if (at_ == text_.size()) return false;
            c = text_[at_++];
        }
        word += c;
        return true;
    }

    bool read_verbatim(std::string& word)
    {
        const std::size_t end = text_.find('\'', at_);
        if (end == std::string_view::npos) return false;
        word += text_.substr(at_, end - at_);
        at_ = end + 1;
        return true;
    }

    bool read_quoted(std::string& word)
    {
        while (at_ < text_.size()) {
            const char c = text_[at_++];
            if (c == '"') return true;
            const bool escapes = c == '\\' && at_ < text_.size() &&
                                 std::string_view("\"\\$`").find(text_[at_]) != std::string_view::npos;
            word += escapes ? text_[at_++] : c;
        }
        return false;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}

std::optional<std::vector<std::string>> split_shell_words(const std::string& text)
{
    std::vector<std::string> words;
    for (ShellWordReader reader(text); reader.skip_blanks();)
        if (!reader.read(words.emplace_back())) return std::nullopt;
    return words;
}

std::string program_name(const std::string& command)
{
    const auto words = split_shell_words(command);
    return words && !words->empty() ? std::filesystem::path(words->front()).stem().string() : "";
}

std::string shell_word(const std::string& word)
{
    const bool plain = !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                                               "0123456789_-+=./:,@%") == std::string::npos;
    if (plain) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}
