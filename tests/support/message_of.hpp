// The message of the InputError that a call throws.
#pragma once

#include "base/errors/errors.hpp"

#include <gtest/gtest.h>

#include <string>

namespace poissonlab {

/// "" and a failed test when there is no InputError.
template <typename Call>
std::string message_of(const Call& call)
{
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    ADD_FAILURE() << "there was no InputError";
    return "";
}

}
