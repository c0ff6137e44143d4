#include "app/screenshot/output/columns.h"

#include <algorithm>

namespace texplorer::screenshot {

std::size_t columnsOf(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

} // namespace texplorer::screenshot
