// Where glTexImage is told something else of a program's memory than what it holds.

#include "texplorer/diagnosis/diagnosis_rules.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace texplorer::diagnosis {
namespace {

/// A custom upload of a texture that is shown.
struct Read {
    const Upload& upload;
    const PlannedUpload& plan;
    bool isDepth;
    std::string path; ///< "textures[0].upload."

    [[nodiscard]] const MemoryLayout& memory() const { return plan.memory; }
    [[nodiscard]] UploadCall call() const { return callOf(upload); }
    [[nodiscard]] std::size_t rowBytes() const {
        return rowStride({memory().pixels, {.alignment = memory().alignment}}, plan.extent.width);
    }
    [[nodiscard]] std::size_t rows() const {
        return static_cast<std::size_t>(plan.extent.height) * static_cast<std::size_t>(plan.extent.depth);
    }
    /// Depth textures take depths alone, and no others do: the memory may have to hold something else.
    [[nodiscard]] bool holdsOther() const {
        return isDepth ? componentsOf(memory().pixels.format).size() != 1
                       : memory().pixels.format == TransferFormat::DepthComponent;
    }
    [[nodiscard]] Upload fitting() const {
        MemoryLayout held = memory();
        Upload from = upload;
        if (holdsOther()) {
            held.pixels.format = isDepth ? TransferFormat::DepthComponent : TransferFormat::Rgba;
            from.memory = MemoryRows::Layout;
            from.memoryFormat = held.pixels.format;
            from.memoryType = held.pixels.type;
            from.memoryAlignment = held.alignment;
        }
        return fittingUpload(from, held, plan.extent.width, isDepth);
    }
};

template<class Visit> ///< visit(read), of those that OpenGL refuses or not
void forEachUpload(const Case& about, bool refused, Visit visit) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const TextureFacts& facts = about.textures[i];
        const std::optional<PlannedUpload>& plan = facts.targets.front().plan.upload;
        const Texture& texture = about.scene.textures[i];
        if (facts.image && facts.shown && plan && plan->refusal.empty() != refused)
            visit(Read{texture.upload, *plan, isDepth(texture.internalFormat),
                       elementOf<&Scene::textures>(i) + "." + keyOf<&Texture::upload>() + "."});
    }
}

/// What of `to` is set differently.
Fix fixOf(const Read& read, const Upload& to, Sentence label) {
    Fix fix{std::move(label), {}};
    for (const ParamRow& row : uploadTable().params) {
        const Value value = row.read(&to);
        if (value != row.read(&read.upload))
            fix.assignments.push_back({read.path + std::string(row.key), formatValue(row, value)});
    }
    return fix;
}

Sentence setting(const Key& key, int value) {
    return Sentence("Set {0} to {1}", ProperName{glNameOf(*findParam(uploadTable(), key()))}, value);
}

/// The layout of a call that fits.
Fix layoutFix(const Read& read) {
    const Upload fitting = read.fitting();
    Upload to = read.upload;
    to.memory = fitting.memory;
    to.memoryFormat = fitting.memoryFormat;
    to.memoryType = fitting.memoryType;
    to.format = fitting.format;
    to.type = fitting.type;
    to.swapBytes = false;
    const bool sameFormat = to.format == read.upload.format;
    const bool sameType = to.type == read.upload.type;
    return fixOf(read, to,
                 read.holdsOther()        ? Sentence("Hold {0} in memory", named(to.memoryFormat))
                 : sameFormat && sameType ? N_("Don't swap bytes")
                 : sameType               ? Sentence("Set {0}", named(to.format))
                 : sameFormat             ? Sentence("Set {0}", named(to.type))
                              : Sentence("Set {0}", Sentence("{0}, {1}", named(to.format), named(to.type))));
}

void refused(const Case& about, Report& report) {
    forEachUpload(about, true, [&](const Read& read) {
        if (!checkLayout(read.memory().pixels)) {
            Upload to = read.upload;
            to.memoryType = TransferType::UnsignedByte;
            report.add(read.path + keyOf<&Upload::memoryType>(), read.plan.refusal,
                       fixOf(read, to, Sentence("Set {0}", named(to.memoryType))));
            return;
        }
        const bool isOfType = !checkLayout(read.call().layout);
        report.add(read.path + (isOfType ? keyOf<&Upload::type>() : keyOf<&Upload::format>()),
                   read.plan.refusal, layoutFix(read));
    });
}

/// OpenGL 2.1, section 3.6.1.
void alignment(const Case& about, Report& report) {
    forEachUpload(about, false, [&](const Read& read) {
        const auto check = [&](const Key& key, int value, const Sentence& sentence, int better) {
            if (effectiveAlignment(value) != value)
                report.add(read.path + key(), sentence,
                           Fix{key == keyOf<&Upload::alignment>
                                   ? setting(key, better)
                                   : Sentence("Begin rows at multiples of {0} bytes", better),
                               {{read.path + key(), std::to_string(better)}}});
        };
        check(
            keyOf<&Upload::alignment>, read.upload.alignment,
            Sentence("glPixelStorei takes an alignment of 1, 2, 4 or 8: {0} is GL_INVALID_VALUE, and 4 stays",
                     read.upload.alignment),
            read.fitting().alignment);
        if (read.upload.memory == MemoryRows::Layout)
            check(keyOf<&Upload::memoryAlignment>, read.upload.memoryAlignment,
                  Sentence("rows begin at multiples of 1, 2, 4 or 8 bytes, not of {0}: 4 is used",
                           read.upload.memoryAlignment),
                  read.memory().alignment);
    });
}

/// Whether pixels are read as the memory has them: two layouts may have the same bytes, as GL_UNSIGNED_BYTE
/// and GL_UNSIGNED_INT_8_8_8_8_REV.
bool readsPixels(const Read& read) {
    const PixelLayout& held = read.memory().pixels;
    const PixelLayout& told = read.call().layout;
    if (bytesPerPixel(held) != bytesPerPixel(told))
        return false;
    const bool swaps = read.upload.swapBytes && factsOf(told.type).bytes > 1;
    if (read.isDepth || (held == told && !swaps))
        return held.type == told.type && !swaps;
    Image image = Image::uninitialised(PixelFormat::Rgba8, 4, 1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = static_cast<std::byte>(37 * i + 11); // all differ
    const PixelExtent extent{image.width};
    const Bytes memory = writePixels(image, held, 1);
    return readPixels(memory, {held}, extent) ==
           readPixels(memory, {told, {.swapBytes = read.upload.swapBytes}}, extent);
}

/// Section 3.6.4, table 3.6.
Sentence formatSentence(TransferFormat held, TransferFormat told) {
    const std::string_view has = componentsOf(held);
    const std::string_view takes = componentsOf(told);
    if (has.size() != takes.size())
        return Sentence("the memory has {0}; {1} has another number of components, and most pixels are read "
                        "from the wrong bytes",
                        named(held), named(told));
    if (has.starts_with("bgr"))
        return Sentence("the bytes are in blue-first order, {0}: as {1}, red and blue are exchanged",
                        named(held), named(told));
    return Sentence("the memory has {0}, but glTexImage is told {1}: components are exchanged", named(held),
                    named(told));
}

void pixels(const Case& about, Report& report) {
    forEachUpload(about, false, [&](const Read& read) {
        if (readsPixels(read))
            return;
        const PixelLayout& held = read.memory().pixels;
        const PixelLayout told = read.call().layout;
        const bool takesDepth = read.isDepth && componentsOf(held.format).size() == 1;
        if (held.format != told.format && !takesDepth)
            report.add(read.path + keyOf<&Upload::format>(), formatSentence(held.format, told.format),
                       layoutFix(read));
        if (held.type != told.type)
            report.add(read.path + keyOf<&Upload::type>(),
                       Sentence("the memory has {0}, but glTexImage is told {1}: the numbers are others",
                                named(held.type), named(told.type)),
                       layoutFix(read));
        if (read.upload.swapBytes && factsOf(told.type).bytes > 1)
            report.add(read.path + keyOf<&Upload::swapBytes>(),
                       N_("the bytes of numbers are in this processor's order: swapped, they are others"),
                       layoutFix(read));
    });
}

/// The image's own rows, if they fit with this alignment; else the alignment that fits with this row length,
/// or with that of the image.
Upload withFittingRows(const Read& read) {
    const Upload& given = read.upload;
    Upload to = given;
    for (const auto& [length, alignments] :
         {std::pair{0, std::vector{given.alignment}}, std::pair{given.rowLength, std::vector{4, 1, 2, 8}},
          std::pair{0, std::vector{4, 1, 2, 8}}}) {
        for (const int each : alignments) {
            to.rowLength = length;
            to.alignment = each;
            if (rowStride(callOf(to), read.plan.extent.width) == read.rowBytes())
                return to;
        }
    }
    return to;
}

/// Equation 3.13.
void rows(const Case& about, Report& report) {
    forEachUpload(about, false, [&](const Read& read) {
        const UploadCall call = read.call();
        const std::size_t expected = rowStride(call, read.plan.extent.width);
        const bool samePixels = bytesPerPixel(call.layout) == bytesPerPixel(read.memory().pixels);
        if (!samePixels || expected == read.rowBytes() || read.rows() == 1)
            return;
        const Upload to = withFittingRows(read);
        std::vector<Sentence> changes;
        if (to.rowLength != read.upload.rowLength)
            changes.push_back(setting(keyOf<&Upload::rowLength>, to.rowLength));
        if (to.alignment != read.upload.alignment)
            changes.push_back(setting(keyOf<&Upload::alignment>, to.alignment));
        const bool isLength = to.rowLength != read.upload.rowLength;
        report.add(read.path + (isLength ? keyOf<&Upload::rowLength>() : keyOf<&Upload::alignment>()),
                   Sentence("rows are {0} bytes, OpenGL expects {1}: the picture is slanted", read.rowBytes(),
                            expected),
                   fixOf(read, to, Sentence::joined("{0}, {1}", changes)));
    });
}

void beyondEnd(const Case& about, Report& report) {
    forEachUpload(about, false, [&](const Read& read) {
        const std::uint64_t reads = bytesRead(read.call(), read.plan.extent);
        const std::uint64_t held = std::uint64_t{read.rowBytes()} * read.rows();
        if (reads <= held)
            return;
        const Upload& upload = read.upload;
        const bool samePixels = bytesPerPixel(read.call().layout) == bytesPerPixel(read.memory().pixels);
        const Key key = upload.skipRows > 0     ? keyOf<&Upload::skipRows>
                        : upload.skipPixels > 0 ? keyOf<&Upload::skipPixels>
                        : upload.rowLength > 0  ? keyOf<&Upload::rowLength>
                        : samePixels            ? keyOf<&Upload::alignment>
                                                : keyOf<&Upload::format>;
        Upload to = read.fitting();
        to.scale = upload.scale;
        to.bias = upload.bias;
        report.add(read.path + key(),
                   Sentence("the call reads {0} bytes, the memory has {1}: what is beyond is undefined in "
                            "OpenGL, and 0 here",
                            reads, held),
                   fixOf(read, to, N_("Fit the call to the memory")));
    });
}

/// Section 3.6.4: what fixed-point formats store is limited.
void limited(const Case& about, Report& report) {
    for (std::size_t i = 0; i < about.textures.size(); ++i) {
        const TextureFacts& facts = about.textures[i];
        const Texture& texture = about.scene.textures[i];
        const Upload& upload = texture.upload;
        const std::optional<PlannedUpload>& plan = facts.targets.front().plan.upload;
        if (!facts.image || !facts.shown || !plan || !plan->refusal.empty() ||
            isFloat(texture.internalFormat) || isDepth(texture.internalFormat))
            continue;
        const glm::vec4 white = upload.scale + upload.bias;
        const glm::vec4 least = glm::min(upload.bias, white);
        const glm::vec4 most = glm::max(upload.bias, white);
        const bool isAbove = glm::any(glm::greaterThan(most, glm::vec4(1)));
        if (!isAbove && !glm::any(glm::lessThan(least, glm::vec4(0))))
            continue;
        const std::string path = elementOf<&Scene::textures>(i) + ".";
        std::vector<Fix> fixes;
        const InternalFormat floats = floatFormat(baseFormat(texture.internalFormat));
        if (about.driver.floatTextures)
            fixes.push_back({Sentence("Make it {0}", named(floats)),
                             {{path + keyOf<&Texture::internalFormat>(), nameOf(floats)}}});
        const bool byScale = upload.scale != glm::vec4(1);
        report.add(path + keyOf<&Texture::upload>() + "." +
                       (byScale ? keyOf<&Upload::scale>() : keyOf<&Upload::bias>()),
                   isAbove ? Sentence("some components may become larger than 1, and {0} stores them as 1",
                                      named(texture.internalFormat))
                           : Sentence("some components may become less than 0, and {0} stores them as 0",
                                      named(texture.internalFormat)),
                   std::move(fixes));
    }
}

/// Table 2.9, and table 2.10 of OpenGL 4.2's section 2.3.5.
void signedNumbers(const Case& about, Report& report) {
    forEachUpload(about, false, [&](const Read& read) {
        const TransferType type = read.upload.type;
        if (type == TransferType::Byte || type == TransferType::Short || type == TransferType::Int)
            report.add(
                read.path + keyOf<&Upload::type>(),
                Sentence("{0}: OpenGL 2.1 makes (2c + 1) / {1} of a number c, drivers since OpenGL 4.2 "
                         "c / {2}: colours differ by up to 1 of 255",
                         named(type),
                         ProperName{type == TransferType::Byte    ? "255"
                                    : type == TransferType::Short ? "65535"
                                                                  : "(2^32 - 1)"},
                         ProperName{type == TransferType::Byte    ? "127"
                                    : type == TransferType::Short ? "32767"
                                                                  : "(2^31 - 1)"}));
    });
}

constexpr std::array uploadRuleRows{
    Rule{"upload-refused", Severity::Error, refused, true},
    Rule{"upload-alignment", Severity::Warning, alignment},
    Rule{"upload-pixels", Severity::Warning, pixels},
    Rule{"upload-rows", Severity::Warning, rows},
    Rule{"upload-end", Severity::Warning, beyondEnd},
    Rule{"upload-limited", Severity::Note, limited},
    Rule{"upload-signed", Severity::Note, signedNumbers},
};

} // namespace

std::span<const Rule> uploadRules() {
    return uploadRuleRows;
}

} // namespace texplorer::diagnosis
