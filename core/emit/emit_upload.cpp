// What glTexImage is told of the memory that it reads: glPixelStorei and glPixelTransferf.

#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::emit {
namespace {

/// Where `values` aren't OpenGL's initial ones.
void writeComponents(CodeWriter& writer, const glm::vec4& values, float initial,
                     const std::array<std::string_view, 4>& names, const std::string& path, bool isOver) {
    for (int i = 0; i < 4; ++i) {
        if (values[i] != initial)
            writer.add(callWith("glPixelTransferf",
                                {plain(fmt::format("{}, ", names.at(static_cast<std::size_t>(i)))),
                                 isOver ? number(initial) : number(values[i], path, i)}));
    }
}

// Mesa 22.3 skips wrongly if it swaps or scales as well, and writes out of bounds if it swaps with a row
// length.
bool skipsInCall(const Upload& upload) {
    return !upload.swapBytes && upload.scale == glm::vec4(1) && upload.bias == glm::vec4(0);
}
bool swapsInCall(const Upload& upload) {
    return upload.swapBytes && upload.rowLength == 0;
}

std::string wordOf(const Value& value) {
    const auto* on = std::get_if<bool>(&value);
    return on ? std::string(booleanName(*on)) : fmt::format("{}", std::get<int>(value));
}

} // namespace

void writeTransfer(CodeWriter& writer, const ImageStep& step, const std::string& path, bool isOver) {
    writeComponents(writer, step.factor, 1, transferScales,
                    fmt::format("{}.{}", path, keyOf<&ImageStep::factor>()), isOver);
    writeComponents(writer, step.bias, 0, transferBiases,
                    fmt::format("{}.{}", path, keyOf<&ImageStep::bias>()), isOver);
}

void writeUnpacking(CodeWriter& writer, const Upload& upload, const std::string& path, bool isOver) {
    static const Upload initial{.alignment = 1}; // as init() has it
    Upload told = upload;
    told.alignment = effectiveAlignment(upload.alignment);
    told.swapBytes = swapsInCall(upload);
    if (!skipsInCall(upload))
        told.skipRows = told.skipPixels = 0;
    const Holder holder{uploadTable(), &upload, &initial, path, keyOf<&Texture::upload>(), {}};
    for (const MemberId member :
         {memberId<&Upload::alignment>, memberId<&Upload::rowLength>, memberId<&Upload::skipRows>,
          memberId<&Upload::skipPixels>, memberId<&Upload::swapBytes>}) {
        const ParamRow& row = *std::ranges::find(holder.table.params, member, &ParamRow::member);
        const Value start = row.read(&initial);
        if (!isOver && row.read(&told) == row.read(&upload))
            writer.row(holder, row);
        else if (const Value value = isOver ? start : row.read(&told);
                 writer.set(fmt::format("{}.{}", holder.state, row.key), value, start))
            writer.add(
                callWith("glPixelStorei", {plain(fmt::format("{}, {}", glNameOf(row), wordOf(value)))}));
    }
    writeComponents(writer, upload.scale, 1, transferScales,
                    fmt::format("{}.{}", path, keyOf<&Upload::scale>()), isOver);
    writeComponents(writer, upload.bias, 0, transferBiases,
                    fmt::format("{}.{}", path, keyOf<&Upload::bias>()), isOver);
}

std::string writeMemory(Emission& emission, const std::shared_ptr<const LevelCode>& level,
                        const Upload& upload, const std::string& name) {
    const bool swapsHere = upload.swapBytes && !swapsInCall(upload);
    emission.addData("GLubyte", name, level->bytes.size(),
                     Numbers{[level, swapsHere, type = upload.type] {
                                 return numbersText(withoutZerosAtEnd(
                                     swapsHere ? withSwappedBytes(level->bytes, type) : level->bytes));
                             },
                             level});
    if (swapsHere)
        emission.writer.comment("its bytes are swapped already: with a row length Mesa 22.3 can't");
    const UploadCall call = callOf(upload);
    const std::size_t first = bytesOf(call, {level->width, level->height, level->depth}, 0, 0).first;
    if (skipsInCall(upload) || first == 0)
        return name;
    emission.writer.comment("beyond what is skipped: when it swaps or scales, Mesa 22.3 can't skip");
    return fmt::format("{} + {}", name, first);
}

} // namespace texplorer::emit
