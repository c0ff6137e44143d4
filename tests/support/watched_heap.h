#pragma once

// Stands in front of malloc and operator new of the program that links watched_heap.cpp: counts what a thread
// holds, libraries written in C included, and fills what operator new gives it.

#include <cstddef>
#include <optional>

namespace texplorer::test {

/// The byte that fills what operator new gives this thread; without one it stays as it was.
extern thread_local std::optional<std::byte> heapFill;

/// While it exists: how many bytes this thread has allocated and not freed, at the highest.
class HeapWatch {
public:
    HeapWatch();
    ~HeapWatch();
    HeapWatch(const HeapWatch&) = delete;
    HeapWatch& operator=(const HeapWatch&) = delete;

    [[nodiscard]] std::size_t peak() const;
};

} // namespace texplorer::test
