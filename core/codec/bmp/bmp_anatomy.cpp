#include "texplorer/base/byte_reader.h"
#include "texplorer/base/sentence.h"
#include "texplorer/codec/bmp/bmp.h"
#include "texplorer/codec/bmp/bmp_fields.h"
#include "texplorer/codec/bmp/bmp_header.h"
#include "texplorer/codec/bmp/bmp_rle.h"

#include <algorithm>

namespace texplorer {

namespace {

using bmp::Header;

class Dissection {
public:
    explicit Dissection(ByteView file)
        : file_(file)
        , header_(bmp::parseHeader(file)) {
        anatomy_.format = "BMP";
    }

    Anatomy run() {
        section("File header", 0, bmp::fileHeaderSize, N_("the beginning of every BMP"));
        fields(bmp::fileHeaderFields(), bmp::fileHeaderSize);
        if (stopped())
            return std::move(anatomy_);
        const std::size_t infoSize = bmp::headerKind(header_.headerSize) == bmp::HeaderKind::Unknown
                                         ? 4
                                         : std::size_t{header_.headerSize};
        section(std::string(bmp::headerName(header_.headerSize)), bmp::fileHeaderSize, infoSize,
                N_("size and pixel format"));
        fields(bmp::infoHeaderFields(header_.headerSize), bmp::fileHeaderSize + infoSize);
        if (infoSize == 4)
            stop(Sentence(
                "an info header has 12, 16 to 64, 108 or 124 bytes, this one has {0}: the rest is unknown",
                header_.headerSize));
        if (stopped())
            return std::move(anatomy_);
        masks();
        palette();
        gap();
        pixels();
        profile();
        tail();
        return std::move(anatomy_);
    }

private:
    [[nodiscard]] bool stopped() const { return !anatomy_.damage.empty(); }

    void stop(Sentence damage) {
        if (!stopped())
            anatomy_.damage = std::move(damage);
    }

    void add(Field field) {
        if (field.offset + field.size > file_.size())
            stop(Sentence("{0} needs {1} from offset {2}, the file has {3}", field.name,
                          Sentence::plural("{0} byte", "{0} bytes", field.size), field.offset, file_.size()));
        anatomy_.fields.push_back(std::move(field));
    }

    void section(Sentence name, std::uint64_t offset, std::uint64_t size, Sentence meaning) {
        // Its fields say exactly where the file ends.
        anatomy_.fields.push_back({offset,
                                   size,
                                   std::move(name),
                                   Sentence::plural("{0} byte", "{0} bytes", size),
                                   std::move(meaning),
                                   {},
                                   0});
    }

    void fields(std::span<const bmp::FieldRow> rows, std::uint64_t end) {
        for (const bmp::FieldRow& row : rows) {
            if (row.offset + row.size > end || stopped())
                return;
            const bmp::FieldContext context{file_, header_};
            const bool there = row.offset + row.size <= file_.size();
            add({row.offset, row.size, std::string(row.name), there ? bmp::valueOf(row, context) : Sentence(),
                 std::string(row.meaning), there ? bmp::wrongOf(row, context) : Sentence(), 1});
        }
    }

    // Those within longer headers are among their fields.
    void masks() {
        if (header_.masksPos == 0 || header_.headerSize != 40 || stopped())
            return;
        const std::uint64_t size = header_.palettePos - header_.masksPos;
        section("Masks", header_.masksPos, size, N_("which bits of a pixel are red, green, blue and alpha"));
        fields(bmp::maskFields(), header_.palettePos);
    }

    void palette() {
        if (stopped() || header_.paletteEntries == 0) {
            if (!stopped() && header_.bitsPerPixel >= 1 && header_.bitsPerPixel <= 8)
                anatomy_.fields.push_back(
                    {header_.palettePos, 0, N_("Palette"), N_("no entries"), "",
                     Sentence("{0} a pixel need one, the pixels begin at offset {1}",
                              Sentence::plural("{0} bit", "{0} bits", header_.bitsPerPixel), header_.dataPos),
                     0});
            return;
        }
        const std::size_t entries = header_.paletteEntries;
        const std::size_t size = entries * header_.paletteEntryBytes;
        const std::size_t max = std::size_t{1} << std::min(header_.bitsPerPixel, 8U);
        Sentence wrong;
        if (header_.bitsPerPixel <= 8 && entries < max && header_.colorsUsed != entries)
            wrong = Sentence("expected {0} entries, but there is space for {1}",
                             header_.colorsUsed == 0 ? max : header_.colorsUsed, entries);
        anatomy_.fields.push_back({header_.palettePos, size, N_("Palette"),
                                   Sentence::plural("{0} entry", "{0} entries", entries),
                                   header_.paletteEntryBytes == 3 ? N_("blue, green, red")
                                                                  : N_("blue, green, red, a reserved byte"),
                                   std::move(wrong), 0});
        // A palette of 256 says little more than its beginning and its end do.
        constexpr std::size_t shownInFull = 16;
        if (entries <= shownInFull) {
            paletteEntries(0, entries);
            return;
        }
        constexpr std::size_t shown = 8;
        paletteEntries(0, shown);
        const std::size_t left = entries - shown - 1;
        add({entryOffset(shown), left * header_.paletteEntryBytes,
             Sentence("entries {0} to {1}", shown, entries - 2), Sentence("{0} more", left), "", "", 1});
        paletteEntries(entries - 1, entries);
    }

    [[nodiscard]] std::uint64_t entryOffset(std::size_t index) const {
        return header_.palettePos + index * header_.paletteEntryBytes;
    }

    void paletteEntries(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const ByteView entry = partOf(file_, entryOffset(i), header_.paletteEntryBytes);
            add({entryOffset(i), entry.size(), Sentence("entry {0}", i),
                 bmp::hexColor(entry[2], entry[1], entry[0]), "", "", 1});
        }
    }

    void gap() {
        const std::uint64_t begin = header_.palettePos + header_.paletteEntries * header_.paletteEntryBytes;
        if (stopped() || header_.dataPos <= begin)
            return;
        add({begin, header_.dataPos - begin, N_("Gap"),
             Sentence::plural("{0} byte", "{0} bytes", header_.dataPos - begin),
             N_("not used; the pixels begin after it"), "", 0});
    }

    void pixels() {
        if (stopped())
            return;
        if (header_.dataPos < header_.palettePos)
            return stop(Sentence("the pixels begin at offset {0}, within the headers, which end at {1}",
                                 header_.dataPos, header_.palettePos));
        if (header_.dataPos > file_.size())
            return stop(Sentence("the pixels begin at offset {0}, the file has {1}", header_.dataPos,
                                 Sentence::plural("{0} byte", "{0} bytes", file_.size())));
        if (header_.width < 1 || header_.height < 1)
            return stop(Sentence("a picture has at least 1 × 1 pixels, this one has {0} × {1}", header_.width,
                                 header_.height));
        if (header_.runLengthCoded())
            return runLengthCodes();
        const bool raw = header_.compression == 0 || header_.masksPos != 0;
        if (!raw) {
            const std::uint64_t there = file_.size() - header_.dataPos;
            const std::uint64_t size = header_.imageSize == 0 ? there : header_.imageSize;
            return pixelData(size, bmp::compressionName(header_.compression, header_.headerSize),
                             N_("an embedded file or another coding; not read"));
        }
        if (header_.bitsPerPixel < 1)
            return stop(N_("a pixel has at least one bit, this file has 0"));
        const char* order = header_.topDown ? N_("top row first") : N_("bottom row first");
        pixelData(header_.pixelBytes(),
                  Sentence("{0} rows of {1}", header_.height,
                           Sentence::plural("{0} byte", "{0} bytes", header_.rowBytes())),
                  Sentence("{0}, each padded to {1} bytes", order, header_.rowStride()));
    }

    void pixelData(std::uint64_t size, Sentence value, Sentence meaning, Sentence wrong = {}) {
        pixelEnd_ = header_.dataPos + size;
        add({header_.dataPos, size, N_("Pixel data"), std::move(value), std::move(meaning), std::move(wrong),
             0});
    }

    void runLengthCodes() {
        struct Nowhere : bmp::RleRows {
            void row(int /*y*/, ByteView /*indices*/) override {}
        } nowhere;
        constexpr std::int64_t max = DecodeLimits{}.maxExtent; // following codes costs what painting does
        if (header_.width > max || header_.height > max)
            return stop(Sentence(
                "run-length codes are decoded up to {0} pixels along each axis, this picture has {1} × {2}",
                max, header_.width, header_.height));
        const bmp::RleReport report =
            bmp::decodeRle(partOf(file_, header_.dataPos, file_.size()),
                           header_.compression == static_cast<std::uint32_t>(bmp::Compression::Rle8) ? 8 : 4,
                           static_cast<int>(header_.width), static_cast<int>(header_.height), nowhere);
        Sentence wrong;
        if (report.clipped > 0)
            wrong = Sentence("{0} continue beyond the end of a row",
                             Sentence::plural("{0} code", "{0} codes", report.clipped));
        pixelData(report.consumed,
                  Sentence("{0}: {1}, {2}, {3}",
                           bmp::compressionName(header_.compression, header_.headerSize),
                           Sentence::plural("{0} run", "{0} runs", report.runs),
                           Sentence::plural("{0} literal", "{0} literals", report.literals),
                           Sentence::plural("{0} delta", "{0} deltas", report.deltas)),
                  Sentence("they set {0} of {1} pixels", report.painted, header_.width * header_.height),
                  std::move(wrong));
        if (!report.ended)
            stop(Sentence(
                "the run-length codes end at offset {0} within row {1} of {2}, without an end-of-picture code",
                pixelEnd_, report.row + 1, header_.height));
    }

    void profile() {
        if (stopped() || bmp::headerKind(header_.headerSize) != bmp::HeaderKind::V5)
            return;
        ByteReader reader(file_.subspan(bmp::fileHeaderSize + 112));
        const std::uint64_t offset = bmp::fileHeaderSize + std::uint64_t{reader.u32()};
        const std::uint64_t size = reader.u32();
        if (size == 0 || offset == bmp::fileHeaderSize)
            return;
        add({offset, size, N_("Colour profile"), Sentence::plural("{0} byte", "{0} bytes", size),
             N_("ICC profile or its file name; not used"),
             offset < pixelEnd_ ? Sentence("begins before the pixels end, at offset {0}", pixelEnd_)
                                : Sentence(),
             0});
        pixelEnd_ = std::max(pixelEnd_, offset + size);
    }

    void tail() {
        // Where the last row's padding is there, it is no tail.
        const std::uint64_t end = std::min<std::uint64_t>(
            (pixelEnd_ - header_.dataPos + 3) / 4 * 4 + header_.dataPos, file_.size());
        if (stopped() || end >= file_.size())
            return;
        add({end, file_.size() - end, N_("Tail"),
             Sentence::plural("{0} byte", "{0} bytes", file_.size() - end), N_("not used"), "", 0});
    }

    ByteView file_;
    Header header_;
    Anatomy anatomy_;
    std::uint64_t pixelEnd_ = 0;
};

} // namespace

Anatomy dissectBmp(ByteView file) {
    return Dissection(file).run();
}

} // namespace texplorer
