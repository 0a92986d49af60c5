// Words of a command line, and the command of the sampler "command" with its fields; nothing is run.
#include "base/programs/shell_words.hpp"
#include "host/sampling/classics/command_sampler.hpp"
#include "tests/fuzz/fuzz_support.hpp"

namespace poissonlab::fuzz {
namespace {

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) text += shell_word(word) + " ";
    return text;
}

}
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const std::string text(reinterpret_cast<const char*>(data), size);

    if (const auto words = split_shell_words(text))
        fuzz::require(split_shell_words(fuzz::joined(*words)) == words, "words in quotes are not the same words");
    fuzz::require(split_shell_words(shell_word(text)) == std::vector{text}, "a text in quotes is not that one word");
    program_name(text);
    fuzz::accepts("", [&] {
        const auto words = command_words(text, {100, 2, 7, 3, "/some where/points"});
        fuzz::require(!words.empty(), "a command without a program");
    });
    return 0;
}
