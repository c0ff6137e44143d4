#pragma once

// The functions for the tables of params_*.cpp: param<&Texture::minFilter>(…) makes a row's read, write and
// kind from the member itself, so that a row always agrees with its struct. Included only by those files.

#include "texplorer/scene/params/params.h"

namespace texplorer::build {

/// As many vertices as a shape can have.
inline constexpr std::size_t maxTexCoords = std::size_t{maxSubdivision + 1} * (maxSubdivision + 1);
static_assert(maxTexCoords >= maxMeshVertices);

template<class>
struct MemberOf;
template<class O, class T>
struct MemberOf<T O::*> {
    using Owner = O;
    using Type = T;
};
/// The struct whose table contains the members of `T`: itself, except for a base without its own table.
template<class T>
struct TableOf {
    using Struct = T;
};
template<>
struct TableOf<SamplerState> {
    using Struct = Texture;
};
template<auto Member>
using Owner = typename TableOf<typename MemberOf<decltype(Member)>::Owner>::Struct;
template<auto Member>
using Type = typename MemberOf<decltype(Member)>::Type;

template<auto Member>
const Type<Member>& get(const void* owner) {
    return static_cast<const Owner<Member>*>(owner)->*Member;
}
template<auto Member>
Type<Member>& get(void* owner) {
    return static_cast<Owner<Member>*>(owner)->*Member;
}

template<class T>
consteval Kind kindOf() {
    if constexpr (std::is_same_v<T, bool>)
        return Kind::Bool;
    else if constexpr (std::is_same_v<T, int>)
        return Kind::Int;
    else if constexpr (std::is_same_v<T, float>)
        return Kind::Float;
    else if constexpr (std::is_same_v<T, glm::vec3>)
        return Kind::Vec3;
    else if constexpr (std::is_same_v<T, glm::vec4>)
        return Kind::Vec4;
    else if constexpr (std::is_same_v<T, glm::mat4>)
        return Kind::Matrix;
    else if constexpr (std::is_same_v<T, std::string>)
        return Kind::Text;
    else if constexpr (std::is_same_v<T, SharedList<glm::vec3>>)
        return Kind::PointList;
    else if constexpr (std::is_same_v<T, SharedList<glm::vec4>>)
        return Kind::TexCoordList;
    else if constexpr (std::is_same_v<T, SharedList<int>> || std::is_same_v<T, std::vector<int>>)
        return Kind::IndexList;
    else {
        static_assert(Enumerated<T>, "a member needs a Kind or an EnumTable");
        return Kind::Enum;
    }
}

template<auto Member>
Value read(const void* owner) {
    using T = Type<Member>;
    if constexpr (Enumerated<T>)
        return EnumValue{static_cast<std::uint32_t>(get<Member>(owner))};
    else if constexpr (std::is_same_v<T, std::vector<int>>)
        return SharedList<int>(get<Member>(owner));
    else
        return Value(std::in_place_type<T>, get<Member>(owner));
}

template<auto Member>
void write(void* owner, const Value& value) {
    using T = Type<Member>;
    if constexpr (Enumerated<T>)
        get<Member>(owner) = static_cast<T>(std::get<EnumValue>(value).number);
    else if constexpr (std::is_same_v<T, std::vector<int>>)
        get<Member>(owner) = std::get<SharedList<int>>(value).read();
    else
        get<Member>(owner) = std::get<T>(value);
}

template<class T>
constexpr std::span<const EnumRow> choicesOf() {
    if constexpr (Enumerated<T>)
        return EnumTable<T>::rows;
    else
        return {};
}

/// A row for a member. Numbers need a range; other types have none.
template<auto Member>
constexpr ParamRow param(std::string_view key, std::string_view group, std::string_view label,
                         std::string_view glCall, std::string_view help, Range range = {}) {
    return {memberId<Member>,
            key,
            group,
            label,
            help,
            glCall,
            kindOf<Type<Member>>(),
            range,
            choicesOf<Type<Member>>(),
            read<Member>,
            write<Member>};
}

/// A row for a vec4 that is a colour: each component from 0 to 1, GL's clamp.
template<auto Member>
constexpr ParamRow color(std::string_view key, std::string_view group, std::string_view label,
                         std::string_view glCall, std::string_view help) {
    static_assert(std::is_same_v<Type<Member>, glm::vec4>);
    ParamRow row = param<Member>(key, group, label, glCall, help, {0, 1, 0.005F, {}});
    row.kind = Kind::Color;
    return row;
}

/// A row for a list of at most `maxCount` elements. Whole numbers need a range.
template<auto Member>
constexpr ParamRow list(std::string_view key, std::string_view group, std::string_view label,
                        std::string_view glCall, std::string_view help, std::size_t maxCount,
                        Range range = {}) {
    ParamRow row = param<Member>(key, group, label, glCall, help, range);
    row.maxCount = maxCount;
    return row;
}

/// A list of colours: 3 or 4 numbers each, from 0 to 1.
template<auto Member>
constexpr ParamRow colors(std::string_view key, std::string_view group, std::string_view label,
                          std::string_view glCall, std::string_view help, std::size_t maxCount) {
    ParamRow row = list<Member>(key, group, label, glCall, help, maxCount, {0, 1, 0.005F, {}});
    row.kind = Kind::ColorList;
    return row;
}

/// A row for one element of an array of lists about vertices.
template<auto Member, std::size_t Index>
constexpr ParamRow vertexList(std::string_view key, std::string_view group, std::string_view label,
                              std::string_view glCall, std::string_view help, Range range = {}) {
    using List = typename Type<Member>::value_type;
    using Shared = SharedList<typename List::value_type>;
    constexpr auto readList = [](const void* owner) -> Value { return Shared(get<Member>(owner)[Index]); };
    constexpr auto writeList = [](void* owner, const Value& value) {
        get<Member>(owner)[Index] = std::get<Shared>(value);
    };
    return {memberId<Member>, key,   group, label,    help,      glCall,
            kindOf<List>(),   range, {},    readList, writeList, maxTexCoords};
}

/// A member that is one struct. Its initial value is that of its owner.
template<auto Member>
ChildRow single(std::string_view key, std::string_view label, const StructTable& table) {
    return {memberId<Member>,
            key,
            label,
            &table,
            false,
            1,
            1,
            [](const void*) -> std::size_t { return 1; },
            [](void* owner, std::size_t) -> void* { return &get<Member>(owner); },
            [](void* owner, std::size_t count) {
                if (count == 0)
                    get<Member>(owner) = Owner<Member>{}.*Member;
            },
            [](const void* owner, std::size_t) { return get<Member>(owner) == Owner<Member>{}.*Member; }};
}

template<class List>
auto elementAt(List& list, std::size_t index) {
    return list.begin() + static_cast<std::ptrdiff_t>(index);
}

/// A member that is a vector or an array of structs.
template<auto Member>
ChildRow many(std::string_view key, std::string_view label, const StructTable& table, std::size_t minCount,
              std::size_t maxCount) {
    using List = Type<Member>;
    using T = typename List::value_type;
    ChildRow row{memberId<Member>,
                 key,
                 label,
                 &table,
                 true,
                 minCount,
                 maxCount,
                 [](const void* owner) -> std::size_t { return get<Member>(owner).size(); },
                 [](void* owner, std::size_t index) -> void* { return &get<Member>(owner)[index]; },
                 [](void* owner, std::size_t count) {
                     List& list = get<Member>(owner);
                     if constexpr (requires { list.resize(count); })
                         list.resize(count);
                     else
                         for (std::size_t i = count; i < list.size(); ++i)
                             list[i] = T{};
                 },
                 [](const void* owner, std::size_t index) { return get<Member>(owner)[index] == T{}; }};
    if constexpr (requires(List & list) { list.resize(0); }) {
        row.insert = [](void* owner, std::size_t index, const void* like) {
            List& list = get<Member>(owner);
            T element = like ? *static_cast<const T*>(like) : T{};
            list.insert(elementAt(list, index), std::move(element));
        };
        row.erase = [](void* owner, std::size_t index) {
            List& list = get<Member>(owner);
            list.erase(elementAt(list, index));
        };
        row.move = [](void* owner, std::size_t from, std::size_t to) {
            List& list = get<Member>(owner);
            if (from < to)
                std::rotate(elementAt(list, from), elementAt(list, from + 1), elementAt(list, to + 1));
            else
                std::rotate(elementAt(list, to), elementAt(list, from), elementAt(list, from + 1));
        };
    }
    return row;
}

/// Converts to any type, to count members.
struct Anything {
    template<class T>
    operator T() const;
};

/// The number of members of an aggregate, with its base as one: the longest list of initialisers that it
/// accepts. A static_assert with it makes sure that a table lacks no member.
template<class T, class... Initialisers>
consteval std::size_t memberCount() {
    if constexpr (requires { T{Initialisers{}..., Anything{}}; })
        return memberCount<T, Initialisers..., Anything>();
    else
        return sizeof...(Initialisers);
}

} // namespace texplorer::build
