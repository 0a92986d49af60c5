// The messages of errors that calls throw.
#pragma once

#include "base/errors/errors.hpp"

#include <gtest/gtest.h>

#include <string>

namespace poissonlab {

/// The message of the error with which a call is refused; "accepted" where it throws none.
template <class Error = InputError, class Call>
std::string refusal_of(const Call& call)
{
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

/// The message of the error that a call must throw: without one, the test fails.
template <class Error = InputError, class Call>
std::string message_of(const Call& call)
{
    std::string message = refusal_of<Error>(call);
    EXPECT_NE(message, "accepted") << "there was no error";
    return message;
}

}
