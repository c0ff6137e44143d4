#pragma once

#include "core/base/result.h"
#include "core/base/thrown.h"

#include <new>
#include <string>
#include <string_view>
#include <type_traits>

namespace texplorer {

/// What to say where work throws instead of returning an error.
struct FailureWords {
    std::string_view noMemory; ///< the whole sentence: "there is no memory for the picture"
    std::string_view other;    ///< its beginning, with a colon: "the picture can't be drawn"
};

namespace detail {
template<class T>
struct AsResult {
    using Type = Result<T>;
};
template<class T>
struct AsResult<Result<T>> {
    using Type = Result<T>;
};
} // namespace detail

/// What `work` returns, a Result or what becomes one. Errors: its own; TooLarge where there is no memory;
/// Unsupported, with reasonOf, where it throws anything else.
template<class Work>
[[nodiscard]] auto tried(const FailureWords& words, const Work& work) ->
    typename detail::AsResult<std::invoke_result_t<const Work&>>::Type {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, std::string(words.noMemory));
    } catch (const std::exception& error) {
        return fail(ErrorCode::Unsupported, std::string(words.other).append(": ").append(reasonOf(error)));
    }
}

} // namespace texplorer
