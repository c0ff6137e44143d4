#include "tests/support/watched_heap.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <malloc.h>
#include <new>

#if defined(__SANITIZE_ADDRESS__)
#define TEXPLORER_UNDER_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define TEXPLORER_UNDER_ASAN 1
#endif
#endif

#ifdef TEXPLORER_UNDER_ASAN
// <sanitizer/allocator_interface.h>, which GCC doesn't install
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*allocated)(const volatile void*, std::size_t),
                                                         void (*freed)(const volatile void*));
extern "C" std::size_t __sanitizer_get_allocated_size(const volatile void* place);
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

#ifdef TEXPLORER_UNDER_ASAN
void allocated(const volatile void*, std::size_t bytes) {
    count(static_cast<std::int64_t>(bytes));
}

void freed(const volatile void* place) {
    if (watching && place)
        count(-static_cast<std::int64_t>(__sanitizer_get_allocated_size(place)));
}

const int installed = __sanitizer_install_malloc_and_free_hooks(allocated, freed);

void countNew(void*, std::int64_t) {}
#else
void countNew(void* place, std::int64_t sign) {
    if (watching && place)
        count(sign * static_cast<std::int64_t>(malloc_usable_size(place)));
}
#endif

void* allocate(std::size_t bytes, std::size_t alignment) {
    void* place = alignment > alignof(std::max_align_t)
                      ? std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment)
                      : std::malloc(std::max<std::size_t>(bytes, 1));
    if (!place)
        throw std::bad_alloc();
    countNew(place, 1);
    if (heapFill)
        std::memset(place, std::to_integer<int>(*heapFill), bytes);
    return place;
}

void release(void* place) noexcept {
    countNew(place, -1);
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
