// This test program contains the whole laboratory, so that its commands can run in children of a nursery.
#include "app/program.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

class Nursery : public testing::Environment
{
    void SetUp() override { run_programs_in_nursery(program_main); }
};

testing::Environment* const nursery_of_app = testing::AddGlobalTestEnvironment(new Nursery);

}
}
