// Opening a page in a real browser: headless Chromium, with a profile of its own.
#pragma once

#include "io/whole_file.hpp"
#include "support/picture.hpp"
#include "support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace poissonlab::test {

/// What a browser makes of a page.
struct Visit
{
    std::string log;     ///< what it said; messages of the page's console have the word CONSOLE
    Picture picture;     ///< 1,280 x `height` pixels
    ColorPicture colors; ///< the same
};

inline Visit visit(const std::filesystem::path& page, int height)
{
    const TemporaryFolder scratch;
    const auto log = scratch.path() / "log";
    const auto shot = scratch.path() / "shot.png";
    const auto command =
        "timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
        "--disable-background-networking --disable-component-update --disable-sync "
        "--hide-scrollbars --enable-logging=stderr --v=0 --user-data-dir='" +
        (scratch.path() / "profile").string() + "' --window-size=1280," + std::to_string(height) +
        " --screenshot='" + shot.string() + "' 'file://" + page.string() + "' 2> '" + log.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    const std::string png = read_whole_file(shot);
    return {read_whole_file(log), decode_png(png), decode_color_png(png)};
}

}
