// The memory that dart throwing takes on a device.
#pragma once

#include "host/sampling/darts/dart_request.hpp"
#include "host/sampling/darts/dart_settler.hpp"

namespace poissonlab {

/// The buffers that a set takes, nearly: lists grow where chance wants it.
NeededBuffers dart_buffers(DartBuffers& buffers, const DartThrowingRequest& request, DartSettling settling,
                           unsigned compute_units);

}
