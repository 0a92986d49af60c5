// The complaints of every reader of a stored table about damaged ones.
#pragma once

#include "base/errors/errors.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <string>

namespace poissonlab::test {

/// Tables of four columns of finite numbers: wrong rows are named by their line, and neither an empty table
/// nor one with another header is read.
template <class Read>
void expect_table_errors(const std::string& header, const Read& read)
{
    const TemporaryFolder folder;
    for (const auto* line : {"1,2,3", "1,2,x,4", "1,2,nan,4", "1,2,3,inf", ""}) {
        const auto table = folder.write("a.csv", header + "1,1,1,8\n" + line + "\n");
        EXPECT_THAT(message_of([&] { read(table); }), testing::HasSubstr("a.csv:3: ")) << line;
    }
    EXPECT_THROW(read(folder.write("a.csv", header)), InputError);
    EXPECT_THROW(read(folder.write("a.csv", "frequency,power,anisotropy_db,samples\n")), InputError);
}

}
