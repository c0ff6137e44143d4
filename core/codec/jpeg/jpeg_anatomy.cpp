#include "texplorer/base/translatable.h"
#include "texplorer/codec/jpeg/jpeg.h"
#include "texplorer/codec/jpeg/jpeg_markers.h"

#include <algorithm>
#include <string>
#include <utility>

namespace texplorer {

namespace {

constexpr std::size_t maxSegments = 200; // of at most sixteen fields each
constexpr std::size_t maxComponents = 4;

const char* meaningOf(const JpegSegment& segment) {
    switch (segment.marker) {
    case jpegSoi:
        return N_("start of image");
    case jpegEoi:
        return N_("end of image");
    case jpegSos:
        return N_("start of scan");
    case jpegDqt:
        return N_("quantization tables");
    case jpegDht:
        return N_("Huffman tables");
    case jpegDri:
        return N_("restart interval");
    case jpegCom:
        return N_("comment");
    default:
        return segment.isFrame() ? N_("start of frame") : "";
    }
}

void describeFrame(const JpegSegment& segment, std::vector<Field>& fields) {
    const JpegFrame frame = readJpegFrame(segment);
    const std::size_t at = segment.offset + 4;
    const auto add = [&](std::size_t offset, std::size_t size, Sentence name, Sentence value,
                         Sentence meaning, Sentence wrong = {}) {
        if (offset + size <= segment.payload.size())
            fields.push_back({at + offset, size, std::move(name), std::move(value), std::move(meaning),
                              std::move(wrong), 1});
    };
    add(0, 1, N_("precision"), std::to_string(frame.precision), N_("bits a sample"),
        frame.precision == 8 ? "" : N_("only 8 are read"));
    add(1, 2, N_("height"), std::to_string(frame.height), N_("pixels"),
        frame.height > 0 ? "" : N_("expected 1 or more"));
    add(3, 2, N_("width"), std::to_string(frame.width), N_("pixels"),
        frame.width > 0 ? "" : N_("expected 1 or more"));
    add(5, 1, N_("components"),
        std::to_string(segment.payload.size() > 5 ? std::to_integer<int>(segment.payload[5]) : 0),
        N_("1 grey, 3 colour, 4 CMYK"));
    for (std::size_t i = 0; i < std::min(frame.components.size(), maxComponents); ++i) {
        const JpegComponent& each = frame.components[i];
        const bool good =
            each.horizontal >= 1 && each.horizontal <= 4 && each.vertical >= 1 && each.vertical <= 4;
        add(6 + 3 * i, 3, Sentence("component {0}", each.id),
            Sentence("{0} × {1}", each.horizontal, each.vertical),
            Sentence("sampling; quantization table {0}", each.quantization),
            good ? "" : N_("expected factors from 1 to 4"));
    }
}

void describeSegment(const JpegSegment& segment, std::vector<Field>& fields) {
    fields.push_back(
        {segment.offset,
         segment.size(),
         jpegMarkerName(segment.marker),
         {},
         meaningOf(segment),
         segment.strayBytes == 0 ? Sentence() : Sentence("{0} stray bytes before it", segment.strayBytes),
         0});
    if (segment.hasLength())
        fields.push_back({segment.offset + 2,
                          2,
                          N_("length"),
                          std::to_string(segment.length + 2),
                          N_("bytes, including these two"),
                          {},
                          1});
    if (segment.isFrame())
        describeFrame(segment, fields);
    else if (const int orientation = segment.marker == jpegApp1 ? exifOrientation(segment.payload) : 0)
        fields.push_back({segment.offset + 4,
                          segment.length,
                          N_("Exif"),
                          Sentence("orientation {0}", orientation),
                          N_("1 is upright"),
                          {},
                          1});
    if (segment.marker == jpegSos)
        fields.push_back({segment.offset + segment.size(),
                          segment.codedBytes,
                          N_("coded data"),
                          {},
                          N_("of this scan"),
                          segment.codedBytes > 0 ? "" : N_("there is none"),
                          1});
}

} // namespace

Anatomy dissectJpeg(ByteView file) {
    Anatomy anatomy{"JPEG", {}, {}};
    JpegSegments segments(file);
    bool ended = false;
    for (std::size_t index = 0; const std::optional<JpegSegment> segment = segments.next(); ++index) {
        if (index == maxSegments)
            anatomy.fields.push_back({segment->offset, 0, N_("More segments"), {}, {}, {}, 0});
        if (index < maxSegments) {
            describeSegment(*segment, anatomy.fields);
        } else {
            Field& more = anatomy.fields.back();
            more.size = segment->offset + segment->size() - more.offset;
            more.value = std::to_string(index + 1 - maxSegments);
            more.meaning = Sentence("only the first {0} are listed", maxSegments);
        }
        if (!segment->complete()) {
            anatomy.damage =
                Sentence("{0} at offset {1} needs {2} bytes, the file has {3}",
                         jpegMarkerName(segment->marker), segment->offset, segment->size(), file.size());
            return anatomy;
        }
        ended = segment->marker == jpegEoi;
    }
    if (!ended)
        anatomy.damage = Sentence("the file ends at offset {0} without an EOI", file.size());
    else if (segments.offset() < file.size())
        anatomy.fields.push_back({segments.offset(),
                                  file.size() - segments.offset(),
                                  N_("Trailing data"),
                                  {},
                                  N_("after the end"),
                                  N_("not read"),
                                  0});
    return anatomy;
}

} // namespace texplorer
