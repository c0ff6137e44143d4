// Key frames: tables of keys, and a function that finds out what they say. Numbers come out as
// core/scene/params/value_mix.cpp has them, to the last bit.

#include "texplorer/base/sentence_format.h"
#include "texplorer/emit/emission.h"
#include "texplorer/emit/piece_files.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::emit {
namespace {

/// What a program has of an easing (core/scene/timeline.h).
struct EasingFunction {
    Easing easing;
    std::string_view name;
    std::string_view body;
    std::string_view what;
};
constexpr std::array easingFunctions{
    EasingFunction{Easing::Hold, "hold", "(void)share;\n    return 0;", "it jumps when the next key comes"},
    EasingFunction{Easing::Linear, "linear", "return share;", "the same speed all the way"},
    EasingFunction{Easing::EaseIn, "easeIn", "return share * share;", "it begins to move slowly"},
    EasingFunction{Easing::EaseOut, "easeOut", "return share * (2 - share);", "it comes to rest slowly"},
    EasingFunction{Easing::EaseInOut, "easeInOut", "return share * share * (3 - 2 * share);",
                   "it begins and comes to rest slowly"},
};
static_assert(easingFunctions.size() == easingRows.size());

const EasingFunction& functionOf(Easing easing) {
    return *std::ranges::find(easingFunctions, easing, &EasingFunction::easing);
}

/// Below what it includes, which every program does.
std::string functionFile(std::string_view name) {
    const std::string& text = std::ranges::find(keyFrameFiles(), name, &PieceFile::name)->text;
    constexpr std::string_view header = "#include \"gl.h\"\n\n";
    return text.starts_with(header) ? text.substr(header.size()) : text;
}

std::string_view stepName(const MovingParam& param, const Value& value) {
    if (const auto* on = std::get_if<bool>(&value))
        return booleanName(*on);
    const EnumRow* found = findRow(param.row->choices, std::get<EnumValue>(value).number);
    return found ? found->name : std::string_view("0");
}

class KeyFramesWriter {
public:
    explicit KeyFramesWriter(Emission& emission)
        : writer_(emission.writer) {
        for (const auto& [path, param] : emission.keys.params()) {
            if (!param.isUsed)
                continue;
            used_.push_back({path, &param});
            most_ = std::max(most_, param.components());
            hasSteps_ |= param.components() == 0;
        }
    }

    void write() {
        if (used_.empty())
            return;
        if (most_ > 0)
            writeTrack();
        if (hasSteps_)
            writeStep();
        for (const Used& each : used_)
            writeKeys(each);
        writer_.heading("what moves, as it is in the present frame");
        for (const Used& each : used_)
            declare(each);
        writer_.heading("to what the keys say at a time");
        writer_.open("static void animate(double seconds)");
        for (const Used& each : used_)
            assign(each);
        writer_.close();
    }

private:
    struct Used {
        std::string path;
        const MovingParam* param;
    };

    void text(std::string_view words) { writer_.add(linesOf(words)); }

    void writeTrack() {
        text(
            "/* How much of the way to the next key is done after a share of the time, both from 0 to 1. */\n");
        for (const EasingFunction& each : easingFunctions) {
            const bool isUsed = std::ranges::any_of(used_, [&](const Used& used) {
                return used.param->components() > 0 &&
                       std::ranges::find(used.param->keys, each.easing, &MovingParam::Key::easing) !=
                           used.param->keys.end();
            });
            if (isUsed)
                text(fmt::format("\nstatic double {}(double share) /* {} */\n{{\n    {}\n}}\n", each.name,
                                 each.what, each.body));
        }
        std::string track = functionFile("track.c");
        constexpr std::string_view most = "value[4]";
        track.replace(track.find(most), most.size(), fmt::format("value[{}]", most_));
        text(track);
    }

    void writeStep() { text(functionFile("step.c")); }

    [[nodiscard]] static std::string tableOf(const MovingParam& param) {
        return param.variable + (param.components() == 0 ? "Steps" : "Keys");
    }

    void writeKeys(const Used& used) {
        const MovingParam& param = *used.param;
        const std::string_view unit = param.row->range.unit;
        const bool isNumber = param.components() > 0;
        writer_.heading(unit.empty() || !isNumber ? used.path : fmt::format("{}: {}", used.path, unit));
        writer_.add(fmt::format("static const {} {}[] = {{", isNumber ? "Key" : "Step", tableOf(param)));
        writer_.indent();
        for (const MovingParam::Key& key : param.keys) {
            std::string value;
            if (isNumber) {
                for (std::size_t i = 0; i < param.components(); ++i)
                    value += (i > 0 ? ", " : "") + literal(numberIn(key.value, i), Literal::Float);
            } else
                value = key.value.index() == Value(0).index() ? fmt::format("{}", std::get<int>(key.value))
                                                              : std::string(stepName(param, key.value));
            const std::string seconds = literal(key.seconds, Literal::Float);
            const std::string_view easing = functionOf(key.easing).name;
            writer_.add(isNumber ? fmt::format("{{{}, {}, {{{}}}}},", seconds, easing, value)
                                 : fmt::format("{{{}, {}}},", seconds, value));
        }
        writer_.outdent();
        writer_.add("};");
    }

    void declare(const Used& used) {
        const MovingParam& param = *used.param;
        const std::size_t count = param.components();
        const std::string_view type = count == 0                     ? "GLenum"
                                      : param.row->kind == Kind::Int ? "GLint"
                                                                     : "GLfloat";
        writer_.add(count > 1 ? fmt::format("static {} {}[{}];", type, param.variable, count)
                              : fmt::format("static {} {};", type, param.variable));
    }

    /// What the mouse does to it.
    static std::string_view beside(const MovingParam& param) {
        const MemberId member = param.row->member;
        return member == memberId<&View::azimuth>     ? "azimuth + "
               : member == memberId<&View::elevation> ? "elevation + "
               : member == memberId<&View::distance>  ? "distance * "
                                                      : "";
    }

    void assign(const Used& used) {
        const MovingParam& param = *used.param;
        const std::size_t count = param.components();
        const std::string keys = fmt::format("{}, {}, seconds", tableOf(param), param.keys.size());
        if (count == 0)
            return writer_.add(fmt::format("{} = step({});", param.variable, keys));
        const std::string found = fmt::format("track({}, {})", keys, count > 1 ? "i" : "0");
        const bool isWhole = param.row->kind == Kind::Int;
        const std::string value =
            isWhole ? fmt::format("(GLint)lround({})", found) : fmt::format("(GLfloat){}", found);
        if (count == 1)
            return writer_.add(fmt::format("{} = {}{};", param.variable, beside(param), value));
        writer_.add(fmt::format("for (int i = 0; i < {}; ++i)", count));
        writer_.indent();
        writer_.add(fmt::format("{}[i] = {};", param.variable, value));
        writer_.outdent();
    }

    CodeWriter& writer_;
    std::vector<Used> used_;
    std::size_t most_ = 0; ///< numbers of a key
    bool hasSteps_ = false;
};

} // namespace

void writeKeyFrames(Emission& emission) {
    KeyFramesWriter(emission).write();
}

void writeKeyFramesCall(Emission& emission) {
    CodeWriter& writer = emission.writer;
    if (emission.keys.isUsed())
        writer.add({plain("animate("), writer.seconds(), plain(");")});
}

} // namespace texplorer::emit
