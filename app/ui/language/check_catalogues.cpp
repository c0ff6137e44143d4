// Checks the catalogues when Texplorer is built: check_catalogues FILE...

#include "app/ui/language/po_file.h"

#include <cstdio>
#include <fstream>
#include <sstream>

int main(int argc, char** argv) {
    int status = 0;
    for (int i = 1; i < argc; ++i) {
        const std::ifstream file(argv[i]);
        std::ostringstream text;
        text << file.rdbuf();
        const auto entries = texplorer::ui::readPoFile(text.str(), argv[i]);
        if (file && entries)
            continue;
        const std::string words = entries ? "expected a file that can be read" : entries.error().message;
        const std::string where = entries ? argv[i] : entries.error().where.text();
        std::fprintf(stderr, "%s: error: %s\n", where.c_str(), words.c_str());
        status = 1;
    }
    return status;
}
