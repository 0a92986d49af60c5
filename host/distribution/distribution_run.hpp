// Makes what the tables [[distribution]] of a config ask for: points and objects with their pictures and measures.
#pragma once

#include "host/config/distributions/distribution_config.hpp"
#include "host/distribution/distribution_place.hpp"
#include "host/distribution/even_points.hpp"
#include "results/pictures/distribution_result.hpp"
#include "results/pictures/mark_picture.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace poissonlab {

/// The files of one distribution: where each is to be written, and which there are.
class DistributionFiles
{
public:
    /// `place` says where a file of this name is to be written.
    explicit DistributionFiles(std::function<std::filesystem::path(const std::string& name)> place)
        : place_(std::move(place))
    {}

    std::filesystem::path add(const std::string& name)
    {
        names_.push_back(name);
        return place_(name);
    }

    /// Writes a picture of marks, and lists it in the result.
    void add_marks(const std::string& name, const MarkPicture& picture, const std::string& caption,
                   DistributionResult& result);

    const std::vector<std::string>& names() const { return names_; }

private:
    std::function<std::filesystem::path(const std::string&)> place_;
    std::vector<std::string> names_;
};

/// Makes one distribution and writes its files. The result has no name and no label; names of files are without folder.
/// Throws InputError where it cannot be made, and StorageError.
DistributionResult make_distribution(const DistributionConfig& config, const DistributionPlace& place,
                                     DistributionFiles& files);

/// The density that a config's choice says; formulas are over a square.
Density chosen_density(const DensityChoice& choice);

/// The method of even points that it says. Reads the tile set's file.
EvenMethod chosen_method(const EvenMethodChoice& choice);

/// "corner-tiles" or the file's name, for facts.
std::string method_words(const EvenMethodChoice& choice);

// One function a kind, in a file of its own.
DistributionResult make_warped(const WarpSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                               DistributionFiles& files);
DistributionResult make_self_similar_tile(const SelfSimilarSettings& settings, const DistributionPlace& place,
                                          DistributionFiles& files);
DistributionResult make_ranked(const RankSettings& settings, DistributionFiles& files);
DistributionResult make_objects(const ObjectSettings& settings, std::uint64_t seed, const DistributionPlace& place,
                                DistributionFiles& files);

}
