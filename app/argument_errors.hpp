// The words for arguments that the parser refuses: as those of commands, they name the command, the option, what was
// typed, and what is allowed.
#pragma once

#include "base/errors/errors.hpp"

namespace CLI {
class App;
class ParseError;
}

namespace poissonlab {

/// `app` is the whole program's parser after it has thrown `error`.
InputError argument_error(const CLI::App& app, const CLI::ParseError& error);

}
