// This function stands in for MPI where the machine lacks it.
#include "base/crew/mpi_crew.hpp"
#include "base/errors/errors.hpp"

#include <fmt/format.h>

namespace poissonlab {

std::unique_ptr<Crew> make_mpi_crew(int processes)
{
    throw InputError(fmt::format("mpirun started {} processes, but this poissonlab was built without MPI: install "
                                 "libopenmpi-dev and build again, or use --shard",
                                 processes));
}

}
