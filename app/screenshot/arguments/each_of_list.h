#pragma once

#include "texplorer/base/result.h"

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <vector>

namespace texplorer::screenshot {

/// What `parse` makes of each part between commas, each once; `option` is named in the error.
template<class Parse>
[[nodiscard]] auto parseEach(std::string_view text, const char* option, const Parse& parse)
    -> Result<std::vector<typename std::invoke_result_t<Parse, std::string_view>::value_type>> {
    std::vector<typename std::invoke_result_t<Parse, std::string_view>::value_type> values;
    for (bool more = true; more;) {
        const std::size_t end = std::min(text.find(','), text.size());
        more = end < text.size(); // a comma at the end asks for one more
        const auto value = parse(text.substr(0, end));
        if (!value)
            return fail(value.error());
        if (std::ranges::find(values, *value) != values.end())
            return fail(ErrorCode::OutOfRange,
                        Sentence("expected each once, found \"{0}\" twice", text.substr(0, end)),
                        atOption(option));
        values.push_back(*value);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return values;
}

} // namespace texplorer::screenshot
