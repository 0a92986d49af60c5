#include "base/crew/failure.hpp"

#include "base/errors/errors.hpp"
#include "base/errors/missing_module.hpp"
#include "base/programs/interrupt.hpp"

#include <new>
#include <stdexcept>

namespace poissonlab {

Failure Failure::current()
{
    try {
        throw;
    } catch (const InputError& error) {
        return {Kind::input, error.what()};
    } catch (const DeviceError& error) {
        return {Kind::device, error.what()};
    } catch (const StorageError& error) {
        return {Kind::storage, error.what()};
    } catch (const Interrupted& error) {
        return {Kind::interrupted, error.what()};
    } catch (const std::bad_alloc&) {
        return {Kind::other, "there is not enough memory for this"};
    } catch (const std::exception& error) {
        return {Kind::other, printable(error.what())};
    }
}

Failure Failure::of(const std::function<void()>& work, bool is_tolerated)
{
    try {
        work();
        return {};
    } catch (const MissingModule&) {
        throw; // the program starts anew with the module
    } catch (...) {
        stop_if_interrupted(); // what fails after a signal, such as a program that got it as well, is no failure
        Failure failure = current();
        if (!is_tolerated || !failure.spares_others()) throw;
        return failure;
    }
}

void Failure::raise() const
{
    switch (kind) {
    case Kind::none:
        return;
    case Kind::input:
        throw InputError({}, message);
    case Kind::device:
        throw DeviceError({}, message);
    case Kind::storage:
        throw StorageError({}, message);
    case Kind::interrupted:
        throw Interrupted();
    case Kind::other:
        throw std::runtime_error(message);
    }
}

}
