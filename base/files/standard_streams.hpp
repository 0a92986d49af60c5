// A misfortune: a caller (`poissonlab ... >&-`, some services) has closed a standard stream of the program.
#pragma once

namespace poissonlab {

/// Opens /dev/null in place of every closed standard stream. The first file that the program opens would get the
/// stream's number otherwise, and with it what is printed. Reading and writing there fails, as it does on closed
/// streams. main() calls this before anything else.
void open_standard_streams();

}
