// The standard streams of the program: those that its caller has closed, and standard output as the place of a file.
#pragma once

namespace poissonlab {

/// A misfortune: a caller (`poissonlab ... >&-`, some services) has closed a standard stream of the program.
/// Opens /dev/null in place of every closed standard stream. The first file that the program opens would get the
/// stream's number otherwise, and with it what is printed. Reading and writing there fails, as it does on closed
/// streams. main() calls this before anything else.
void open_standard_streams();

/// Keeps standard output for the file that a user has named "-": what the program prints goes to standard error from
/// now on, so that nothing else gets into the file.
void keep_standard_output();

/// The open file that was standard output when keep_standard_output() was called; -1: it was not.
int kept_standard_output();

}
