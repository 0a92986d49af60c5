// Environments that lack what most have, or say strange things: the results are the same bytes.
#include "tests/luck/bad_luck.hpp"

namespace poissonlab {
namespace {

class EnvironmentLuck : public BadLuck
{
};

TEST_F(EnvironmentLuck, ChangesNoResult)
{
    ASSERT_EQ(run("plain").status, 0);
    const auto plain = lasting_files(path("plain"));
    ASSERT_GT(plain.size(), 8u);

    // A locale in which the small letter of I is no i; systems without it would run in "C" and show nothing.
    const std::string locale = path("tr_TR.UTF-8").string();
    const bool has_locale =
        std::system(("localedef -i tr_TR -f UTF-8 " + quoted(locale) + " >/dev/null 2>&1").c_str()) == 0;
    // Nobody can make folders in /proc. What is harmless together is harmless alone.
    const std::string turkish = "LOCPATH=" + quoted(folder_.path().string()) + " LC_ALL=tr_TR.UTF-8 LANG=tr_TR.UTF-8 ";
    const std::vector<std::string> environments{
        "env -i",
        "umask 077 && TZ=:@@/../garbage TERM=nonsense COLUMNS=-5 env -u XDG_CACHE_HOME -u POISSONLAB_CACHE "
        "HOME=/proc/nobody",
        (has_locale ? turkish : "") + "POCL_CACHE_DIR=/proc/none POISSONLAB_CACHE=/proc/none TMPDIR=/proc/none",
        bad_luck("BAD_LUCK_HIDES=/proc LC_ALL=xx_YY.UTF-8 LANG=nonsense"),
    };
    for (const std::string& environment : environments) {
        SCOPED_TRACE(environment);
        const Outcome outcome = run("out", environment);
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.error, "");
        EXPECT_EQ(lasting_files(path("out")), plain);
        std::filesystem::remove_all(path("out"));
    }
}

}
}
