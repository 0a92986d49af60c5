// This function replaces that of points with classes in a program without their module, and asks for the module.
#include "app/commands/class_series.hpp"
#include "base/errors/missing_module.hpp"

namespace poissonlab {

void add_class_series(Experiment& /*experiment*/, const std::string& /*keys*/) { throw MissingModule("classes"); }

}
