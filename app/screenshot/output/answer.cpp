#include "app/screenshot/output/answer.h"

#include "app/command_line/standard_streams.h"
#include "app/screenshot/output/interrupts.h"
#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/messages.h"
#include "texplorer/base/bytes.h"
#include "texplorer/text/printable.h"

namespace texplorer::screenshot {
namespace {

bool printedSomething = false; // by the thread that does what the call asks for

} // namespace

ExitCode complain(const Error& error, ExitCode code) {
    say(error);
    noteError(error);
    return code;
}

Result<void> print(std::string_view text) {
    printedSomething = printedSomething || !text.empty();
    outputBegins();
    return writeStandardOutput(viewBytes(printable(text, LineBreaks::Keep)));
}

bool hasPrinted() {
    return printedSomething;
}

} // namespace texplorer::screenshot
