#pragma once

#include "app/command_line/command_line.h"
#include "app/view/context_choice.h"

namespace texplorer::screenshot {

/// Which OpenGL draws, as the command line or TEXPLORER_CONTEXT spells it.
struct ContextArgument {
    std::string text = view::ContextChoice().text();
    const Option* option = nullptr;
};

/// Declares --context.
void addContextArgument(Command& command, ContextArgument& argument);

/// The error is about whichever said it, --context or the variable.
[[nodiscard]] Result<view::ContextChoice> parseContext(const ContextArgument& argument);

} // namespace texplorer::screenshot
