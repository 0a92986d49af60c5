#include "experiment/store/unit_store.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;

class UnitStoring : public testing::Test
{
protected:
    fs::path units() const { return folder_.path() / ".units"; }

    /// Stores a unit with two files and a record that has every byte.
    void store_one(UnitStore& store) const
    {
        write_whole_file(store.file(key_, "a.txt"), "content of a");
        write_whole_file(store.file(key_, "b.bin"), every_byte());
        store.store(key_, every_byte(), {"a.txt", "b.bin"});
    }

    static std::string every_byte()
    {
        std::string bytes;
        for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
        return bytes;
    }

    /// The unit as another process would find it.
    std::optional<StoredUnit> found() const { return UnitStore(units()).find(key_); }

    std::vector<fs::path> files() const
    {
        std::vector<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(units()))
            if (entry.is_regular_file()) files.push_back(entry.path());
        return files;
    }

    TemporaryFolder folder_;
    UnitKey key_ = UnitKey("test").add("points", 64).add("seed", 1U);
};

TEST(UnitKey, SaysEverythingInLines)
{
    EXPECT_EQ(UnitKey("k").add("a", "x").add("b", 2).add("c", true).add(UnitKey("other")).text(),
              "unit = k\na = x\nb = 2\nc = yes\nunit = other\n");
}

TEST(UnitKey, DifferentValuesStayDifferent)
{
    const auto name = [](const std::string& a, const std::string& b) {
        return UnitKey("k").add("a", a).add("b", b).name();
    };
    EXPECT_EQ(name("1", "2"), name("1", "2"));
    EXPECT_NE(name("1", "2"), name("2", "1"));
    EXPECT_NE(name("1\nb = 2", "3"), name("1", "2\nb = 3"));
    EXPECT_NE(name("\\n", ""), name("\n", ""));
    EXPECT_EQ(name("1", "2").size(), 32U);
}

TEST_F(UnitStoring, KeepsRecordAndFiles)
{
    UnitStore store(units());
    EXPECT_FALSE(store.find(key_));
    store_one(store);
    for (const auto& unit : {store.find(key_), found()}) {
        ASSERT_TRUE(unit);
        EXPECT_EQ(unit->record, every_byte());
        ASSERT_EQ(unit->files.size(), 2U);
        EXPECT_EQ(read_whole_file(unit->files.at("a.txt")), "content of a");
        EXPECT_EQ(read_whole_file(unit->files.at("b.bin")), every_byte());
    }
    EXPECT_FALSE(UnitStore(units()).find(UnitKey("test").add("points", 64).add("seed", 2U)));
}

TEST_F(UnitStoring, CreatesNothingBeforeTheFirstUnit)
{
    const UnitStore store(units());
    EXPECT_FALSE(store.find(key_));
    EXPECT_FALSE(fs::exists(units()));
}

TEST_F(UnitStoring, DistrustsEveryDamagedByteAndEveryMissingOne)
{
    UnitStore store(units());
    store_one(store);
    for (const fs::path& file : files()) {
        const std::string content = read_whole_file(file);
        for (std::size_t i = 0; i < content.size(); ++i) {
            std::string damaged = content;
            damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
            write_whole_file(file, damaged);
            ASSERT_FALSE(found()) << file << " with byte " << i << " changed";
            write_whole_file(file, content.substr(0, i));
            ASSERT_FALSE(found()) << file << " of " << i << " bytes";
        }
        write_whole_file(file, content + "x");
        EXPECT_FALSE(found()) << file << " with a byte more";
        fs::remove(file);
        EXPECT_FALSE(found()) << file << " gone";
        write_whole_file(file, content);
        ASSERT_TRUE(found());
    }
}

TEST_F(UnitStoring, AKeyOfTheSameNameIsNotTheSameKey)
{
    UnitStore store(units());
    store_one(store);
    // The hashes of two keys could be equal: the unit of one under the name of the other.
    const UnitKey other = UnitKey("test").add("points", 65);
    store.store(other, "record");
    const auto manifest_of = [&](const UnitKey& key) {
        const std::string name = key.name();
        return units() / name.substr(0, 2) / (name + ".unit");
    };
    fs::copy_file(manifest_of(other), manifest_of(key_), fs::copy_options::overwrite_existing);
    EXPECT_FALSE(found());
}

TEST_F(UnitStoring, WithoutItsManifestAUnitIsNotThere)
{
    UnitStore store(units());
    write_whole_file(store.file(key_, "a.txt"), "content of a"); // and then the process was killed
    EXPECT_FALSE(found());
    EXPECT_THROW(store.store(key_, "", {"a.txt", "never-written"}), StorageError);
    EXPECT_FALSE(found());
}

TEST_F(UnitStoring, StoredAgainItIsReplaced)
{
    UnitStore store(units());
    store_one(store);
    write_whole_file(store.file(key_, "a.txt"), "other");
    store.store(key_, "record", {"a.txt"});
    ASSERT_TRUE(found());
    EXPECT_EQ(found()->record, "record");
    EXPECT_EQ(found()->files.size(), 1U);
}

TEST_F(UnitStoring, RemovesUnits)
{
    UnitStore store(units());
    store_one(store);
    store.remove(key_);
    EXPECT_FALSE(store.find(key_));
    EXPECT_FALSE(found());
    EXPECT_TRUE(files().empty());
    store.remove(key_);
}

TEST_F(UnitStoring, MergesWhatIsSound)
{
    const TemporaryFolder elsewhere;
    UnitStore other(elsewhere.path() / ".units");
    store_one(other);
    const UnitKey second = UnitKey("second"), damaged = UnitKey("damaged");
    other.store(second, "2");
    write_whole_file(other.file(damaged, "x"), "x");
    other.store(damaged, "3", {"x"});
    write_whole_file(other.file(damaged, "x"), "y");

    UnitStore store(units());
    store.store(second, "mine");
    std::size_t told = 0;
    EXPECT_EQ(store.merge(other, [&](std::size_t count) { told = count; }), 1U);
    EXPECT_EQ(told, 1U);
    ASSERT_TRUE(found());
    EXPECT_EQ(read_whole_file(found()->files.at("a.txt")), "content of a");
    EXPECT_EQ(UnitStore(units()).find(second)->record, "mine");
    EXPECT_FALSE(UnitStore(units()).find(damaged));
    EXPECT_EQ(store.merge(other, [](std::size_t) {}), 0U);
    EXPECT_EQ(store.merge(UnitStore(folder_.path() / "nothing"), [](std::size_t) {}), 0U);
}

TEST_F(UnitStoring, WhereNothingCanBeWritten)
{
    UnitStore store("/proc/no-such-folder");
    EXPECT_THROW(store.file(key_, "a"), StorageError);
    EXPECT_THROW(store.store(key_, "record"), StorageError);
    EXPECT_FALSE(store.find(key_));
}

}
}
