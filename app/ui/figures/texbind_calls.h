#pragma once

#include "texplorer/reference/texture_calls.h"

#include <vector>

namespace texplorer::ui {

/// A call of a program, and what it shows.
struct ToldCall {
    objects::Call call;
    const char* remark;
};

/// texbind.c of the OpenGL Programming Guide: two objects, and an environment that is set once.
[[nodiscard]] const std::vector<ToldCall>& texbindCalls();

} // namespace texplorer::ui
