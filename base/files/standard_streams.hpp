// Standard streams that the caller of the program has closed.
#pragma once

namespace poissonlab {

/// Puts something in the place of closed standard streams, so that no file that is opened later takes it and gets what
/// was meant for a terminal. Reading and writing there fails, as on closed streams. To be called first.
void open_standard_streams();

}
