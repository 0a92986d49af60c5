// An exception as bytes that can be sent to another process.
#pragma once

#include <exception>
#include <functional>
#include <string>

namespace poissonlab {

/// Kind and message of an exception; the message is printable.
struct Failure
{
    enum class Kind : int
    {
        none,
        input,
        device,
        storage,
        interrupted,
        other
    };

    Kind kind = Kind::none;
    std::string message;

    /// The failure of the exception that is being handled.
    static Failure current();

    /// Throws an exception of that kind, or returns where nothing failed.
    void raise() const;

    /// Does `work`, and returns its failure if that spares others and `is_tolerated`. Throws any other, and
    /// MissingModule.
    static Failure of(const std::function<void()>& work, bool is_tolerated);

    /// Is other work worth going on with? Not where somebody has interrupted it, or nothing can be stored.
    bool spares_others() const { return kind != Kind::interrupted && kind != Kind::storage; }
};

}
