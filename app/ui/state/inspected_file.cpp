#include "app/ui/state/inspected_file.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <numeric>
#include <vector>

namespace texplorer::ui {

FieldMap::FieldMap(const Anatomy& anatomy) {
    const std::vector<Field>& fields = anatomy.fields;
    std::vector<std::size_t> order(fields.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // Painted from the largest to the smallest, so that a field covers the section that it is part of.
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return fields[i].size; });
    starts_[0] = std::nullopt;
    for (const std::size_t index : order) {
        const Field& field = fields[index];
        const std::uint64_t begin = field.offset;
        const std::uint64_t end = begin + std::min<std::uint64_t>(field.size, UINT64_MAX - begin);
        if (begin == end)
            continue;
        const auto after = std::prev(starts_.upper_bound(end))->second; // what goes on behind it
        starts_.erase(starts_.lower_bound(begin), starts_.upper_bound(end));
        starts_[begin] = index;
        starts_[end] = after;
    }
}

std::optional<std::size_t> FieldMap::at(std::uint64_t offset) const {
    const auto next = starts_.upper_bound(offset);
    return next == starts_.begin() ? std::nullopt : std::prev(next)->second;
}

} // namespace texplorer::ui
