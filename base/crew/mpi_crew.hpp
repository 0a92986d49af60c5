// A crew of the processes of an MPI job.
#pragma once

#include "base/crew/crew.hpp"

#include <memory>

namespace poissonlab {

/// Starts MPI, and ends it with the crew: once in the life of a process. Rank 0 leads. Throws InputError where MPI does
/// not start, allows only one thread to use it, or has not as many processes as mpirun has started (`expected`): then
/// mpirun is that of another MPI, and each process would do all the work.
///
/// Rank 0 works like the others: a thread beside deals out the jobs. No process waits busily, which would take a core
/// from those that work.
std::unique_ptr<Crew> make_mpi_crew(int expected);

}
