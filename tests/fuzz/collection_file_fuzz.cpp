// collection.json: the output folders of a collection.
#include "results/collection_file.hpp"
#include "results/file_names.hpp"
#include "tests/fuzz/fuzz_support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
    using namespace poissonlab;
    const auto file = fuzz::write_input(file_names::collection, {reinterpret_cast<const char*>(data), size});
    std::optional<CollectionFile> collection;
    if (!fuzz::accepts(file.native(), [&] { collection = read_collection_file(fuzz::input_folder()); })) return 0;
    fuzz::require(collection && !collection->runs.empty(), "a collection without runs");
    for (const auto& folder : output_folders(fuzz::input_folder()))
        fuzz::require(folder.parent_path() == fuzz::input_folder(), "a run outside of the collection");
    write_collection_file(fuzz::input_folder(), *collection);
    const auto again = read_collection_file(fuzz::input_folder());
    fuzz::require(again->runs == collection->runs && again->title == collection->title &&
                      again->command == collection->command,
                  "a collection that changes when it is written and read");
    return 0;
}
