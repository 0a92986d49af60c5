// Modules that are not where programs look for them.
#include "base/programs/loaded_module.hpp"

#include "base/errors/errors.hpp"
#include "base/errors/missing_module.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(LoadedModule, SaysWhichFileIsMissing)
{
    try {
        function_of_module("poissonlab_nothing", "f", "longitude and latitude need PROJ");
        FAIL();
    } catch (const StorageError& error) {
        EXPECT_STREQ(error.what(),
                     "longitude and latitude need PROJ: there is no libpoissonlab_nothing.so beside the program");
    }
    EXPECT_THROW(function_of_module("poissonlab_nothing", "f", "files need it", true), MissingModule);
}

}
}
