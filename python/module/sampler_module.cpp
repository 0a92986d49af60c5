// The methods of the registry for Python: their descriptions, and the makers of their point sets.
//
// A maker takes the text of a config, so that parameters are checked by the same lines, in the same words, as those of
// a config of the program.
#include "experiment/run/make_experiment.hpp"
#include "host/sampling/guide/sampler_guide.hpp"
#include "host/settings/sampler_help.hpp"
#include "python/module/arrays.hpp"
#include "python/module/module_parts.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace py = pybind11;

namespace poissonlab {

const char* kind_of(const ParameterSpec& spec)
{
    switch (spec.kind) {
    case ParameterSpec::Kind::number:
        return "number";
    case ParameterSpec::Kind::integer:
        return "integer";
    case ParameterSpec::Kind::boolean:
        return "boolean";
    case ParameterSpec::Kind::text:
        return "text";
    case ParameterSpec::Kind::choice:
        return "choice";
    case ParameterSpec::Kind::paths:
        return "paths";
    case ParameterSpec::Kind::command:
        return "command";
    default:
        return "sampler";
    }
}

py::object default_of(const ParameterSpec& spec)
{
    if (!spec.otherwise) return py::none();
    if (const SamplerChoice* sampler = as_sampler(*spec.otherwise)) return py::str(sampler->spec->name);
    return std::visit(
        [](const auto& value) -> py::object {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::shared_ptr<const SamplerChoice>>)
                return py::none();
            else
                return py::cast(value);
        },
        *spec.otherwise);
}

namespace {

py::dict description_of(const ParameterSpec& spec)
{
    py::dict description;
    description["key"] = spec.key;
    description["kind"] = kind_of(spec);
    description["choices"] = spec.choices;
    description["default"] = default_of(spec);
    description["help"] = option_help(spec);
    description["unless_given"] = spec.unless_given;
    return description;
}

py::dict description_of(const SamplerSpec& sampler)
{
    py::list parameters;
    for (const ParameterSpec& spec : sampler.parameters) parameters.append(description_of(spec));
    py::dict description;
    description["name"] = sampler.name;
    description["title"] = sampler.title;
    description["summary"] = sampler.summary;
    const SamplerGuide& guide = sampler_guide(sampler.name);
    description["source"] = guide.source;
    description["use"] = guide.use;
    description["avoid"] = guide.avoid;
    description["dimensions"] = sampler.dimensions;
    description["deterministic"] = sampler.deterministic;
    description["has_own_points"] = sampler.has_own_points;
    description["parameters"] = parameters;
    return description;
}

py::list descriptions()
{
    py::list list;
    for (const SamplerSpec& sampler : sampler_registry()) list.append(description_of(sampler));
    return list;
}

/// The experiment of a config with one series. Messages about the config say `name` alone: it has no lines that the
/// caller has seen.
Experiment experiment_of(const std::string& name, const std::string& config_text)
{
    try {
        const Config config = parse_config(config_text, name);
        Experiment experiment = make_experiment(config, config.device, 0);
        if (experiment.series.size() != 1)
            throw InputError::at({name}, "a list of values makes several series: an object is made of one value");
        return experiment;
    } catch (const InputError& error) {
        throw error.place().file == name ? error.moved_to({name}) : error;
    }
}

/// Makes the point sets of one series.
class SetMaker
{
public:
    SetMaker(std::string name, const std::string& config) : name_(std::move(name))
    {
        experiment_ = without_lock([&] { return experiment_of(name_, config); });
        experiment_.workplace->on_step = [](const std::string&) { stop_if_interrupted(); };
    }

    /// See Sampler::expect(). Numbers that no realization has are refused by sample().
    void expect(std::int64_t first, std::int64_t count)
    {
        const auto number = [](std::int64_t value) {
            return static_cast<std::uint32_t>(std::clamp<std::int64_t>(value, 0, UINT32_MAX));
        };
        without_lock([&] {
            expected_ = {number(first), number(count)};
            if (sampler_) sampler_->expect(expected_.first, expected_.second);
        });
    }

    /// The sampler holds memory of a device, and may be in use by no one else.
    py::array_t<double> sample(std::int64_t realization)
    {
        return array_of(without_lock([&] { return make(realization); }));
    }

    /// The traits of the sampler's sets, defaults before the first one. Another thread may be making a set: it takes
    /// its turn.
    SetTraits traits() const
    {
        return without_lock([&] { return sampler_ ? sampler_->traits() : SetTraits{}; });
    }

private:
    const SeriesTask& task() const { return experiment_.series.front(); }

    PointSet make(std::int64_t realization)
    {
        // Sets that are there already are not timed, and there are as many as there are.
        const std::int64_t most =
            task().is_timed() ? std::numeric_limits<std::uint32_t>::max() : task().realizations - 1;
        if (realization < 0 || realization > most)
            throw InputError(fmt::format("{}: realization {}: must be from 0 to {}", name_, realization, most));
        try {
            if (!sampler_) {
                sampler_ = task().create();
                sampler_->expect(expected_.first, expected_.second);
            }
            return sampler_->sample(static_cast<std::uint32_t>(realization));
        } catch (const InputError& error) {
            throw error.place().file == name_ ? error.moved_to({name_}) : error;
        }
    }

    std::string name_;
    Experiment experiment_;
    std::unique_ptr<Sampler> sampler_; ///< made for the first set
    std::pair<std::uint32_t, std::uint32_t> expected_{};
};

}

void add_samplers(py::module_& module)
{
    const auto trait = [](auto SetTraits::*member) {
        return [member](const SetMaker& maker) { return maker.traits().*member; };
    };
    module.def("samplers", descriptions, "The methods and their parameters, a dict each.");
    py::class_<SetMaker>(module, "SetMaker", "Makes the point sets of one series of a config.")
        .def(py::init<std::string, const std::string&>(), py::arg("name"), py::arg("config"))
        .def("expect", &SetMaker::expect, py::arg("first"), py::arg("count"),
             "Tells that so many realizations are asked for next: some methods make several at once.")
        .def("sample", &SetMaker::sample, py::arg("realization"), "A realization, shape (points, dimension).")
        .def_property_readonly("sizes_vary", trait(&SetTraits::sizes_vary))
        .def_property_readonly("is_window", trait(&SetTraits::is_window))
        .def_property_readonly("tiles_along_axis", trait(&SetTraits::tiles_along_axis))
        .def_property_readonly("proven_relative_radius", trait(&SetTraits::proven_relative_radius));
}

}
