// Runs the program where something goes wrong, and looks at what it leaves behind.
#pragma once

#include "tests/support/places.hpp"
#include "tests/support/program.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>

namespace poissonlab {

/// Environment that preloads a library, with its settings.
inline std::string preloaded(const std::string& library, const std::string& settings)
{
    // Sanitizers want to be first otherwise.
    const char* sanitizers = std::getenv("ASAN_OPTIONS");
    const std::string options = std::string(sanitizers ? sanitizers : "detect_leaks=0") + ":verify_asan_link_order=0";
    return "ASAN_OPTIONS=" + quoted(options) + " LD_PRELOAD=" + quoted(library) + " " + settings;
}

/// The environment that loads tests/luck/bad_luck.c.
inline std::string bad_luck(const std::string& settings) { return preloaded(bad_luck_file(), settings); }

/// The environment that loads tests/luck/small_device.c.
inline std::string small_device(const std::string& settings) { return preloaded(small_device_file(), settings); }

/// The words of a message are one line, on standard error alone.
inline void expect_one_line(const Outcome& outcome, int status, const std::string& words)
{
    EXPECT_EQ(outcome.status, status);
    EXPECT_THAT(outcome.error, ::testing::StartsWith("poissonlab: error: "));
    EXPECT_THAT(outcome.error, ::testing::HasSubstr(words));
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
}

/// The part that is the same in every run of a config: point sets, tables, spectra and pictures, but no times.
inline std::map<std::string, std::string> lasting_files(const std::filesystem::path& folder)
{
    auto files = files_below(folder);
    std::erase_if(files, [](const auto& file) {
        const std::filesystem::path path = file.first;
        const std::string extension = path.extension().string();
        const bool lasts = extension == ".dat" || extension == ".csv" || extension == ".exr" || extension == ".svg" ||
                           extension == ".png";
        return !lasts || path.begin()->string() == "site" || path.filename().string().starts_with('.');
    });
    return files;
}

/// Names of files and folders that were to be there for a while only.
inline std::vector<std::string> left_over(const std::filesystem::path& folder)
{
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none))
        if (entry.path().filename().string().find(".tmp") != std::string::npos) names.push_back(entry.path().string());
    return names;
}

/// A folder with a small experiment, which needs a device, and where its results go.
class BadLuck : public ::testing::Test
{
protected:
    BadLuck()
    {
        write_config("tiny.toml", "[[method]]\nsampler = \"dart-throwing\"\nrelative_radius = 0.6\n");
        ::setenv("POISSONLAB_CACHE", (folder_.path() / "cache").c_str(), 1);
    }
    ~BadLuck() override { ::unsetenv("POISSONLAB_CACHE"); }

    std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

    void write_config(const std::string& name, const std::string& methods, int seed = 1) const
    {
        folder_.write(name, "title = \"Luck\"\nseed = " + std::to_string(seed) +
                                "\n[analysis]\npoints = 32\nrealizations = 1\n" + methods);
    }

    /// Runs a config with --quiet, in the folder.
    Outcome run(const std::string& out, const std::string& environment = "",
                const std::string& config = "tiny.toml") const
    {
        return run_program(folder_.path(), {"run", config, "--out", out, "--quiet"}, environment);
    }

    /// A command of the shell in the folder, in which $P is the program.
    Outcome shell(const std::string& command) const
    {
        folder_.write("command.sh", "P=" + quoted(program_file()) + "\n" + command + "\n");
        const std::string streams =
            "> " + quoted(path("shell.out").string()) + " 2> " + quoted(path("shell.error").string());
        const int status =
            std::system(("cd " + quoted(folder_.path().string()) + " && bash command.sh " + streams).c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(path("shell.out")),
                content_of(path("shell.error"))};
    }

    /// The number of calls that a command makes and that the settings let fail.
    long calls(const std::vector<std::string>& arguments, const std::string& settings) const
    {
        const auto file = path("calls");
        const Outcome outcome =
            run_program(folder_.path(), arguments,
                        bad_luck(settings + " BAD_LUCK_AFTER=1000000000 BAD_LUCK_COUNT=" + quoted(file.string())));
        EXPECT_EQ(outcome.status, 0) << outcome.error;
        return std::atol(content_of(file).c_str());
    }

    TemporaryFolder folder_;
};

}
