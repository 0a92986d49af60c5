// The least distances of points of several classes from each other.
//
// Wei, Multi-class blue noise sampling, SIGGRAPH 2010, section 3.2 (the r-matrix). The paper's r is the minimum
// distance.
#pragma once

#include <cstddef>
#include <vector>

namespace poissonlab {

inline constexpr std::size_t most_classes = 32;

/// A symmetric matrix: how far points of class i are from those of class j at least, in unit lengths.
class ClassDistances
{
public:
    ClassDistances() = default;
    explicit ClassDistances(std::size_t classes) : classes_(classes), distances_(classes * classes) {}

    std::size_t classes() const { return classes_; }
    double at(std::size_t i, std::size_t j) const { return distances_[i * classes_ + j]; }
    void set(std::size_t i, std::size_t j, double distance)
    {
        distances_[i * classes_ + j] = distances_[j * classes_ + i] = distance;
    }

    ClassDistances scaled(double by) const
    {
        ClassDistances all = *this;
        for (double& distance : all.distances_) distance *= by;
        return all;
    }

    bool operator==(const ClassDistances&) const = default;

private:
    std::size_t classes_ = 0;
    std::vector<double> distances_;
};

/// The matrix of classes that have these distances each: classes come by distance, the largest first; those of equal
/// distance together. What has come so far is as dense as all its classes are, 1 / distance^dimension of each, and the
/// class that comes keeps the distance of that density from those before.
ClassDistances wei_distances(const std::vector<double>& distances, int dimension);

}
