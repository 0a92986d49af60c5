#include "results/pictures/distribution_result.hpp"

#include "base/files/json_members.hpp"

namespace poissonlab {
namespace {

void describe_number(JsonMembers& m, Stored<DistributionNumber> auto& number)
{
    m.member("key", number.key);
    m.member("title", number.title);
    m.member("value", number.value);
    m.member("meaning", number.meaning);
}

void describe_picture(JsonMembers& m, Stored<DistributionPicture> auto& picture)
{
    m.file_name("file", picture.file);
    m.member("caption", picture.caption);
}

void describe_distribution(JsonMembers& m, Stored<DistributionResult> auto& distribution)
{
    m.folder_name("name", distribution.name);
    m.member("label", distribution.label);
    m.member("kind", distribution.kind);
    m.member("facts", distribution.facts);
    m.objects("numbers", distribution.numbers, [](JsonMembers& n, auto& number) { describe_number(n, number); });
    m.objects("pictures", distribution.pictures, [](JsonMembers& n, auto& picture) { describe_picture(n, picture); });
    m.file_names("files", distribution.files);
}

}

void members(JsonMembers& m, const DistributionResult& distribution) { describe_distribution(m, distribution); }
void members(JsonMembers& m, DistributionResult& distribution) { describe_distribution(m, distribution); }

}
