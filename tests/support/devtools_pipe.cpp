#include "tests/support/devtools_pipe.hpp"

#include "base/files/whole_file.hpp"
#include "tests/support/places.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <thread>
#include <vector>

extern char** environ;

namespace poissonlab::test {

namespace {

using Json = nlohmann::json;

std::string system_error(const std::string& what, int error) { return what + ": " + std::strerror(error); }

/// A connected pair of sockets that children do not inherit, both above the descriptors that Chromium wants: putting
/// one in its place cannot close the other.
std::array<int, 2> socket_pair()
{
    std::array<int, 2> low{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, low.data()) != 0)
        throw BrowserError(system_error("socketpair", errno));
    std::array<int, 2> high{};
    for (int i = 0; i < 2; ++i) {
        high[i] = ::fcntl(low[i], F_DUPFD_CLOEXEC, 10);
        ::close(low[i]);
    }
    if (high[0] < 0 || high[1] < 0) throw BrowserError("no file descriptor is left for the browser");
    return high;
}

std::vector<std::string> arguments(const std::string& profile)
{
    return {std::filesystem::path(program_file()).replace_filename("until_all_end").string(),
            "chromium",
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--enable-unsafe-swiftshader", // WebGL without a graphics card
            "--disable-quic",
            "--no-first-run",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-crash-reporter",
            "--disable-breakpad",
            "--disable-sync",
            "--hide-scrollbars",
            "--remote-debugging-pipe",
            "--user-data-dir=" + profile,
            "about:blank"};
}

}

DevToolsPipe::DevToolsPipe(std::chrono::milliseconds limit, EventHandler on_event)
    : limit_(limit), on_event_(std::move(on_event))
{
    const auto [ours, theirs] = socket_pair();
    socket_ = ours;
    try {
        start(theirs);
    } catch (...) {
        ::close(theirs);
        ::close(ours);
        throw;
    }
    ::close(theirs);
}

// Starts the browser by the program that ends when all of the browser's processes have, see until_all_end.cpp: the
// profile can be removed then. The browser has a process group of its own, which keys that end the tests do not reach.
void DevToolsPipe::start(int browser_end)
{
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, browser_end, 3);
    posix_spawn_file_actions_adddup2(&files, browser_end, 4);
    const auto log = (folder_.path() / "log").string();
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);

    auto words = arguments((folder_.path() / "profile").string());
    std::vector<char*> argv;
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int error = ::posix_spawnp(&process_, argv.front(), &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) {
        process_ = -1;
        throw BrowserError(system_error("chromium cannot be started", error));
    }
}

DevToolsPipe::~DevToolsPipe() { end(); }

bool DevToolsPipe::ends_within(std::chrono::milliseconds time) const
{
    for (const auto deadline = Clock::now() + time; Clock::now() < deadline;) {
        if (::waitpid(process_, nullptr, WNOHANG) != 0) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

// A browser whose pipe is closed ends by itself; one that hangs is ended.
void DevToolsPipe::end()
{
    const std::string close = R"({"id": 0, "method": "Browser.close"})";
    (void)::send(socket_, close.c_str(), close.size() + 1, MSG_NOSIGNAL | MSG_DONTWAIT);
    ::shutdown(socket_, SHUT_WR);
    if (!ends_within(std::chrono::seconds(10))) {
        ::kill(process_, SIGTERM);
        while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    ::close(socket_);
}

std::string DevToolsPipe::said() const
{
    try {
        const auto text = read_whole_file(folder_.path() / "log");
        return "; it said: " + text.substr(text.size() > 1000 ? text.size() - 1000 : 0);
    } catch (const std::exception&) {
        return {};
    }
}

namespace {

/// Waits until the socket is ready; false at the deadline.
bool ready(int socket, short events, std::chrono::steady_clock::time_point deadline)
{
    while (true) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
        if (left.count() <= 0) return false;
        pollfd wanted{socket, events, 0};
        const int count = ::poll(&wanted, 1, static_cast<int>(left.count()));
        if (count > 0) return true;
        if (count < 0 && errno != EINTR) throw BrowserError(system_error("poll", errno));
    }
}

}

void DevToolsPipe::send(const std::string& text, Clock::time_point deadline, const std::string& what)
{
    std::size_t sent = 0;
    while (sent < text.size()) {
        if (!ready(socket_, POLLOUT, deadline))
            throw BrowserError("the browser does not take " + what + " within " + std::to_string(limit_.count()) +
                               " ms");
        const auto count = ::send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count >= 0)
            sent += static_cast<std::size_t>(count);
        else if (errno != EAGAIN && errno != EINTR)
            throw BrowserError(system_error("the browser has gone at " + what, errno) + said());
    }
}

Json DevToolsPipe::receive(Clock::time_point deadline, const std::string& what)
{
    auto end = received_.find('\0');
    while (end == std::string::npos) {
        if (!ready(socket_, POLLIN, deadline))
            throw BrowserError("waited " + std::to_string(limit_.count()) + " ms for " + what + said());
        std::array<char, 65536> bytes;
        const auto count = ::recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (count == 0) throw BrowserError("the browser has ended, waiting for " + what + said());
        if (count < 0 && errno != EAGAIN && errno != EINTR)
            throw BrowserError(system_error("the browser has gone, waiting for " + what, errno) + said());
        const auto before = received_.size();
        if (count > 0) received_.append(bytes.data(), static_cast<std::size_t>(count));
        end = received_.find('\0', before);
    }
    auto message = Json::parse(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(end));
    received_.erase(0, end + 1);
    if (message.contains("method")) on_event_(message["method"], message["params"]);
    return message;
}

Json DevToolsPipe::command(const std::string& method, const Json& parameters)
{
    const auto deadline = Clock::now() + limit_;
    const int id = next_id_++;
    Json message = {{"id", id}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) message["sessionId"] = session_;
    send(message.dump() + '\0', deadline, method);
    while (true) {
        auto answer = receive(deadline, "the answer to " + method);
        if (answer.value("id", 0) != id) continue;
        if (answer.contains("error"))
            throw BrowserError(method + ": " + answer["error"].value("message", answer["error"].dump()));
        return answer["result"];
    }
}

void DevToolsPipe::wait_until(const std::function<bool()>& done, const std::string& what)
{
    const auto deadline = Clock::now() + limit_;
    while (!done()) receive(deadline, what);
}

}
