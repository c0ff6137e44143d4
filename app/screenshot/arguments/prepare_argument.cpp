#include "app/screenshot/arguments/prepare_argument.h"

#include "app/command_line/choice_argument.h"
#include "app/screenshot/arguments/picture_argument.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/texture/step_operation.h"

#include <array>

namespace texplorer::screenshot {
namespace {

/// Those of the picture itself: there is no other one.
std::vector<EnumRow> sourceRows() {
    std::vector<EnumRow> rows;
    for (const EnumRow& row : componentSourceRows)
        if (!isOfOther(static_cast<ComponentSource>(row.value)))
            rows.push_back(row);
    return rows;
}

Result<ImageStep> swizzleOf(std::string_view text) {
    ImageStep step{.op = ImageOp::Swizzle};
    const std::array components{&step.red, &step.green, &step.blue, &step.alpha};
    const std::vector<EnumRow> rows = sourceRows();
    std::size_t count = 0;
    for (bool isLast = false; !isLast; ++count) {
        const std::size_t end = text.find(',');
        const std::string_view name = text.substr(0, end);
        isLast = end == std::string_view::npos;
        text = isLast ? std::string_view() : text.substr(end + 1);
        const EnumRow* row = findChoice(rows, name);
        if (!row)
            return refuseChoice(namesIn(rows), name, "--swizzle");
        if (count < components.size())
            *components.at(count) = static_cast<ComponentSource>(row->value);
    }
    if (count != components.size())
        return fail(
            ErrorCode::OutOfRange,
            Sentence("expected {0} components with commas between them, found {1}", components.size(), count),
            atOption("--swizzle"));
    return step;
}

/// A number within the range of the step's parameter.
template<auto Member>
Result<ImageStep> stepWith(ImageOp op, const std::string& text, const char* option) {
    ImageStep step{.op = op};
    const ParamRow& row = *findParam(imageStepTable(), keyOf<Member>());
    const Result<Value> value = parseValue(row, text);
    if (!value)
        return fail(value.error().code, value.error().message, atOption(option));
    row.write(&step, *value);
    return step;
}

Result<ImageStep> sizeOf(std::string_view text) {
    const Result<view::Size> size = parsePictureSize(text);
    if (!size)
        return fail(size.error());
    return ImageStep{.op = ImageOp::Resize, .width = size->width, .height = size->height};
}

} // namespace

void addPrepareArgument(Command& command, PrepareArgument& argument) {
    const std::vector<EnumRow> rows = sourceRows();
    command.option("--swizzle", argument.swizzle,
                   "Take red, green, blue and alpha from these components, with commas between them: " +
                       listNames(rows) +
                       ". This and the following steps are made in this order, before the mip levels.",
                   {.value = "R,G,B,A"});
    const Option& size =
        command.option("--size", argument.size, "Scale to this number of texels, as gluScaleImage does.",
                       {.value = "WIDTHxHEIGHT"});
    command.option("--scale", argument.scale, "Scale to this share of the size, rounded down: from 0 to 1.",
                   {.value = "SHARE", .excludes = &size});
    command.flag("--spread", argument.spread,
                 "Give texels with an alpha of 0 the colours of the nearest visible ones.");
    command.flag("--premultiply", argument.premultiply,
                 "Multiply colours by alpha, for blending with GL_ONE and GL_ONE_MINUS_SRC_ALPHA.");
    command.option("--normals", argument.normals,
                   "Make normals from heights, the luminance: white is so many texels high, from 0 to 8. The "
                   "picture repeats beyond its edges.",
                   {.value = "STRENGTH"});
}

Result<std::vector<ImageStep>> stepsOf(const PrepareArgument& argument) {
    std::vector<ImageStep> steps;
    const auto add = [&](const Result<ImageStep>& step) -> Result<void> {
        if (!step)
            return fail(step.error());
        steps.push_back(*step);
        return {};
    };
    Result<void> added;
    if (!argument.swizzle.empty())
        added = add(swizzleOf(argument.swizzle));
    if (added && !argument.size.empty())
        added = add(sizeOf(argument.size));
    if (added && !argument.scale.empty())
        added = add(stepWith<&ImageStep::share>(ImageOp::Resize, argument.scale, "--scale"));
    if (argument.spread)
        steps.push_back({.op = ImageOp::Spread});
    if (argument.premultiply)
        steps.push_back({.op = ImageOp::Premultiply});
    if (added && !argument.normals.empty())
        added = add(stepWith<&ImageStep::amount>(ImageOp::Normals, argument.normals, "--normals"));
    if (!added)
        return fail(added.error());
    return steps;
}

Image preparedBy(const std::vector<ImageStep>& steps, Image picture, int level) {
    for (const ImageStep& step : steps) {
        const PlannedLevel now{level, picture.width, picture.height, picture.depth};
        picture = prepared(std::move(picture), operationOf(step, now, false, nullptr));
    }
    return picture;
}

} // namespace texplorer::screenshot
