#include "app/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

namespace poissonlab {
namespace {

/// The words that may follow, by what comes before them: "tiles" has "build ...", "tiles build" its options, and
/// "tiles build --engine" what that may be.
using FollowingWords = std::map<std::string, std::vector<std::string>>;

void add_options(const Command& command, const std::string& path, FollowingWords& words)
{
    for (const Option& option : command.options) {
        if (option.name.starts_with('-')) {
            words[path].push_back(option.name);
            if (!option.words.empty()) words[path + " " + option.name] = option.words;
        } else {
            words[path].insert(words[path].end(), option.words.begin(), option.words.end());
        }
    }
    words[path].emplace_back("--help");
}

void add_commands(const std::vector<Command>& commands, const std::string& group, FollowingWords& words)
{
    for (const Command& command : commands) {
        const std::string path = group.empty() ? command.name : group + " " + command.name;
        words[group].push_back(command.name);
        if (command.action) add_options(command, path, words);
        add_commands(command.commands, path, words);
    }
}

/// A table of a shell: names and values in quotes. Words are names of commands and options, without quotes.
std::string table_of(const FollowingWords& words, const char* row)
{
    std::string text;
    for (const auto& [before, after] : words)
        text += fmt::format(fmt::runtime(row), before.empty() ? "." : before, fmt::join(after, " "));
    return text;
}

constexpr auto bash_head = R"(# bash completion of poissonlab: printed by `poissonlab completion bash`
_poissonlab()
{
    local -A following=(
)";
constexpr auto bash_tail = R"(    )
    local current=${COMP_WORDS[COMP_CWORD]} path= word i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        [[ -n ${following[${path:+$path }$word]+known} && $word != -* ]] && path=${path:+$path }$word
    done
    local choices=${following[$path ${COMP_WORDS[COMP_CWORD - 1]}]-${following[${path:-.}]}}
    mapfile -t COMPREPLY < <(compgen -W "$choices" -- "$current")
    [[ ${#COMPREPLY[@]} -eq 0 ]] && mapfile -t COMPREPLY < <(compgen -f -- "$current")
    return 0
}
complete -o filenames -F _poissonlab poissonlab
)";

constexpr auto zsh_head = R"(#compdef poissonlab
# zsh completion of poissonlab: printed by `poissonlab completion zsh`
_poissonlab()
{
    local -A following
    following=(
)";
constexpr auto zsh_tail = R"(    )
    local joined= word i
    for ((i = 2; i < CURRENT; ++i)); do
        word=$words[i]
        [[ -n "$following[${joined:+$joined }$word]" && $word != -* ]] && joined="${joined:+$joined }$word"
    done
    local choices="$following[$joined $words[CURRENT-1]]"
    [[ -n "$choices" ]] || choices="$following[${joined:-.}]"
    compadd -- ${=choices} || _files
}
if [[ $funcstack[1] == _poissonlab ]]; then _poissonlab "$@"; else compdef _poissonlab poissonlab; fi
)";

}

const std::vector<std::string>& completed_shells()
{
    static const std::vector<std::string> shells{"bash", "zsh"};
    return shells;
}

std::string completion_script(const std::string& shell, const std::vector<Command>& commands)
{
    FollowingWords words;
    add_commands(commands, "", words);
    words[""].emplace_back("help");
    if (shell == "zsh") return zsh_head + table_of(words, "        '{}' '{}'\n") + zsh_tail;
    return bash_head + table_of(words, "        ['{}']='{}'\n") + bash_tail;
}

}
