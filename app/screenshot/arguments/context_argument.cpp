#include "app/screenshot/arguments/context_argument.h"

namespace texplorer::screenshot {
namespace {

constexpr const char* contextVariable = "TEXPLORER_CONTEXT";

} // namespace

void addContextArgument(Command& command, ContextArgument& argument) {
    argument.option = &command.option(
        "--context", argument.text,
        "Where OpenGL draws; \"texshot drivers\" lists the contexts. auto: OSMesa if texshot was built "
        "with it, else egl. osmesa: into memory. egl: the first EGL display that makes a context. "
        "egl:surfaceless: EGL's surfaceless platform. egl:N: EGL device N, from 0.",
        {.value = "CONTEXT",
         .environment = contextVariable,
         .showsDefault = true,
         .offers = {[] {
             return std::vector<std::string>{"auto", "osmesa", "egl", "egl:surfaceless"};
         }}});
}

Result<view::ContextChoice> parseContext(const ContextArgument& argument) {
    return view::ContextChoice::parse(argument.text,
                                      argument.option->isGiven() ? "--context" : contextVariable);
}

} // namespace texplorer::screenshot
