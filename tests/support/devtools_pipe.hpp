// A headless Chromium of our own, and the DevTools protocol over a pipe to it: JSON messages, each ended by a NUL byte,
// on the browser's file descriptors 3 and 4 (--remote-debugging-pipe).
#pragma once

#include "tests/support/temporary_folder.hpp"

#include <nlohmann/json.hpp>

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>

namespace poissonlab::test {

/// The browser cannot be started, does not answer in time, refuses a command, or a page throws.
class BrowserError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// Chromium, with a profile of its own. All its processes are gone when this is destroyed.
class DevToolsPipe
{
public:
    /// Called with each event: its method and its parameters.
    using EventHandler = std::function<void(const std::string& method, const nlohmann::json& parameters)>;

    /// Throws BrowserError where Chromium cannot be started.
    DevToolsPipe(std::chrono::milliseconds limit, EventHandler on_event);
    ~DevToolsPipe();
    DevToolsPipe(const DevToolsPipe&) = delete;
    DevToolsPipe& operator=(const DevToolsPipe&) = delete;

    /// Sends a command and waits for its result; events that come before it are handled. Throws BrowserError that names
    /// the command where it is refused, or not answered within the limit.
    nlohmann::json command(const std::string& method, const nlohmann::json& parameters = nlohmann::json::object());

    /// Handles events until `done`. Throws BrowserError, "waited ... for WHAT", after the limit.
    void wait_until(const std::function<bool()>& done, const std::string& what);

    /// Commands from now on go to this session: that of a page.
    void use_session(std::string session) { session_ = std::move(session); }

    void set_limit(std::chrono::milliseconds limit) { limit_ = limit; }

    /// The one that ends when all others have.
    pid_t process() const { return process_; }

private:
    using Clock = std::chrono::steady_clock;

    void start(int browser_end);
    void send(const std::string& text, Clock::time_point deadline, const std::string& what);
    nlohmann::json receive(Clock::time_point deadline, const std::string& what);
    std::string said() const;
    bool ends_within(std::chrono::milliseconds time) const;
    void end();

    std::chrono::milliseconds limit_;
    EventHandler on_event_;
    TemporaryFolder folder_; ///< the profile, and what the browser says
    std::string session_;
    std::string received_; ///< bytes after the last whole message
    int next_id_ = 1;
    int socket_ = -1;
    pid_t process_ = -1;
};

}
