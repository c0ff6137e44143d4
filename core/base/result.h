#pragma once

// A function that can fail returns Result<T>; programming mistakes are asserts. No exception leaves a public
// function but std::bad_alloc, and not even that one where TooLarge is among the errors that it names.

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace texplorer {

enum class ErrorCode {
    NotFound,    ///< no such file
    Unreadable,  ///< it exists and can't be read (permission, directory, device)
    Unwritable,  ///< the target can't be written
    Malformed,   ///< the content contradicts its format
    Unsupported, ///< valid, but a variant that we or the driver don't have
    OutOfRange,  ///< a number or name outside of what is accepted
    TooLarge,    ///< it would exceed a stated limit
    Driver,      ///< OpenGL refused
    Cancelled,   ///< a stop was requested
};

struct Error {
    ErrorCode code;
    std::string message; ///< what was expected and what was found, as one sentence
    std::string where;   ///< a file, a JSON pointer, a parameter path or a GL call; may be empty

    bool operator==(const Error&) const = default;
};

/// "where: message", or the message alone where there is no place to name.
[[nodiscard]] inline std::string describe(const Error& error) {
    return error.where.empty() ? error.message : error.where + ": " + error.message;
}

template<class T>
using Result = tl::expected<T, Error>;

/// `return fail(ErrorCode::Malformed, "expected 54 bytes, found 3", path);`
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, std::string message, std::string where = {}) {
    return tl::unexpected<Error>(Error{code, std::move(message), std::move(where)});
}

[[nodiscard]] inline tl::unexpected<Error> fail(Error error) {
    return tl::unexpected<Error>(std::move(error));
}

} // namespace texplorer
