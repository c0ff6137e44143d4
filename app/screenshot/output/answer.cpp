#include "app/screenshot/output/answer.h"

#include "app/command_line/standard_streams.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/messages.h"
#include "texplorer/base/bytes.h"
#include "texplorer/text/printable.h"

namespace texplorer::screenshot {
namespace {

bool isDocumentExpected = false;

} // namespace

ExitCode complain(const Error& error, ExitCode code) {
    say(error);
    noteError(error);
    return code;
}

Result<void> print(std::string_view text) {
    return printPieces([text](const Print& piece) { return piece(text); });
}

Result<void> printPieces(const std::function<Result<void>(const Print&)>& make) {
    const Printing now;
    return make([](std::string_view piece) {
        return writeStandardOutput(viewBytes(printable(piece, LineBreaks::Keep)));
    });
}

void expectDocument() {
    isDocumentExpected = true;
}

void printProblems() {
    if (!isDocumentExpected || hasPrinted())
        return;
    if (const std::string error = errorText(); !error.empty())
        static_cast<void>(print(error));
}

} // namespace texplorer::screenshot
