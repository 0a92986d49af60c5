// The files that a distribution or scheme consists of, while it is made.
#pragma once

#include "results/pictures/distribution_result.hpp"
#include "results/pictures/mark_picture.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace poissonlab {

struct CurveChart;

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

    /// Adds a file that the result lists for readers.
    std::filesystem::path add(const std::string& name, DistributionResult& result)
    {
        result.files.push_back(name);
        return add(name);
    }

    /// Writes a picture of marks, and lists it in the result.
    void add_marks(const std::string& name, const MarkPicture& picture, const std::string& caption,
                   DistributionResult& result);

    /// Writes curves, to `name`-curves.json, and lists them as a picture of the result. The caption's first sentence is
    /// their title.
    void add_curves(const std::string& name, const CurveChart& chart, const std::string& caption,
                    DistributionResult& result);

    const std::vector<std::string>& names() const { return names_; }

private:
    std::function<std::filesystem::path(const std::string&)> place_;
    std::vector<std::string> names_;
};

}
