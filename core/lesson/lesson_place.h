#pragma once

// The position of an error in a lesson.json.

#include "texplorer/base/result.h"

#include <fmt/core.h>

#include <cstddef>
#include <string>

namespace texplorer::lesson {

[[nodiscard]] inline std::string placeOf(std::size_t step) {
    return fmt::format("/steps/{}", step);
}

[[nodiscard]] inline Error at(const std::string& place, const Error& error) {
    return within(atPointer(place), error);
}

} // namespace texplorer::lesson
