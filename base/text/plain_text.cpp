#include "base/text/plain_text.hpp"

#include "base/errors/errors.hpp"

namespace poissonlab {

std::string_view plain_text(const std::string& name, std::string_view text)
{
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InputError::at({name}, "is in UTF-16, which some programs call \"Unicode\": save it as UTF-8");
    if (text.starts_with("PK\x03\x04"))
        throw InputError::at({name}, "is a ZIP archive, as .npz, .xlsx and .kmz files are: unpack it (.npz holds .npy "
                                     "files), or save it in a format that is not packed");
    if (text.starts_with("\x1F\x8B")) throw InputError::at({name}, "is compressed by gzip: decompress it first");
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    return text;
}

}
