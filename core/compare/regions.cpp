#include "texplorer/compare/regions.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace texplorer {

namespace {

/// Adjacent pixels of a row, and their region.
struct Run {
    int first;
    int last;
    std::size_t region;
};

/// A region that is still growing; one that was joined to another has that as its parent.
struct Growing {
    std::size_t parent;
    DifferentRegion region;
};

/// [first, last] of every run of set bits.
template<class Take>
void eachRun(std::span<const std::uint64_t> words, const Take& take) {
    int begin = -1;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const int base = static_cast<int>(i) * 64;
        std::uint64_t word = words[i];
        int at = 0;
        while (at < 64) {
            const std::uint64_t rest = (begin < 0 ? word : ~word) >> static_cast<unsigned>(at);
            if (rest == 0)
                break;
            at += std::countr_zero(rest);
            if (begin < 0)
                begin = base + at;
            else
                take(std::exchange(begin, -1), base + at - 1);
        }
    }
    if (begin >= 0)
        take(begin, static_cast<int>(words.size()) * 64 - 1);
}

void join(DifferentRegion& a, const DifferentRegion& b) {
    const int right = std::max(a.bounds.x + a.bounds.width, b.bounds.x + b.bounds.width);
    const int bottom = std::max(a.bounds.y + a.bounds.height, b.bounds.y + b.bounds.height);
    a.bounds.x = std::min(a.bounds.x, b.bounds.x);
    a.bounds.y = std::min(a.bounds.y, b.bounds.y);
    a.bounds.width = right - a.bounds.x;
    a.bounds.height = bottom - a.bounds.y;
    a.pixels += b.pixels;
}

class Sweep {
public:
    explicit Sweep(std::size_t kept)
        : kept_(kept) {}

    void row(std::span<const std::uint64_t> words, int y) {
        current_.clear();
        eachRun(words, [&](int first, int last) {
            const auto width = last - first + 1;
            growing_.push_back({growing_.size(), {{first, y, width, 1}, static_cast<std::size_t>(width)}});
            current_.push_back({first, last, growing_.size() - 1});
        });
        connect();
        finish();
        std::swap(above_, current_);
    }

    Regions end() {
        current_.clear();
        finish();
        return std::move(found_);
    }

private:
    std::size_t rootOf(std::size_t i) {
        while (growing_[i].parent != i)
            i = growing_[i].parent = growing_[growing_[i].parent].parent;
        return i;
    }

    void connect() {
        auto above = above_.begin();
        for (const Run& run : current_) {
            while (above != above_.end() && above->last + 1 < run.first)
                ++above;
            // The last one that touches this run may touch the next one, too.
            for (auto each = above; each != above_.end() && each->first <= run.last + 1; ++each) {
                const std::size_t a = rootOf(each->region);
                const std::size_t b = rootOf(run.region);
                if (a == b)
                    continue;
                growing_[b].parent = a;
                join(growing_[a].region, growing_[b].region);
            }
        }
    }

    /// Regions that have nothing in the current row are complete; the others are renumbered.
    void finish() {
        constexpr std::size_t none = ~std::size_t{0};
        std::vector<std::size_t>& numbers = numbers_;
        numbers.assign(growing_.size(), none);
        next_.clear();
        for (Run& run : current_) {
            const std::size_t root = rootOf(run.region);
            if (numbers[root] == none) {
                numbers[root] = next_.size();
                next_.push_back({next_.size(), growing_[root].region});
            }
            run.region = numbers[root];
        }
        for (std::size_t i = 0; i < growing_.size(); ++i)
            if (growing_[i].parent == i && numbers[i] == none)
                complete(growing_[i].region);
        std::swap(growing_, next_);
    }

    void complete(const DifferentRegion& region) {
        ++found_.count;
        const auto isBefore = [](const DifferentRegion& a, const DifferentRegion& b) {
            if (a.pixels != b.pixels)
                return a.pixels > b.pixels;
            return std::pair(a.bounds.y, a.bounds.x) < std::pair(b.bounds.y, b.bounds.x);
        };
        auto& largest = found_.largest;
        largest.insert(std::ranges::upper_bound(largest, region, isBefore), region);
        if (largest.size() > kept_)
            largest.pop_back();
    }

    std::size_t kept_;
    Regions found_;
    std::vector<Run> above_;
    std::vector<Run> current_;
    std::vector<Growing> growing_;
    std::vector<Growing> next_;
    std::vector<std::size_t> numbers_;
};

} // namespace

Regions regionsIn(const PixelBits& bits, const PixelRect& rows, std::size_t kept) {
    Sweep sweep(kept);
    for (int y = rows.y; y < rows.y + rows.height; ++y)
        sweep.row(bits.row(y), y);
    return sweep.end();
}

} // namespace texplorer
