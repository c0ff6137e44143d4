#pragma once

// Functions that can fail return Result<T>; programming errors are asserts. No public function throws
// anything but std::bad_alloc, and not even that if TooLarge is among its documented errors.

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace texplorer {

enum class ErrorCode {
    NotFound,    ///< no such file
    Unreadable,  ///< exists but cannot be read (permission, directory, device)
    Unwritable,  ///< the target cannot be written
    Malformed,   ///< the content violates its format
    Unsupported, ///< valid, but not supported by Texplorer or the driver
    OutOfRange,  ///< a number or name outside the accepted range
    TooLarge,    ///< exceeds a stated limit
    Driver,      ///< an error of OpenGL
    Cancelled,   ///< stopped on request
};

struct Error {
    ErrorCode code;
    std::string message; ///< what was expected and what was found, as one sentence
    std::string where;   ///< a file, a JSON pointer, a parameter path or a GL call; may be empty

    bool operator==(const Error&) const = default;
};

/// Returns "where: message", or the message alone if `where` is empty.
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
