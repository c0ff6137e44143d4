#pragma once

#if defined(__SANITIZE_ADDRESS__) // GCC
#define TEXPLORER_UNDER_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TEXPLORER_UNDER_ASAN 1
#endif
#endif

namespace texplorer::test {

#ifdef TEXPLORER_UNDER_ASAN
inline constexpr bool underAsan = true;
#else
inline constexpr bool underAsan = false;
#endif

} // namespace texplorer::test
