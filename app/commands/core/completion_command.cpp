// poissonlab completion: what a shell needs, of all commands.
#include "app/commands/core/stored_text.hpp"
#include "app/commands/work_options.hpp"
#include "app/completion.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace poissonlab {
namespace {

constexpr auto completion_notes =
    R"(bash: source the script, or put it into ~/.local/share/bash-completion/completions/poissonlab.
zsh: put it into a folder of $fpath, as _poissonlab. `make install` has done both.
  source <(poissonlab completion bash))";

std::string script_for(const std::string& shell, const std::vector<Command>& commands)
{
    const auto is_absent = [](const Command& command) { return !command.absent_module.empty(); };
    const bool lacks_some = std::ranges::any_of(commands, [&](const Command& command) {
        return is_absent(command) || std::ranges::any_of(command.commands, is_absent);
    });
    return lacks_some ? std::string(stored_text("completion." + shell)) : completion_script(shell, commands);
}

}

Command completion_command(std::function<std::vector<Command>()> all_commands)
{
    const auto shell = std::make_shared<std::string>();
    return {"completion",
            "Print what a shell needs to complete commands and options",
            {{.name = "SHELL", .target = shell.get(), .help = "bash or zsh", .words = completed_shells()}},
            completion_notes,
            [shell, all_commands = std::move(all_commands)] {
                if (std::ranges::find(completed_shells(), *shell) == completed_shells().end())
                    throw unknown_word("completion", "SHELL", *shell, completed_shells());
                fmt::print("{}", script_for(*shell, all_commands()));
                return 0;
            }};
}

}
