// All programs of a kernel file.
#pragma once

#include "host/device/kernel_program.hpp"

#include <vector>

namespace poissonlab {

/// Every combination of the values of a file's constants.
inline std::vector<KernelProgram> programs_of(const KernelFile& file)
{
    std::vector<std::vector<KernelValue>> all{{}};
    for (const KernelConstant& constant : file.constants) {
        std::vector<std::vector<KernelValue>> longer;
        for (const auto& values : all)
            for (const std::string& value : constant.values) {
                longer.push_back(values);
                longer.back().emplace_back(constant.name, value);
            }
        all = longer;
    }
    std::vector<KernelProgram> programs;
    for (const auto& values : all) programs.push_back(kernel_program(file.name, values));
    return programs;
}

}
