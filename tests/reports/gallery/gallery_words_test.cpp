// Sentences on methods of the gallery that are better than a series.
#include "reports/pages/gallery_words.hpp"

#include <gtest/gtest.h>

namespace poissonlab {
namespace {

TEST(GalleryWords, SayHowManyMethodsAreBetterAndWhichIsBest)
{
    Series series;
    series.measures.numbers["low_frequency_mean"] = {0.06, 0.001};
    series.measures.numbers["mean_nearest_distance"] = {0.7, {}};
    std::vector<GalleryMethod> methods(4);
    const std::vector<std::string> labels{"A", "B", "C", "D"};
    const std::vector<Estimate> noise{{0.02, 0.001}, {0.058, 0.002}, {0.9, {}}},
        distances{{0.7, 0.1}, {0.95, {}}, {0.8, {}}};
    for (std::size_t i = 0; i < 4; ++i) methods[i].label = labels[i];
    for (std::size_t i = 0; i < 3; ++i) {
        methods[i].measures["low_frequency_mean"] = noise[i];
        methods[i].measures["mean_nearest_distance"] = distances[i];
    }
    std::vector<const GalleryMethod*> gallery;
    for (const GalleryMethod& method : methods) gallery.push_back(&method);
    const auto words = [&](const char* key) {
        const std::string all = better_in_gallery(measure(key), series, 2, gallery);
        const std::string title = measure(key).title() + ": ";
        EXPECT_TRUE(all.empty() || all.starts_with(title)) << all;
        return all.substr(std::min(all.size(), title.size()));
    };
    EXPECT_EQ(words("low_frequency_mean"), "1 of 3 methods is better, the best is A (0.0200).") << "B is as good";
    EXPECT_EQ(words("mean_nearest_distance"), "2 of 3 methods are better, the best is B (0.9500).");
    series.measures.numbers["mean_nearest_distance"] = {0.96, {}};
    EXPECT_EQ(words("mean_nearest_distance"), "none of 3 methods is better.");
    EXPECT_EQ(words("oscillation"), "") << "the series has none";
    series.measures.numbers["effective_nyquist"] = {0.5, {}};
    EXPECT_EQ(words("effective_nyquist"), "") << "the gallery has none";
    EXPECT_EQ(words("hyperuniformity_p_value"), "") << "no value is better";
}

}
}
