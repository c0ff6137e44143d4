#pragma once

// What of a program moves by key frames: a table of keys for each parameter, and a variable that holds what
// they say in the present frame.

#include "texplorer/emit/code.h"
#include "texplorer/scene/params/params.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace texplorer::emit {

/// A parameter whose keys say different things.
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
    bool isUsed = false;   ///< some line of the program has the variable
    bool isLeft = false;   ///< a line of what is set once was left to the frames

    /// 1 for a number, 4 for a colour; 0: it is no number, but a name, a switch or an index, which holds
    /// until the next key comes.
    [[nodiscard]] std::size_t components() const;
};

/// Of a scene, with what a program has found out of them while it was written.
class KeyFrames {
public:
    KeyFrames() = default; ///< nothing has any
    explicit KeyFrames(const Scene& scene);

    [[nodiscard]] bool empty() const { return params_.empty(); }
    [[nodiscard]] bool moves(std::string_view path) const { return params_.contains(path); }
    /// Any parameter whose path begins with this, "passes[0].units[1].matrix".
    [[nodiscard]] bool movesBelow(std::string_view prefix) const;
    /// Any parameter that a program has asked for.
    [[nodiscard]] bool isUsed() const;

    /// The variable of a parameter that moves.
    [[nodiscard]] const std::string& use(std::string_view path);
    /// A line with its value is left to the frames.
    void leave(std::string_view path) { params_.find(path)->second.isLeft = true; }
    /// The scene at the time for which the program is written, which stays there until it is another one.
    void standAt(const Scene& standing) { standing_ = &standing; }
    /// Whether a parameter that is on or off is so then.
    [[nodiscard]] bool isSwitched(std::string_view path, bool on) const;
    /// What stands for a value in a line of a frame. A part that isn't the very value of its parameter can't
    /// be moved, and is remembered.
    void replace(Part& part);
    /// Where a line that isn't of a frame has the value of a parameter that moves.
    void refuse(std::string_view path);
    /// The first parameter that the program couldn't move, or that was left to frames which don't set it;
    /// empty: it moves all that it mentions.
    [[nodiscard]] const std::string& refused() const;

    using Params = std::map<std::string, MovingParam, std::less<>>;
    [[nodiscard]] const Params& params() const { return params_; }

private:
    Params params_;
    const Scene* standing_ = nullptr;
    std::string refused_;
};

/// One of a value's numbers, counted from 0.
[[nodiscard]] float numberIn(const Value& value, std::size_t component);

/// "passes[0].units[1].envColor" as "pass0Unit1EnvColor".
[[nodiscard]] std::string variableOf(std::string_view path);

} // namespace texplorer::emit
