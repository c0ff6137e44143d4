#pragma once

// What of a program moves by key frames: a table of keys for each parameter, and a variable that holds what
// they say in the present frame.

#include "texplorer/base/translatable.h"
#include "texplorer/emit/code.h"
#include "texplorer/emit/flavour.h"
#include "texplorer/scene/params/params.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::emit {

/// A parameter with keys of different values.
struct MovingParam {
    struct Key {
        float seconds;
        Easing easing;
        Value value;
        std::string text; ///< the value as the scene has it
    };

    const ParamRow* row;
    std::vector<Key> keys; ///< in the order of their times
    std::string variable;  ///< "lightPosition"
    Value standing;        ///< in the scene that the program is written of
    bool isUsed = false;   ///< some line of the program has the variable
    bool isLeft = false;   ///< a line of what is set once was left to the frames

    /// 1 for a number, 4 for a colour; 0: it is no number, but a name, a switch or an index, which holds
    /// until the next key comes.
    [[nodiscard]] std::size_t components() const;
};

/// A parameter that a program can't move. No path: there is none.
struct RefusedParam {
    std::string path;
    Sentence why; ///< the end of a sentence: "can't animate this, because …"
};

/// The key frames of a scene. A program is written once, of the standing scene, in which each parameter that
/// moves has one of its values. The writer puts a variable where the value of such a parameter stands; where
/// the program itself depends on the value, the parameter is refused.
class KeyFrames {
public:
    KeyFrames() = default; ///< nothing has any
    KeyFrames(Flavour flavour, const Scene& scene);

    [[nodiscard]] bool empty() const { return params_.empty(); }
    [[nodiscard]] bool moves(std::string_view path) const { return params_.contains(path); }
    /// Any parameter whose path begins with this, "passes[0].units[1].matrix".
    [[nodiscard]] bool movesBelow(std::string_view prefix) const;
    /// Any parameter that a program has asked for.
    [[nodiscard]] bool isUsed() const;

    /// The scene without its keys. Numbers have a value between two keys, where hardly anything is 0 or 1 by
    /// chance; what can be switched on is on.
    [[nodiscard]] const Scene& standing() const { return standing_; }
    /// Another one, in which moving parameters have other values; for tests, as programs have to be the same.
    void standAt(Scene scene);

    /// The variable of a parameter that moves.
    [[nodiscard]] const std::string& use(std::string_view path);
    /// A line with its value is left to the frames.
    void leave(std::string_view path) { params_.find(path)->second.isLeft = true; }
    /// Puts the variable in the place of a value, in a line of a frame. Refuses the parameter if the part
    /// isn't the value itself, but was computed of it.
    void replace(Part& part);
    void refuse(std::string_view path, Sentence why);

    /// What `decide` returns for the scene. It has to return the same for all values of the parameters with
    /// these paths, or below them; the first one that changes it is refused.
    template<class Decide>
    auto decided(const Scene& scene, const std::vector<std::string>& paths, const Decide& decide,
                 const Sentence& why = N_("its values need different calls")) {
        auto decision = decide(scene);
        refuseChanges(
            scene, paths, [&](const Scene& other) { return decide(other) == decision; }, why);
        return decision;
    }
    /// Whether `test` is true for any value that an enumerant takes, which is `now` if it doesn't move.
    template<class Enum, class Test>
    [[nodiscard]] bool mayBe(std::string_view path, Enum now, const Test& test) const {
        const auto is = [&](const MovingParam::Key& key) {
            return test(static_cast<Enum>(std::get<EnumValue>(key.value).number));
        };
        return moves(path) ? std::ranges::any_of(params_.find(path)->second.keys, is) : test(now);
    }
    /// All values that an index takes, which is `now` if it doesn't move.
    [[nodiscard]] std::vector<int> indicesOf(std::string_view path, int now) const;

    /// The first parameter that the program can't move, or that was left to frames which don't set it;
    /// none: it moves all that it mentions.
    [[nodiscard]] RefusedParam refused() const;

    using Params = std::map<std::string, MovingParam, std::less<>>;
    [[nodiscard]] const Params& params() const { return params_; }

private:
    void refuseChanges(const Scene& scene, const std::vector<std::string>& paths,
                       const std::function<bool(const Scene&)>& isSame, const Sentence& why);

    Params params_;
    Scene standing_;
    RefusedParam refused_;
};

/// One of a value's numbers, counted from 0.
[[nodiscard]] float numberIn(const Value& value, std::size_t component);

/// "passes[0].units[1].envColor" as "pass0Unit1EnvColor".
[[nodiscard]] std::string variableOf(std::string_view path);

} // namespace texplorer::emit
