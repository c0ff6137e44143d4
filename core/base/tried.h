#pragma once

#include "texplorer/base/result.h"
#include "texplorer/base/thrown.h"

#include <new>
#include <string>
#include <string_view>
#include <type_traits>

namespace texplorer {

/// The messages for work that throws.
struct FailureWords {
    std::string_view noMemory; ///< the whole sentence: "not enough memory for the picture"
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

/// Returns the result of `work`. Errors: those of `work`; TooLarge on std::bad_alloc; Unsupported, with
/// reasonOf, for any other exception.
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
