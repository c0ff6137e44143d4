// Part of programs that run with LeakSanitizer. Libraries stay loaded, so that leaks are reported under the
// name of their library, which leaks.txt lists, and not as memory of an unknown module.

extern "C" __attribute__((visibility("default"))) int dlclose(void* /*library*/) {
    return 0;
}
