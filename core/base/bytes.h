#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace texplorer {

/// An allocator whose `resize` leaves new elements uninitialised: a buffer that is about to be filled need
/// not be zeroed first (touching new pages costs more than the copy).
template<class T>
struct DefaultInitAllocator : std::allocator<T> {
    template<class U>
    struct rebind {
        using other = DefaultInitAllocator<U>;
    };
    using std::allocator<T>::allocator;

    template<class U>
    void construct(U* place) noexcept {
        ::new (static_cast<void*>(place)) U;
    }
    template<class U, class... Args>
    void construct(U* place, Args&&... args) {
        ::new (static_cast<void*>(place)) U(std::forward<Args>(args)...);
    }
};

using Bytes = std::vector<std::byte, DefaultInitAllocator<std::byte>>;
using ByteView = std::span<const std::byte>;

// Sizes that a file states are 64 bits, even where pointers are 32 bits: their product may exceed all memory.

/// Returns the bytes of that part that exist in the file.
[[nodiscard]] inline ByteView partOf(ByteView file, std::uint64_t offset, std::uint64_t size) {
    const auto begin = static_cast<std::size_t>(std::min<std::uint64_t>(offset, file.size()));
    return file.subspan(begin, static_cast<std::size_t>(std::min<std::uint64_t>(size, file.size() - begin)));
}

} // namespace texplorer
