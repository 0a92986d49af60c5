#include "host/sampling/dart_sampler.hpp"
#include "host/sampling/dart_throwing.hpp"

namespace poissonlab {

SamplerSpec dart_throwing_sampler()
{
    return dart_sampler({.name = "dart-throwing",
                         .title = "Dart throwing",
                         .summary = "random darts, rejected where nearer than the minimum distance to an earlier one",
                         .dimensions = {2, 3},
                         .purpose = Purpose::dart_throwing,
                         .kernels = {"dart_throwing.cl", "darts_in_order.cl", "darts_in_rounds.cl"},
                         .memory = DartThrower::memory,
                         .thrower = thrower_by<DartThrower, reference::throw_darts>});
}

}
