#include "analysis/spectra/spectrum_file.hpp"

#include "base/errors/errors.hpp"
#include "base/files/whole_file.hpp"
#include "tests/support/errors.hpp"
#include "tests/support/point_patterns.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace poissonlab {
namespace {

using namespace test;

/// A folder of its own for each test, removed at the end.
class SpectrumFile : public testing::Test
{
protected:
    SpectrumFile()
        : folder_(std::filesystem::temp_directory_path() /
                  ("spectrum-file-" + std::to_string(::getpid()) + "-" +
                   testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
        std::filesystem::create_directories(folder_);
    }
    ~SpectrumFile() override { std::filesystem::remove_all(folder_); }

    const std::filesystem::path folder_;
};

Spectrum read_spectrum(const std::filesystem::path& path)
{
    const auto planes = read_spectrum_planes(path);
    EXPECT_EQ(planes.size(), 1u) << path;
    return planes.front();
}

/// The metadata that write_spectrum was given, as OpenEXR finds them.
std::map<std::string, std::string> read_metadata(const std::filesystem::path& path)
{
    const std::string prefix = "poissonlab:meta:";
    const Imf::InputFile file(path.c_str());
    std::map<std::string, std::string> metadata;
    for (auto it = file.header().begin(); it != file.header().end(); ++it)
        if (std::string_view(it.name()).starts_with(prefix))
            metadata[it.name() + prefix.size()] = dynamic_cast<const Imf::StringAttribute&>(it.attribute()).value();
    return metadata;
}

Spectrum random_spectrum(int size)
{
    std::mt19937_64 random(1);
    Spectrum spectrum{2, size, 16'384, 10, {}};
    for (int i = 0; i < size * size; ++i) spectrum.power.push_back(10.0 * uniform(random));
    return spectrum;
}

TEST_F(SpectrumFile, ComesBackAsFloats)
{
    Spectrum expected = random_spectrum(50);
    const auto path = folder_ / "spectrum.exr";
    write_spectrum(path, expected, {});
    for (double& power : expected.power) power = static_cast<float>(power);
    const Spectrum read = read_spectrum(path);
    EXPECT_EQ(read.dimension, 2);
    EXPECT_EQ(read.size, 50);
    EXPECT_EQ(read.points, 16'384u);
    EXPECT_EQ(read.realizations, 10);
    EXPECT_EQ(read.power, expected.power);
    // No other file is left in the folder.
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(SpectrumFile, OfAVolumeHoldsItsPlanes)
{
    constexpr int size = 6;
    Spectrum volume{3, size, 100, 4, {}};
    for (int w = -size / 2; w < size / 2; ++w)
        for (int v = -size / 2; v < size / 2; ++v)
            for (int u = -size / 2; u < size / 2; ++u) volume.power.push_back(100 * u + 10 * v + w);
    const auto path = folder_ / "spectrum.exr";
    write_spectrum(path, volume, {{"seed", "1"}});
    const auto planes = read_spectrum_planes(path);
    ASSERT_EQ(planes.size(), shown_planes(size).size());
    for (const Spectrum& plane : planes) {
        EXPECT_EQ(plane.size, size);
        EXPECT_EQ(plane.points, 100u);
        EXPECT_EQ(plane.realizations, 4);
    }
    EXPECT_EQ(planes[0].at(2, -3), 100 * 2 + 10 * -3); // xy
    EXPECT_EQ(planes[1].at(2, -3), 100 * 2 + -3);      // xz
    EXPECT_EQ(planes[2].at(2, -3), 10 * 2 + -3);       // yz
    EXPECT_EQ(planes[5].at(2, -3), -300 + 10 * 2 - 3); // yz where x is -3
    EXPECT_EQ(read_metadata(path).at("seed"), "1");

    // Programs that know OpenEXR find three layers of float32.
    const Imf::InputFile file(path.c_str());
    for (const char* channel : {"xy.Y", "xz.Y", "yz.Y", "xy_-3.Y", "xz_-3.Y", "yz_-3.Y", "xy_1.Y"}) {
        ASSERT_NE(file.header().channels().findChannel(channel), nullptr) << channel;
        EXPECT_EQ(file.header().channels().findChannel(channel)->type, Imf::FLOAT);
    }
    write_spectrum(path, random_spectrum(8), {});
    EXPECT_EQ(read_spectrum_planes(path).size(), 1u);
}

TEST_F(SpectrumFile, HasVariancesOfSeveralRealizations)
{
    Spectrum spectrum = random_spectrum(8);
    const auto path = folder_ / "spectrum.exr";
    write_spectrum(path, spectrum, {});
    EXPECT_TRUE(read_spectrum(path).variance.empty());
    for (const double power : spectrum.power) spectrum.variance.push_back(std::floor(power));
    write_spectrum(path, spectrum, {});
    EXPECT_EQ(read_spectrum(path).variance, spectrum.variance);
}

TEST_F(SpectrumFile, OfAllFrequenciesIsATallImage)
{
    constexpr int size = 4;
    Spectrum volume{3, size, 100, 4, {}};
    for (int i = 0; i < size * size * size; ++i) volume.power.push_back(i);
    const auto path = folder_ / "volume.exr";
    write_spectrum_volume(path, volume, {{"seed", "1"}});

    Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().dataWindow().max.x, size - 1);
    ASSERT_EQ(file.header().dataWindow().max.y, size * size - 1);
    std::vector<float> pixels(volume.power.size());
    Imf::FrameBuffer frame;
    frame.insert("Y",
                 Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float), sizeof(float) * size));
    file.setFrameBuffer(frame);
    file.readPixels(0, size * size - 1);
    EXPECT_EQ(std::vector<double>(pixels.begin(), pixels.end()), volume.power);
    EXPECT_THROW(write_spectrum_volume(path, random_spectrum(8), {}), std::invalid_argument);
}

TEST_F(SpectrumFile, KeepsMetadata)
{
    // "type" and "compression" mean something to OpenEXR itself; ours must not get in the way.
    const std::map<std::string, std::string> metadata{{"seed", "18446744073709551615"},
                                                      {"type", "periodogram"},
                                                      {"compression", "none"},
                                                      {"config", "title = \"caf\xc3\xa9\"\n[analysis]\n"},
                                                      {"label", ""}};
    const auto path = folder_ / "spectrum.exr";
    write_spectrum(path, random_spectrum(8), metadata);
    EXPECT_EQ(read_metadata(path), metadata);
    EXPECT_EQ(read_spectrum(path).size, 8);
}

TEST_F(SpectrumFile, RefusesForeignFiles)
{
    EXPECT_THROW(read_spectrum(folder_ / "missing.exr"), InputError);

    const auto text = folder_ / "text.exr";
    std::ofstream(text) << "0.1 0.2\n";
    EXPECT_THROW(read_spectrum(text), InputError);

    const auto image = folder_ / "image.exr";
    {
        const std::vector<Imf::Rgba> pixels(64);
        Imf::RgbaOutputFile file(image.c_str(), 8, 8, Imf::WRITE_Y); // "Y", but half floats
        file.setFrameBuffer(pixels.data(), 1, 8);
        file.writePixels(8);
    }
    EXPECT_THROW(read_spectrum(image), InputError);
}

TEST_F(SpectrumFile, RefusesTruncatedFiles)
{
    const auto path = folder_ / "spectrum.exr";
    write_spectrum(path, random_spectrum(32), {});
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    EXPECT_THROW(read_spectrum(path), InputError);
}

/// The file with the value of an attribute changed.
void patch_attribute(const std::filesystem::path& path, const std::string& name_and_type, std::string_view value)
{
    std::string bytes = read_whole_file(path);
    const std::size_t at = bytes.find(name_and_type);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at + name_and_type.size(), value.size(), value);
    std::ofstream(path, std::ios::binary) << bytes;
}

TEST_F(SpectrumFile, TakesNoMemoryForWhatTheFileCannotHold)
{
    const auto path = folder_ / "spectrum.exr";
    const auto error = [&] { return message_of([&] { read_spectrum(path); }); };
    // 16 x 16 pixels, in a file of 8 x 8; OpenEXR only sees that there are as many rows as the header says.
    write_spectrum(path, random_spectrum(8), {});
    patch_attribute(path, std::string("dataWindow\0box2i\0", 17),
                    std::string("\x10\0\0\0\0\0\0\0\0\0\0\0\x0f\0\0\0\x0f\0\0\0", 20));
    EXPECT_THAT(error(), testing::MatchesRegex(".*bytes are too few for its 16 x 16 pixels"));
    // Rows of 256 MiB each, of which OpenEXR would take some into memory at once.
    write_spectrum(path, random_spectrum(8), {});
    patch_attribute(path, std::string("dataWindow\0box2i\0", 17),
                    std::string("\x10\0\0\0\0\0\0\0\0\0\0\0\xff\xff\xff\x03\x07\0\0\0", 20));
    EXPECT_THAT(error(), testing::HasSubstr("Invalid width (67108864) too large"));
    // A text of 1 GiB.
    write_spectrum(path, random_spectrum(8), {{"label", "L"}});
    patch_attribute(path, std::string("poissonlab:meta:label\0string\0", 29), std::string("\0\0\0\x40", 4));
    EXPECT_THAT(error(), testing::EndsWith("'poissonlab:meta:label', type 'string': Invalid size 1073741824"));
}

TEST_F(SpectrumFile, ReportsWhatCannotBeWritten)
{
    EXPECT_THROW(write_spectrum(folder_ / "nowhere" / "spectrum.exr", random_spectrum(8), {}), StorageError);
}

}
}
