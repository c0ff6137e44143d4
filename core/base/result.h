#pragma once

// Functions that can fail return Result<T>; programming errors are asserts. No public function throws
// anything but std::bad_alloc, and not even that if TooLarge is among its documented errors.

#include "texplorer/base/location.h"
#include "texplorer/base/sentence.h"

#include <tl/expected.hpp>

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
    Sentence message; ///< what was expected and what was found, as one sentence
    Location where;   ///< may be empty

    bool operator==(const Error&) const = default;
};

inline constexpr Sentence::Key<ProperName, Sentence> describedKey = "{0}: {1}";

/// Returns "where: message", or the message alone if `where` is empty.
[[nodiscard]] inline Sentence describe(const Error& error) {
    return error.where.empty() ? error.message
                               : Sentence(describedKey, ProperName{error.where.text()}, error.message);
}

template<class T>
using Result = tl::expected<T, Error>;

/// `return fail(ErrorCode::Malformed, Sentence("expected {0} bytes, found {1}", 54, found), inFile(path));`
[[nodiscard]] inline tl::unexpected<Error> fail(ErrorCode code, Sentence message, Location where = {}) {
    return tl::unexpected<Error>(Error{code, std::move(message), std::move(where)});
}

[[nodiscard]] inline tl::unexpected<Error> fail(Error error) {
    return tl::unexpected<Error>(std::move(error));
}

/// The same error, seen from outside: of a file's content, in that file.
[[nodiscard]] inline Error within(const Location& outer, const Error& error) {
    return {error.code, error.message, outer / error.where};
}

} // namespace texplorer
