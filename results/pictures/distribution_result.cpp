#include "results/pictures/distribution_result.hpp"

#include "base/files/json_members.hpp"

#include <algorithm>

namespace poissonlab {
namespace {

void describe_number(JsonMembers& m, Stored<DistributionNumber> auto& number)
{
    m.member("key", number.key);
    m.member("title", number.title);
    m.member("value", number.value);
    m.member("meaning", number.meaning);
    if (m.is_there("standard_error", number.standard_error.has_value()))
        m.member("standard_error", number.standard_error);
    m.if_any("in_table", number.is_in_table);
    m.if_any("time", number.is_time);
}

void describe_parameter(JsonMembers& m, Stored<DistributionParameter> auto& parameter)
{
    m.member("key", parameter.key);
    m.member("value", parameter.value);
}

void describe_picture(JsonMembers& m, Stored<DistributionPicture> auto& picture)
{
    m.file_name("file", picture.file);
    m.member("caption", picture.caption);
}

void describe_row(JsonMembers& m, Stored<std::vector<std::string>> auto& row) { m.member("cells", row); }

void describe_table(JsonMembers& m, Stored<DistributionTable> auto& table)
{
    m.member("title", table.title);
    m.member("columns", table.columns);
    m.objects("rows", table.rows, [](JsonMembers& n, auto& row) { describe_row(n, row); });
    m.check([&](const StoredObject& object) {
        for (const auto& row : table.rows)
            if (row.size() != table.columns.size())
                throw object.error("rows", "must have as many cells each as there are columns");
    });
}

void describe_distribution(JsonMembers& m, Stored<DistributionResult> auto& distribution)
{
    m.folder_name("name", distribution.name);
    m.member("label", distribution.label);
    m.member("kind", distribution.kind);
    m.member("facts", distribution.facts);
    if (m.is_there("parameters", !distribution.parameters.empty()))
        m.objects("parameters", distribution.parameters,
                  [](JsonMembers& n, auto& parameter) { describe_parameter(n, parameter); });
    m.objects("numbers", distribution.numbers, [](JsonMembers& n, auto& number) { describe_number(n, number); });
    m.objects("pictures", distribution.pictures, [](JsonMembers& n, auto& picture) { describe_picture(n, picture); });
    m.file_names("files", distribution.files);
    if (m.is_there("tables", !distribution.tables.empty()))
        m.objects("tables", distribution.tables, [](JsonMembers& n, auto& table) { describe_table(n, table); });
}

}

std::string DistributionResult::parameter(const std::string& key) const
{
    const auto found = std::ranges::find(parameters, key, &DistributionParameter::key);
    return found == parameters.end() ? "" : found->value;
}

void members(JsonMembers& m, const DistributionResult& distribution) { describe_distribution(m, distribution); }
void members(JsonMembers& m, DistributionResult& distribution) { describe_distribution(m, distribution); }

}
