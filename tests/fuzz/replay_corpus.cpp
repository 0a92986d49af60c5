// A program that runs fuzz targets where there is no libFuzzer: every file of the corpus, then changes of these that
// follow from a seed. Takes libFuzzer's options `-runs=`, `-seed=` and `-seed_inputs=@`, and ignores the others.
#include "base/files/whole_file.hpp"
#include "tests/fuzz/fuzz_support.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <random>
#include <sstream>
#include <vector>

extern "C" __attribute__((weak)) std::size_t LLVMFuzzerCustomMutator(unsigned char* data, std::size_t size,
                                                                     std::size_t max_size, unsigned int seed);

namespace poissonlab::fuzz {
namespace {

constexpr std::size_t max_input = 4096;

std::mt19937 random_numbers;

std::size_t number_below(std::size_t end)
{
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_numbers);
}

/// The files of a list with commas between them.
std::vector<std::string> corpus_of(const std::string& list)
{
    std::vector<std::string> inputs;
    std::istringstream files(read_whole_file(list));
    for (std::string file; std::getline(files, file, ',');) inputs.push_back(read_whole_file(file));
    return inputs;
}

void run(std::string_view input)
{
    LLVMFuzzerTestOneInput(reinterpret_cast<const unsigned char*>(input.data()), input.size());
}

/// One change: a byte or a digit replaced, a bit turned, bytes doubled, removed, or cut off at the end.
std::size_t mutate(unsigned char* data, std::size_t size, std::size_t max_size)
{
    if (size == 0) {
        data[0] = static_cast<unsigned char>(random_numbers());
        return 1;
    }
    const std::size_t at = number_below(size);
    const std::size_t count = 1 + number_below(std::min<std::size_t>(size - at, 20));
    switch (number_below(6)) {
    case 0:
        data[at] = static_cast<unsigned char>(random_numbers());
        return size;
    case 1:
        data[at] = static_cast<unsigned char>('0' + number_below(10));
        return size;
    case 2:
        data[at] = static_cast<unsigned char>(data[at] ^ (1U << number_below(8)));
        return size;
    case 3:
        if (size + count > max_size) return size;
        std::memmove(data + at + count, data + at, size - at);
        return size + count;
    case 4:
        std::memmove(data + at, data + at + count, size - at - count);
        return size - count;
    default:
        return at;
    }
}

std::string changed(const std::string& input)
{
    std::vector<unsigned char> bytes(std::max(input.size() + 64, max_input));
    std::ranges::copy(input, bytes.begin());
    std::size_t size = input.size();
    for (std::size_t change = 0; change <= number_below(4); ++change) {
        size = LLVMFuzzerCustomMutator
                   ? LLVMFuzzerCustomMutator(bytes.data(), size, bytes.size(), static_cast<unsigned>(random_numbers()))
                   : mutate(bytes.data(), size, bytes.size());
    }
    return {reinterpret_cast<const char*>(bytes.data()), size};
}

}
}

extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t max_size)
{
    return poissonlab::fuzz::mutate(data, size, max_size);
}

int main(int argc, char** argv)
{
    using namespace poissonlab;
    std::size_t runs = 0;
    std::vector<std::string> inputs;
    for (const std::string_view argument : std::vector<std::string_view>(argv + 1, argv + argc)) {
        const auto value_of = [&](std::string_view name, const auto& take) {
            if (argument.starts_with(name)) take(std::string(argument.substr(name.size())));
        };
        value_of("-runs=", [&](const std::string& value) { runs = std::stoul(value); });
        value_of("-seed=", [&](const std::string& value) { fuzz::random_numbers.seed(std::stoul(value)); });
        value_of("-seed_inputs=@", [&](const std::string& value) { inputs = fuzz::corpus_of(value); });
    }
    for (const std::string& input : inputs) fuzz::run(input);
    for (std::size_t i = inputs.size(); i < runs && !inputs.empty(); ++i)
        fuzz::run(fuzz::changed(inputs[fuzz::number_below(inputs.size())]));
    std::printf("%zu files and %zu changes of them\n", inputs.size(), runs > inputs.size() ? runs - inputs.size() : 0);
    return inputs.empty() ? 1 : 0;
}
