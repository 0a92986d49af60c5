// The command line of poissonlab: subcommands, help, exit statuses.
#pragma once

namespace poissonlab {

/// Does what the arguments say and returns the exit status: 0 all is there; 2 the input or the arguments are wrong;
/// 3 OpenCL failed; 4 results that are compared differ; 130 it was interrupted; 1 anything else. Errors are one line on
/// standard error, "poissonlab: error: ...".
int run_command_line(int argc, const char* const* argv);

}
