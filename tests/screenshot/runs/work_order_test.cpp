#include "app/screenshot/output/message_ids.h"
#include "app/screenshot/runs/work_order.h"
#include "texplorer/base/further.h"

#include <gtest/gtest.h>

namespace texplorer::screenshot::work_order_test {
namespace {

WorkOrder sampleOrder() {
    WorkOrder order;
    order.setup.suites = {"a.suite.json", "b\xff\x01.suite.json"}; // a file's name may be any bytes
    order.setup.renderers = {RendererKind::Shader, RendererKind::Reference};
    order.setup.only = {"wrap/*"};
    order.setup.plan = "0123";
    order.setup.report = "out";
    order.setup.shaders = "shaders";
    order.setup.pretended = {"no-s3tc"};
    order.setup.context = "egl:1";
    order.setup.threads = 3;
    order.setup.actual = "actual";
    order.setup.golden = "golden";
    order.setup.mask = "mask.png";
    order.setup.criterion = {Metric::Ssim, 0.25, 0.125, Compared::Rgb, 40};
    order.what = WorkOrder::What::Pictures;
    order.number = 17;
    order.name = "menus/\xfe.png";
    order.hasActual = false;
    order.hasGolden = false;
    order.update = true;
    return order;
}

WorkAnswer sampleAnswer() {
    WorkAnswer answer{.wrote = "golden/\xff.png",
                      .problem = Error{ErrorCode::Driver, "none", {}},
                      .driver = "llvmpipe",
                      .version = "4.5"};
    answer.record =
        suite::CaseRecord{.name = "wrap/fixed@8x8", .state = suite::State::Failed, .sentence = "…"};
    answer.record->worst = suite::WorstPixel{1, 2, {3, 4, 5, 6}, {7, 8, 9, 10}};
    return answer;
}

TEST(WorkOrder, ArrivesAsItWasSent) {
    const Result<WorkOrder> order = parseOrder(bytesOf(sampleOrder()));
    ASSERT_TRUE(order) << order.error().message;
    EXPECT_EQ(*order, sampleOrder());
    EXPECT_EQ(*parseOrder(bytesOf(WorkOrder{})), WorkOrder{});
}

TEST(WorkAnswer, ArrivesAsItWasSent) {
    const Result<WorkAnswer> answer = parseAnswer(bytesOf(sampleAnswer()));
    ASSERT_TRUE(answer) << answer.error().message;
    EXPECT_EQ(*answer, sampleAnswer());
    EXPECT_EQ(*parseAnswer(bytesOf(WorkAnswer{})), WorkAnswer{});
}

TEST(WorkAnswer, NamesTheMessageThatItsSentenceBeginsWith) {
    const Sentence lost("can't be opened: {0}", "No such file");
    const auto idSent = [](Sentence sentence) {
        WorkAnswer answer;
        answer.record = suite::CaseRecord{.name = "a", .sentence = std::move(sentence)};
        return parseAnswer(bytesOf(answer)).value().record->id;
    };
    ASSERT_TRUE(idOf(lost));
    EXPECT_EQ(idSent(lost), idOf(lost));
    EXPECT_EQ(idSent(describe({ErrorCode::NotFound, lost, inFile("a.json")})), idOf(lost));
    EXPECT_EQ(
        idSent(Sentence(furtherKey, Sentence(furtherKey, lost, Sentence("more")), Sentence("and more"))),
        idOf(lost));
    EXPECT_EQ(idSent("a text of a driver"), std::nullopt);
}

TEST(WorkOrder, OtherBytesAreRefusedWithoutACrash) {
    const std::string order = bytesOf(sampleOrder());
    const std::string answer = bytesOf(sampleAnswer());
    for (std::size_t i = 0; i < order.size(); ++i)
        EXPECT_FALSE(parseOrder(std::string_view(order).substr(0, i))) << i;
    for (std::size_t i = 0; i < answer.size(); ++i)
        EXPECT_FALSE(parseAnswer(std::string_view(answer).substr(0, i))) << i;
    EXPECT_FALSE(parseOrder(answer));
    EXPECT_FALSE(parseAnswer(order));
    for (std::size_t i = 0; i < order.size(); ++i) {
        std::string changed = order;
        changed[i] = static_cast<char>(~changed[i]);
        static_cast<void>(parseOrder(changed));
    }
}

} // namespace
} // namespace texplorer::screenshot::work_order_test
