// Measured values against limits, and what many of them say of a claim.
#pragma once

#include "results/series.hpp"

#include <string>

namespace poissonlab {

enum class Agreement
{
    agrees,
    partly, ///< at least half of the cases that are decided
    disagrees,
    open,  ///< the results do not decide
    shown, ///< not judged: no result could refute it, or it depends on the machine
};

/// "agrees", "partly", "disagrees", "open", "shown".
const char* name_of(Agreement agreement);

inline Agreement agreement_if(bool holds) { return holds ? Agreement::agrees : Agreement::disagrees; }

/// One case of a claim.
enum class Finding
{
    holds,
    fails,
    open, ///< within two standard errors
};

inline Finding finding_if(bool holds) { return holds ? Finding::holds : Finding::fails; }

/// A value against a limit: open within two standard errors of it. A value without an error counts as exact.
Finding is_above(const Estimate& value, double limit);
Finding is_below(const Estimate& value, double limit);
Finding is_within(const Estimate& value, double low, double high);

Finding both(Finding first, Finding second);
Finding opposite(Finding finding);

/// The difference and the ratio of independent values, with their standard errors.
Estimate difference_of(const Estimate& first, const Estimate& second);
Estimate ratio_of(const Estimate& first, const Estimate& second);

/// The mean over realizations with its standard error, where each is stored and there are several.
Estimate mean_of_realizations(const Statistic& statistic);

/// Counts the cases in which a claim holds. All that are decided: it agrees; at least half of them: partly. Where fewer
/// than a quarter of all cases are decided it is open: chance alone puts one case of twenty beyond two standard errors.
class Tally
{
public:
    void add(bool holds) { add(finding_if(holds)); }
    void add(Finding finding);
    bool empty() const { return held_ + failed_ + open_ == 0; }
    int cases() const { return held_ + failed_ + open_; }
    Agreement agreement() const;
    /// "holds in 40 of 42 cases, 3 more are open", or nothing where there is one that is decided.
    std::string words() const;

private:
    int held_ = 0, failed_ = 0, open_ = 0;
};

}
