#pragma once

// The results of glGetError: OpenGL 2.1, section 2.5, table 2.3.

#include "texplorer/gl/enum_row.h"

namespace texplorer {

enum class GlError : std::uint32_t {
    InvalidEnum = 0x0500,
    InvalidValue = 0x0501,
    InvalidOperation = 0x0502,
    StackOverflow = 0x0503,
    StackUnderflow = 0x0504,
    OutOfMemory = 0x0505,
    InvalidFramebufferOperation = 0x0506,
    ContextLost = 0x0507,
};

inline constexpr std::array glErrorRows{
    row(GlError::InvalidEnum, "GL_INVALID_ENUM", "Invalid enum", "An enumerant is not accepted here.", "1.0"),
    row(GlError::InvalidValue, "GL_INVALID_VALUE", "Invalid value", "A number is out of range.", "1.0"),
    row(GlError::InvalidOperation, "GL_INVALID_OPERATION", "Invalid operation",
        "The call is not allowed in the current state.", "1.0"),
    row(GlError::StackOverflow, "GL_STACK_OVERFLOW", "Stack overflow", "A stack is full.", "1.0"),
    row(GlError::StackUnderflow, "GL_STACK_UNDERFLOW", "Stack underflow", "A stack is empty.", "1.0"),
    row(GlError::OutOfMemory, "GL_OUT_OF_MEMORY", "Out of memory",
        "The driver has not enough memory for "
        "it.",
        "1.0"),
    row(GlError::InvalidFramebufferOperation, "GL_INVALID_FRAMEBUFFER_OPERATION", "Invalid framebuffer",
        "The bound framebuffer is not complete.", "3.0"),
    row(GlError::ContextLost, "GL_CONTEXT_LOST", "Context lost",
        "The graphics card was reset and has lost all its contents.", "4.5"),
};

template<>
struct EnumTable<GlError> {
    static constexpr std::span<const EnumRow> rows = glErrorRows;
};

static_assert(glErrorRows.size() == 8);

} // namespace texplorer
