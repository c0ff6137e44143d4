#pragma once

#include <atomic>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

namespace texplorer {

/// A list whose copies are cheap: they share the elements until one of them is edited. A value like a
/// std::vector, which it is read as. Elements are changed in the std::vector that `edit` returns.
template<class T>
class SharedList {
public:
    using List = std::vector<T>;
    using value_type = T;
    using size_type = std::size_t;
    using difference_type = std::ptrdiff_t;
    using reference = const T&;
    using const_reference = const T&;
    using iterator = typename List::const_iterator;
    using const_iterator = typename List::const_iterator;

    SharedList() = default;
    SharedList(List list) // NOLINT(google-explicit-constructor): the same value
        : list_(list.empty() ? nullptr : std::make_shared<List>(std::move(list))) {}
    SharedList(std::initializer_list<T> elements)
        : SharedList(List(elements)) {}
    explicit SharedList(std::size_t count, const T& element = T{})
        : SharedList(List(count, element)) {}

    operator const List&() const { return read(); } // NOLINT(google-explicit-constructor): likewise
    [[nodiscard]] const List& read() const {
        static const List none;
        return list_ ? *list_ : none;
    }
    /// The elements of this list alone: they are copied first if other lists share them.
    [[nodiscard]] List& edit() {
        if (!list_)
            list_ = std::make_shared<List>();
        else if (list_.use_count() != 1)
            list_ = std::make_shared<List>(*list_);
        std::atomic_thread_fence(std::memory_order_acquire); // a thread that has let go has read before
        return *list_;
    }

    [[nodiscard]] const_iterator begin() const { return read().begin(); }
    [[nodiscard]] const_iterator end() const { return read().end(); }
    [[nodiscard]] std::size_t size() const { return read().size(); }
    [[nodiscard]] bool empty() const { return read().empty(); }
    [[nodiscard]] const T* data() const { return read().data(); }
    [[nodiscard]] const T& operator[](std::size_t index) const { return read()[index]; }
    [[nodiscard]] const T& front() const { return read().front(); }
    [[nodiscard]] const T& back() const { return read().back(); }

    void clear() { list_.reset(); }
    void resize(std::size_t count) { edit().resize(count); }
    void reserve(std::size_t count) { edit().reserve(count); }
    void assign(std::size_t count, const T& element) { *this = SharedList(count, element); }
    void push_back(const T& element) { edit().push_back(element); }
    template<class... Arguments>
    void emplace_back(Arguments&&... arguments) {
        edit().emplace_back(std::forward<Arguments>(arguments)...);
    }

    bool operator==(const SharedList& other) const { return list_ == other.list_ || read() == other.read(); }

private:
    std::shared_ptr<List> list_;
};

} // namespace texplorer
