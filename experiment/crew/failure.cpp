#include "experiment/crew/failure.hpp"

#include "base/errors/errors.hpp"
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
