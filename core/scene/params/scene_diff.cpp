#include "texplorer/scene/params/scene_diff.h"

#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/scene_check.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <ranges>
#include <utility>

namespace texplorer {
namespace {

constexpr std::size_t shortList = 4; // so many elements are written out

/// What a walk over two scenes meets: the same row of both, or lists of different lengths.
struct PairVisitor {
    std::function<void(const std::string& path, const ParamRow& row, void* a, void* b)> param;
    std::function<void(const std::string& path, const ChildRow& child, void* a, void* b)> lengths;
};

std::string below(const std::string& path, std::string_view key) {
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

/// Everything that both have: of lists the elements that are in both.
void walkPair(const StructTable& table, void* a, void* b, const std::string& path,
              const PairVisitor& visitor) {
    for (const ParamRow& row : table.params)
        visitor.param(below(path, row.key), row, a, b);
    for (const ChildRow& child : table.children) {
        const std::string inside = below(path, child.key);
        if (child.size(a) != child.size(b))
            visitor.lengths(inside, child, a, b);
        const std::size_t common = std::min(child.size(a), child.size(b));
        for (std::size_t i = 0; i < common; ++i)
            walkPair(*child.table, child.at(a, i), child.at(b, i),
                     child.indexed ? fmt::format("{}[{}]", inside, i) : inside, visitor);
    }
}

/// The tables' functions take what they may write to; nothing is written by who only compares.
void* ownerOf(const Scene& scene) {
    return const_cast<Scene*>(&scene);
}

Value elementAt(const ParamRow& row, const Value& list, std::size_t index) {
    if (const auto* numbers = std::get_if<SharedList<int>>(&list))
        return SharedList<int>{(*numbers)[index]};
    return listOf(row.kind, {elementsOf(list).at(index)});
}

std::size_t firstDifference(const Value& a, const Value& b) {
    const auto indexIn = [](const auto& one, const auto& other) {
        return static_cast<std::size_t>(std::ranges::mismatch(one, other).in1 - one.begin());
    };
    if (const auto* numbers = std::get_if<SharedList<int>>(&a))
        return indexIn(*numbers, std::get<SharedList<int>>(b));
    const std::vector<glm::vec4> elements = elementsOf(a);
    return indexIn(elements, elementsOf(b));
}

/// A value as text, of a long list the first element that the other one hasn't.
Sentence textBeside(const ParamRow& row, const Value& value, const Value& other) {
    const std::size_t count = listSize(value);
    if (!isList(row.kind) || std::max(count, listSize(other)) <= shortList)
        return ProperName{formatValue(row, value)};
    const std::size_t first = firstDifference(value, other);
    if (first >= std::min(count, listSize(other)))
        return Sentence::plural("{0} element", "{0} elements", count);
    return Sentence("[{0}] {1} of {2}", first, ProperName{formatValue(row, elementAt(row, value, first))},
                    Sentence::plural("{0} element", "{0} elements", count));
}

void copyStruct(const StructTable& table, void* to, void* from) {
    for (const ParamRow& row : table.params)
        row.write(to, row.read(from));
    for (const ChildRow& child : table.children) {
        if (child.size(to) != child.size(from))
            child.resize(to, child.size(from));
        for (std::size_t i = 0; i < child.size(from); ++i)
            copyStruct(*child.table, child.at(to, i), child.at(from, i));
    }
}

void copyLength(const ChildRow& child, void* to, void* from) {
    const std::size_t had = child.size(to);
    child.resize(to, child.size(from));
    for (std::size_t i = had; i < child.size(from); ++i)
        copyStruct(*child.table, child.at(to, i), child.at(from, i));
}

} // namespace

std::vector<SceneChange> changesBetween(const Scene& from, const Scene& to) {
    std::vector<SceneChange> changes;
    if (from == to)
        return changes;
    walkPair(sceneTable(), ownerOf(from), ownerOf(to), {},
             {[&](const std::string& path, const ParamRow& row, void* a, void* b) {
                  const Value before = row.read(a);
                  const Value after = row.read(b);
                  if (before != after)
                      changes.push_back({path, std::string(row.label), textBeside(row, before, after),
                                         textBeside(row, after, before)});
              },
              [&](const std::string& path, const ChildRow& child, void* a, void* b) {
                  changes.push_back({path, std::string(child.label),
                                     Sentence::plural("{0} element", "{0} elements", child.size(a)),
                                     Sentence::plural("{0} element", "{0} elements", child.size(b)), true});
              }});
    return changes;
}

std::vector<std::string> changedPaths(const Scene& from, const Scene& to) {
    std::vector<std::string> paths;
    walkPair(sceneTable(), ownerOf(from), ownerOf(to), {},
             {[&](const std::string& path, const ParamRow& row, void* a, void* b) {
                  if (row.read(a) != row.read(b))
                      paths.push_back(path);
              },
              [&](const std::string& path, const ChildRow&, void*, void*) { paths.push_back(path); }});
    return paths;
}

Result<void> takeOver(Scene& scene, const Scene& from, std::span<const std::string> paths) {
    Scene edited = scene;
    std::vector<std::function<void()>> copies; // made after the walk, during which no list may be resized
    std::vector<std::string> missing(paths.begin(), paths.end());
    const auto isWanted = [&](const std::string& path) { return std::erase(missing, path) > 0; };
    walkPair(sceneTable(), &edited, ownerOf(from), {},
             {[&](const std::string& at, const ParamRow& row, void* a, void* b) {
                  if (isWanted(at))
                      copies.emplace_back([&row, a, b] { row.write(a, row.read(b)); });
              },
              [&](const std::string& at, const ChildRow& child, void* a, void* b) {
                  if (isWanted(at))
                      copies.emplace_back([&child, a, b] { copyLength(child, a, b); });
              }});
    if (!missing.empty())
        return fail(ErrorCode::NotFound, "expected a parameter or a list that both scenes have",
                    std::move(missing.front()));
    for (const auto& copy : copies | std::views::reverse) // a list moves its elements: the innermost first
        copy();
    if (const Result<void> fits = checkTogether(edited); !fits && checkTogether(scene))
        return fail(ErrorCode::OutOfRange, fits.error().message,
                    paths.empty() ? Location() : Location(paths.front()));
    scene = std::move(edited);
    return {};
}

} // namespace texplorer
