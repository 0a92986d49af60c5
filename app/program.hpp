// This is the program as a function, so that tests can call it without starting a file.
#pragma once

namespace poissonlab {

/// Does what the arguments call for; errors are one line on standard error. Returns the exit status.
int program_main(int argc, const char* const* argv);

}
