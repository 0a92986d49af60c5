// The module _poissonlab, which the files of python/poissonlab are written on: arrays in, arrays out, errors as
// exceptions with the words of the program.
#include "base/errors/errors.hpp"
#include "base/programs/interrupt.hpp"
#include "python/module/module_parts.hpp"
#include "version.hpp"

#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace poissonlab {
namespace {

/// The interpreter's own handler of Ctrl-C may do something else than to raise KeyboardInterrupt, but work that was
/// interrupted has no result.
void tell_of_interrupt()
{
    PyErr_SetInterrupt();
    if (PyErr_CheckSignals() == 0) PyErr_SetNone(PyExc_KeyboardInterrupt);
}

void add_errors(py::module_& module)
{
    const auto name_package = [](py::object type) { type.attr("__module__") = "poissonlab"; };
    name_package(py::register_exception<InputError>(module, "InputError", PyExc_ValueError));
    name_package(py::register_exception<DeviceError>(module, "DeviceError", PyExc_RuntimeError));
    name_package(py::register_exception<StorageError>(module, "StorageError", PyExc_OSError));
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Interrupted&) {
            tell_of_interrupt();
        }
    });
}

}
}

PYBIND11_MODULE(_poissonlab, module)
{
    module.attr("version") = POISSONLAB_VERSION;
    poissonlab::add_errors(module);
    poissonlab::add_samplers(module);
    poissonlab::add_point_files(module);
    poissonlab::add_analysis(module);
    poissonlab::add_results(module);
    poissonlab::add_tile_sets(module);
    poissonlab::add_monotile_sets(module);
    poissonlab::add_kinds(module);
}
