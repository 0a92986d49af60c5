// The sampling test in the report: pictures, plots, words, and damaged results.
#include "analysis/zone_plate/zone_plate_reference.hpp"
#include "base/images/square_image.hpp"
#include "tests/reports/support/page_text.hpp"
#include "tests/reports/support/report_fixture.hpp"
#include "tests/support/picture.hpp"

#include <gmock/gmock.h>

namespace poissonlab {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Gives a series a picture, errors and a curve.
void add_zone_plate(const fs::path& folder, nlohmann::json& series, int size)
{
    const auto name = series["name"].get<std::string>();
    write_square_image(folder / name / "zone-plate.exr", zone_plate_reference(size), {});
    write_whole_file(folder / name / "zone-plate.csv",
                     "distance,frequency,rms_error,pixels\n0.25,0.1,0.05,9\n30.25,1.9,0.27,90\n");
    series["zone_plate"] = {{"size", size},
                            {"file", name + "/zone-plate.exr"},
                            {"error_file", name + "/zone-plate.csv"},
                            {"rms_error", {{"min", 0.24}, {"mean", 0.25}, {"max", 0.26}}},
                            {"resolved_rms_error", {{"min", 0.1234}, {"mean", 0.1234}, {"max", 0.1234}}}};
}

class ZonePlateReport : public test::ReportFixture
{
};

TEST_F(ZonePlateReport, ShowsPicturesPlotsAndNumbers)
{
    add_zone_plate(path(), json_["series"][0], 64);
    add_zone_plate(path(), json_["series"][1], 64);
    print_ = PrintPictures::drawn;
    const auto text = page();
    EXPECT_THAT(text, HasSubstr("<b>Zone plate error.</b>"));
    EXPECT_THAT(text, HasSubstr("<td data-key=\"zone_plate_error\"><data value=\"0.1234\">0.1234</data></td>"));
    EXPECT_THAT(text, HasSubstr("<data value=\"0.25\">0.2500</data> <span class=\"spread\">0.2400 to 0.2600</span>"));
    EXPECT_THAT(text, HasSubstr("RMS error 0.2500 (0.2400 to 0.2600) over the picture, 0.1234 up to half a "
                                "cycle per pixel."));
    EXPECT_THAT(text, HasSubstr("64 × 64 pixels, 256 samples (first of 2 realizations)."));
    EXPECT_EQ(test::count_of(text, "<figcaption>"), 3 * 7 + 2 * 2 + 2 * (3 + 1) + 1 + 3 * 4);
    for (const char* file : {"random/zone-plate.png", "random/zone-plate-error.png", "jittered/zone-plate.png",
                             "zone-plate-error-all.png", "zone-plate-reference.png"})
        EXPECT_GT(test::decode_png(read_whole_file(path() / file)).variance(), 1) << file;
    EXPECT_FALSE(fs::exists(path() / "regular/zone-plate.png"));
    EXPECT_EQ(page(), text) << "the same every time";
}

TEST_F(ZonePlateReport, PlotsHaveDistancesWhereSizesAgree)
{
    add_zone_plate(path(), json_["series"][0], 64);
    add_zone_plate(path(), json_["series"][1], 32);
    page();
    const auto svg = [&](const char* name) { return read_whole_file(path() / name); };
    for (const char* name : {"random/zone-plate-error.svg", "zone-plate-error-all.svg"})
        EXPECT_THAT(svg(name), HasSubstr(">frequency of the plate (cycles per pixel)<"));
    EXPECT_THAT(svg("random/zone-plate-error.svg"), HasSubstr(">distance from the origin<"));
    EXPECT_THAT(svg("zone-plate-error-all.svg"), Not(HasSubstr(">distance from the origin<")));
}

TEST_F(ZonePlateReport, OneSeriesHasNoPlotOfAll)
{
    add_zone_plate(path(), json_["series"][2], 64);
    EXPECT_THAT(page(), Not(HasSubstr("over the frequency of the plate.")));
    EXPECT_FALSE(fs::exists(path() / "zone-plate-error-all.svg"));
}

TEST_F(ZonePlateReport, SmallPicturesHaveNoResolvedPart)
{
    add_zone_plate(path(), json_["series"][0], 8);
    json_["series"][0]["zone_plate"]["resolved_rms_error"] = nullptr;
    EXPECT_THAT(page(), HasSubstr("RMS error 0.2500 (0.2400 to 0.2600) over the picture."));
}

TEST_F(ZonePlateReport, NoneMeansNoWord)
{
    const auto text = page();
    EXPECT_THAT(text, Not(HasSubstr("Zone plate")));
    EXPECT_FALSE(fs::exists(path() / "zone-plate-reference.png"));
}

TEST_F(ZonePlateReport, DamagedResultsNameTheMember)
{
    add_zone_plate(path(), json_["series"][0], 64);
    const auto error_of = [&](auto damage) { return error_after("zone_plate", damage); };
    EXPECT_THAT(error_of([](auto& json) { json["file"] = "random/none.exr"; }),
                HasSubstr("series[0].zone_plate.file = "));
    EXPECT_THAT(error_of([](auto& json) { json["error_file"] = "../zone-plate.csv"; }),
                HasSubstr("series[0].zone_plate.error_file = "));
    EXPECT_THAT(error_of([](auto& json) { json.erase("rms_error"); }),
                HasSubstr("series[0].zone_plate.rms_error: is missing"));
    EXPECT_THAT(error_of([](auto& json) { json["size"] = 65; }),
                HasSubstr("zone-plate.exr: must be an image of 65 x 65, as results.json says"));
    EXPECT_THAT(error_of([](auto& json) { json["error_file"] = "random/radial.csv"; }),
                HasSubstr("radial.csv:1: must be the header distance,"));
}

}
}
