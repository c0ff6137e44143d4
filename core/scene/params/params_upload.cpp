#include "texplorer/base/translatable.h"
#include "texplorer/scene/params/param_builder.h"

namespace texplorer {
namespace {

using build::param;

constexpr std::array uploadRows{
    param<&Upload::custom>(
        "custom", N_("Upload"), N_("Custom upload"), "",
        N_("On: the call below reads the program's memory, whether it fits or not. Off: it "
           "fits.")),
    param<&Upload::memory>("memory", N_("Upload"), N_("Memory rows"), "",
                           N_("What the program's memory holds of the image: the rows of its file, or a "
                              "layout of its own.")),
    param<&Upload::memoryFormat>("memoryFormat", N_("Upload"), N_("Memory format"), "",
                                 N_("The components of a pixel in the program's memory, in their order.")),
    param<&Upload::memoryType>("memoryType", N_("Upload"), N_("Memory type"), "",
                               N_("The type of the numbers in the program's memory.")),
    param<&Upload::memoryAlignment>(
        "memoryAlignment", N_("Upload"), N_("Memory alignment"), "",
        N_("Rows in the program's memory begin at multiples of so many bytes: 1, 2, 4 or 8."),
        {1, 8, 0.02F, N_("bytes")}),
    param<&Upload::format>(
        "format", N_("Upload"), N_("Format"),
        "glTexImage{n}D({image}, level, internalFormat, {extents}, border, {}, type, pixels)",
        N_("The components that glTexImage is told to find in a pixel, in this order.")),
    param<&Upload::type>(
        "type", N_("Upload"), N_("Type"),
        "glTexImage{n}D({image}, level, internalFormat, {extents}, border, format, {}, pixels)",
        N_("The type of number that glTexImage is told to find.")),
    param<&Upload::alignment>(
        "alignment", N_("Upload"), N_("Alignment"), "glPixelStorei(GL_UNPACK_ALIGNMENT, {})",
        N_("OpenGL expects each row at a multiple of so many bytes: 1, 2, 4 or 8. Initially 4, which shears "
           "tight rows of RGB."),
        {1, 8, 0.02F, N_("bytes")}),
    param<&Upload::rowLength>(
        "rowLength", N_("Upload"), N_("Row length"), "glPixelStorei(GL_UNPACK_ROW_LENGTH, {})",
        N_("The pixels of a row in memory, of which the image may be a part. 0: the image's width."),
        {0, 4096, 0.05F, N_("pixels")}),
    param<&Upload::skipRows>(
        "skipRows", N_("Upload"), N_("Skip rows"), "glPixelStorei(GL_UNPACK_SKIP_ROWS, {})",
        N_("The rows in memory before the image's first one."), {0, 4096, 0.05F, N_("rows")}),
    param<&Upload::skipPixels>(
        "skipPixels", N_("Upload"), N_("Skip pixels"), "glPixelStorei(GL_UNPACK_SKIP_PIXELS, {})",
        N_("The pixels in memory before the first one of each row."), {0, 4096, 0.05F, N_("pixels")}),
    param<&Upload::swapBytes>("swapBytes", N_("Upload"), N_("Swap bytes"),
                              "glPixelStorei(GL_UNPACK_SWAP_BYTES, {})",
                              N_("The bytes of each number in reverse order: of files from processors with "
                                 "another byte order.")),
    param<&Upload::scale>(
        "scale", N_("Upload"), N_("Scale"), "",
        N_("The factors of red, green, blue and alpha (glPixelTransferf, GL_RED_SCALE and so "
           "on)."),
        {-16, 16, 0.01F, {}}),
    param<&Upload::bias>("bias", N_("Upload"), N_("Bias"), "",
                         N_("Added to red, green, blue and alpha after the factors (GL_RED_BIAS and so on)."),
                         {-16, 16, 0.01F, {}}),
};
static_assert(uploadRows.size() == 14 && uploadRows.size() == build::memberCount<Upload>());

} // namespace

const StructTable& uploadTable() {
    static const StructTable table{N_("Upload"), uploadRows, {}};
    return table;
}

} // namespace texplorer
