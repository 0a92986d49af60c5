// A real browser in tests: headless Chromium opens a page, moves a mouse, presses keys, and says what it was asked for.
#pragma once

#include "tests/support/devtools_pipe.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab::test {

/// The bytes of base64 without blanks.
std::string from_base64(const std::string& text);

/// One browser window with one page. Everything has a time limit; what fails throws BrowserError that says what.
class Browser
{
public:
    explicit Browser(std::chrono::milliseconds limit = std::chrono::seconds(60));

    /// Opens a file, waits until it is loaded and drawn, and forgets messages and requests of the page before.
    void open(const std::filesystem::path& page, const std::string& fragment = {});

    /// The value of a JavaScript expression; of a promise, once it is kept. Throws where the script throws.
    nlohmann::json evaluate(const std::string& expression);

    /// Moves the mouse over the first element that the selector finds, to this share of its width and height. The
    /// element is scrolled into view. Throws where there is none, or where another element lies on top at that place.
    void point_at(const std::string& selector, double across = 0.5, double down = 0.5);

    /// Moves the mouse as point_at() does, and presses and releases the left button.
    void click(const std::string& selector, double across = 0.5, double down = 0.5);

    /// Drags the mouse over an element, from one place to another, as for point_at().
    void drag(const std::string& selector, double across, double to_across, double down, double to_down);

    /// Puts two fingers on an element, at these shares of its width and at half its height, moves them to others, and
    /// lifts them.
    void pinch(const std::string& selector, const std::array<double, 2>& across,
               const std::array<double, 2>& to_across);

    /// Presses and releases a key: a character, or Tab, Enter, Escape, Home, End, ArrowLeft, ArrowRight, ArrowUp,
    /// ArrowDown, Space.
    void press(const std::string& key, bool shift = false);
    void type(const std::string& text);

    /// The size of the window in CSS pixels. `mobile`: a telephone, which obeys the page's viewport.
    void resize(int width, int height, bool mobile = false);

    /// "screen" or "print", light or dark.
    void emulate(const std::string& media, bool dark);

    /// A picture of the window, as PNG.
    std::string screenshot();

    /// Console messages, exceptions, the browser's own complaints, and files that could not be loaded.
    const std::vector<std::string>& messages() const { return messages_; }

    /// The requests beyond the disk: every URL that is not file:, data:, blob: or about:.
    const std::vector<std::string>& requests() const { return requests_; }

    /// The time that everything that follows may take.
    void set_limit(std::chrono::milliseconds limit) { pipe_.set_limit(limit); }

    pid_t process() const { return pipe_.process(); }

private:
    void handle(const std::string& method, const nlohmann::json& event);
    void handle_console(const nlohmann::json& event);
    void mouse(const std::string& type, bool pressed);

    std::vector<std::string> messages_;
    std::vector<std::string> requests_;
    bool loaded_ = false;
    double mouse_x_ = 0;
    double mouse_y_ = 0;
    std::vector<std::pair<std::string, std::string>> urls_; ///< of each request
    DevToolsPipe pipe_;
};

}
