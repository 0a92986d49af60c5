// This function stands in for processes that share a run where a program lacks them: those that mpirun starts ask for
// the module.
#include "base/crew/mpi_crew.hpp"
#include "base/errors/missing_module.hpp"

namespace poissonlab {

std::unique_ptr<Crew> make_mpi_crew(int /*processes*/) { throw MissingModule("processes"); }

}
