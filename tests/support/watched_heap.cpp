#include "tests/support/watched_heap.h"

#include "tests/support/under_asan.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <malloc.h>
#include <new>

#ifdef TEXPLORER_UNDER_ASAN
// <sanitizer/allocator_interface.h>, which GCC doesn't install
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*allocated)(const volatile void*, std::size_t),
                                                         void (*freed)(const volatile void*));
extern "C" std::size_t __sanitizer_get_allocated_size(const volatile void* place);
#elif defined(__GLIBC__)
// glibc's own, for programs that put something in front of them
extern "C" {
void* __libc_malloc(std::size_t bytes);
void* __libc_calloc(std::size_t count, std::size_t bytes);
void* __libc_realloc(void* place, std::size_t bytes);
void* __libc_memalign(std::size_t alignment, std::size_t bytes);
void __libc_free(void* place);
}
#endif

namespace texplorer::test {

thread_local std::optional<std::byte> heapFill;

namespace {

thread_local bool watching = false;
thread_local std::int64_t held = 0; // below 0 where older memory is freed
thread_local std::int64_t highest = 0;

void count(std::int64_t bytes) {
    if (!watching)
        return;
    held += bytes;
    highest = std::max(highest, held);
}

[[maybe_unused]] void allocated(const volatile void* /*place*/, std::size_t bytes) {
    count(static_cast<std::int64_t>(bytes));
}

#ifdef TEXPLORER_UNDER_ASAN
void freed(const volatile void* place) {
    if (watching && place)
        count(-static_cast<std::int64_t>(__sanitizer_get_allocated_size(place)));
}

constexpr bool counts = true; // what malloc gives
const int installed = __sanitizer_install_malloc_and_free_hooks(allocated, freed);
#else
#ifdef __GLIBC__
constexpr bool counts = true;
void* counted(void* place) {
    if (watching && place)
        allocated(place, malloc_usable_size(place));
    return place;
}
#else
constexpr bool counts = false; // only what operator new gives
#endif

void freed(void* place) {
    if (watching && place)
        count(-static_cast<std::int64_t>(malloc_usable_size(place)));
}
#endif

void* allocate(std::size_t bytes, std::size_t alignment) {
    void* place = alignment > alignof(std::max_align_t)
                      ? std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)
                      : std::malloc(std::max<std::size_t>(bytes, 1));
    if (!place)
        throw std::bad_alloc();
    if (!counts)
        count(static_cast<std::int64_t>(malloc_usable_size(place)));
    if (heapFill)
        std::memset(place, std::to_integer<int>(*heapFill), bytes);
    return place;
}

void release(void* place) {
    if (!counts)
        freed(place);
    std::free(place);
}

} // namespace

HeapWatch::HeapWatch() {
    held = 0;
    highest = 0;
    watching = true;
}

HeapWatch::~HeapWatch() {
    watching = false;
}

std::size_t HeapWatch::peak() const {
    return static_cast<std::size_t>(highest);
}

} // namespace texplorer::test

#if defined(__GLIBC__) && !defined(TEXPLORER_UNDER_ASAN)
using texplorer::test::counted;
using texplorer::test::freed;

extern "C" {
void* malloc(std::size_t bytes) noexcept {
    return counted(__libc_malloc(bytes));
}
void* calloc(std::size_t count, std::size_t bytes) noexcept {
    return counted(__libc_calloc(count, bytes));
}
void* realloc(void* place, std::size_t bytes) noexcept {
    freed(place);
    return counted(__libc_realloc(place, bytes));
}
void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
    return counted(__libc_memalign(alignment, bytes));
}
void* memalign(std::size_t alignment, std::size_t bytes) noexcept {
    return counted(__libc_memalign(alignment, bytes));
}
int posix_memalign(void** place, std::size_t alignment, std::size_t bytes) noexcept {
    void* made = counted(__libc_memalign(alignment, bytes));
    if (!made)
        return ENOMEM;
    *place = made;
    return 0;
}
void free(void* place) noexcept {
    freed(place);
    __libc_free(place);
}
}
#endif

using texplorer::test::allocate;
using texplorer::test::release;

void* operator new(std::size_t bytes) {
    return allocate(bytes, 1);
}
void* operator new[](std::size_t bytes) {
    return allocate(bytes, 1);
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t bytes, std::align_val_t alignment) {
    return allocate(bytes, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    try {
        return allocate(bytes, 1);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
    return operator new(bytes, std::nothrow);
}
void operator delete(void* place) noexcept {
    release(place);
}
void operator delete[](void* place) noexcept {
    release(place);
}
void operator delete(void* place, std::size_t) noexcept {
    release(place);
}
void operator delete[](void* place, std::size_t) noexcept {
    release(place);
}
void operator delete(void* place, std::align_val_t) noexcept {
    release(place);
}
void operator delete[](void* place, std::align_val_t) noexcept {
    release(place);
}
void operator delete(void* place, std::size_t, std::align_val_t) noexcept {
    release(place);
}
void operator delete[](void* place, std::size_t, std::align_val_t) noexcept {
    release(place);
}
void operator delete(void* place, const std::nothrow_t&) noexcept {
    release(place);
}
void operator delete[](void* place, const std::nothrow_t&) noexcept {
    release(place);
}
