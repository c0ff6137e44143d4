#pragma once

// Work that may end its process, or never end, done by the number in child processes: what a child dies of is
// charged to the number that it was at, and the next one goes on behind it.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::random {

/// What a child says while it works. Every line is written at once, so that none dies with the child.
class Journal {
public:
    Journal(int pipe, unsigned limitSeconds)
        : pipe_(pipe)
        , limitSeconds_(limitSeconds) {}

    /// Names what comes next: where the child was if it dies, or has no end.
    void step(std::string_view name);
    /// Something to be counted or told, one line each.
    void note(std::string_view kind, std::string_view text) { write("note", kind, text); }

private:
    friend class Child;
    void write(std::string_view word, std::string_view kind, std::string_view text);

    int pipe_;
    unsigned limitSeconds_;
};

struct Note {
    int number = 0;
    std::string kind;
    std::string text;
};

struct Death {
    int number = 0;
    std::string step;   ///< the last one that was begun; empty: none
    std::string cause;  ///< "Segmentation fault", "no end within 120 s"
    bool alone = false; ///< in a child of its own, too; else only behind what its child did before
    int first = 0;      ///< of the child's numbers
};

struct Batches {
    int first = 0;
    int count = 0;
    int size = 50;                      ///< numbers a child: from a multiple of it to the next
    unsigned jobs = 1;                  ///< children at a time
    unsigned limitSeconds = 600;        ///< for one step, by the clock
    unsigned long long memoryLimit = 0; ///< of a child, bytes of address space; 0: none, nor under ASan
    std::function<void(int done)> progress = nullptr; ///< how many numbers are through
};

struct Ended {
    int done = 0;            ///< numbers that came to their end
    std::vector<Note> notes; ///< in the order of their numbers
    std::vector<Death> deaths;
};

using Work = std::function<void(int number, Journal& journal)>;

/// `open` is called once in each child, for the first of its numbers, and what it returns for each of them.
/// An exception is a note of kind "broken". The caller must have one thread only: it is copied.
[[nodiscard]] Ended runBatches(const Batches& batches, const std::function<Work(int first)>& open);

} // namespace texplorer::random
