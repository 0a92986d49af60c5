// These functions stand in for the sequential twins of the core's kernels where a program lacks them: a run by them
// asks for the module.
#include "base/errors/missing_module.hpp"
#include "host/sampling/dart_throwing.hpp"
#include "host/sampling/lloyd_relaxation.hpp"
#include "host/sampling/reference/reference_engine.hpp"
#include "host/sampling/relaxation_dart_throwing.hpp"
#include "host/sampling/repulsion.hpp"

namespace poissonlab {

void need_reference_engine() { throw MissingModule("reference"); }

namespace reference {

PointSet throw_darts(const DartThrowingRequest& /*request*/) { throw MissingModule("reference"); }

RelaxationDarts throw_relaxation_darts(const RelaxationDartThrowingRequest& /*request*/)
{
    throw MissingModule("reference");
}

LloydResult relax(const PointSet& /*points*/, const Domain& /*domain*/, const LloydRequest& /*request*/)
{
    throw MissingModule("reference");
}

RepulsionResult repel(const PointSet& /*points*/, const Domain& /*domain*/, const RepulsionRequest& /*request*/)
{
    throw MissingModule("reference");
}

}

}
