#pragma once

#include "texplorer/suite/record.h"

namespace texplorer::suite::samples {

/// A run with a case of every state, and one that was not run.
inline RunRecord sampleRun() {
    RunRecord run;
    run.program = "texshot 0.1.0";
    run.command = "texshot test s.suite.json";
    run.started = "2026-11-22T02:30:00Z";
    run.suites = {"s"};
    run.driver = "llvmpipe (LLVM 15.0.6, 256 bits)";
    run.version = "4.5 (Compatibility Profile) Mesa 22.3.6";
    run.plan = "00112233445566778899aabbccddeeff";
    run.planned = 12;
    run.seconds = 3.5;
    for (const StateRow& row : stateRows) {
        CaseRecord record{.name = std::string(row.name) + "/fixed@8x8", .state = row.state};
        record.sentence = "it is " + std::string(row.text);
        record.seconds = 0.25;
        record.renderer = "fixed";
        record.width = 8;
        record.height = 8;
        run.names.push_back(record.name);
        run.cases.push_back(record);
    }
    CaseRecord& failed = run.cases[1];
    failed.explanation = "s = 0.5\n<b>&\x01\xFF";
    failed.metric = "absolute";
    failed.score = 1.5;
    failed.tolerance = 2;
    failed.share = 0.125;
    failed.shareOver = 0.5;
    failed.pixels = 64;
    failed.over = 32;
    failed.worst = WorstPixel{3, 4, {1, 2, 3, 255}, {5, 6, 7, 128}};
    failed.golden = "golden/failed.png";
    failed.expectedPicture = "failed-expected.png";
    failed.actualPicture = "failed-actual.png";
    failed.differencePicture = "failed-difference.png";
    failed.driver = run.driver;
    failed.settings = "GALLIVM_PERF=nopt";
    failed.fingerprint = "0123";
    failed.attempt = 2;
    failed.time = 1.5;
    run.cases[5].signal = 11;
    run.names.emplace_back("late/fixed@8x8");
    return run;
}

} // namespace texplorer::suite::samples
