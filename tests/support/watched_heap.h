#pragma once

// Replaces operator new of the program that links watched_heap.cpp: counts what a thread holds, and fills
// what it gets.

#include <cstddef>
#include <optional>

namespace texplorer::test {

/// The byte that fills new memory of this thread; without one it stays as it was.
extern thread_local std::optional<std::byte> heapFill;

/// While it exists: how many bytes this thread has allocated and not freed, at the highest. Under
/// AddressSanitizer malloc is counted too, so that libraries written in C are.
class HeapWatch {
public:
    HeapWatch();
    ~HeapWatch();
    HeapWatch(const HeapWatch&) = delete;
    HeapWatch& operator=(const HeapWatch&) = delete;

    [[nodiscard]] std::size_t peak() const;
};

} // namespace texplorer::test
