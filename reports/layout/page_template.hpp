// The files of reports/templates/, embedded at build time.
#pragma once

#include <string_view>

namespace poissonlab {

/// The text of a file, named as below reports/ ("templates/report.css"); empty for unknown names.
std::string_view page_template_file(std::string_view name);

}
