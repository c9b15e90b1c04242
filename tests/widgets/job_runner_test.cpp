#include "job_runner_test.h"

#include "core/base/error.h"
#include "widgets/workspace/job_runner.h"

#include <QSignalSpy>
#include <QThread>

#include <atomic>

using namespace mirrorball::studio;

namespace mirrorball::test {

static const RegisterTests<JobRunnerTest> registered;

void JobRunnerTest::worksOffTheGuiThreadAndDeliversOnIt()
{
    JobRunner runner;
    QThread* worker = nullptr;
    QThread* used = nullptr;
    runner.start([](const JobControl&) { return QThread::currentThread(); },
                 [&](QThread* result) {
                     worker = result;
                     used = QThread::currentThread();
                 });
    QVERIFY(runner.isBusy());
    QTRY_VERIFY(!runner.isBusy());
    QCOMPARE(used, QThread::currentThread());
    QVERIFY(worker != used);
}

void JobRunnerTest::theNewestRequestWins()
{
    JobRunner runner;
    std::atomic<bool> began{false};
    std::atomic<int> ran{0};
    QList<int> results;
    runner.start(
        [&](const JobControl& job) {
            began = true;
            for (;;)
                job.checkStop(); // ends only because a newer request stops it
            return 0;
        },
        [&](int result) { results.push_back(result); });
    QTRY_VERIFY(began);
    for (int i = 1; i <= 50; ++i)
        runner.start(
            [&ran, i](const JobControl&) {
                ++ran;
                return i;
            },
            [&](int result) { results.push_back(result); });
    QTRY_VERIFY(!runner.isBusy());
    QCOMPARE(results, QList<int>{50});
    QVERIFY(ran < 50); // those that waited were replaced
}

void JobRunnerTest::aShortRunningRequestMayFinish()
{
    JobRunner runner;
    std::atomic<bool> began{false}, mayEnd{false};
    QList<int> results;
    const auto use = [&](int result) { results.push_back(result); };
    runner.start(
        [&](const JobControl& job) {
            began = true;
            while (!mayEnd)
                job.checkStop();
            return 1;
        },
        use);
    QTRY_VERIFY(began);
    runner.start([](const JobControl&) { return 2; }, use, Running::Finish);
    runner.start([](const JobControl&) { return 3; }, use, Running::Finish);
    mayEnd = true;
    QTRY_VERIFY(!runner.isBusy());
    QCOMPARE(results, (QList<int>{1, 3}));
}

void JobRunnerTest::stopsAndSaysSo()
{
    JobRunner runner;
    QSignalSpy stopped(&runner, &JobRunner::stopped), failed(&runner, &JobRunner::failed);
    bool used = false;
    runner.start(
        [](const JobControl& job) {
            for (;;)
                job.checkStop();
            return 0;
        },
        [&](int) { used = true; });
    runner.stop();
    QCOMPARE(stopped.size(), 1);
    QTRY_VERIFY(!runner.isBusy());
    QVERIFY(!used);
    QCOMPARE(failed.size(), 0);
}

void JobRunnerTest::reportsErrorsInWords()
{
    JobRunner runner;
    QSignalSpy failed(&runner, &JobRunner::failed);
    runner.start([](const JobControl&) -> int { throw FileError("probe.hdr", "does not exist; check the path"); }, [](int) {});
    QTRY_COMPARE(failed.size(), 1);
    QCOMPARE(failed.front().front().toString(), QStringLiteral("probe.hdr: does not exist; check the path"));
    QTRY_VERIFY(!runner.isBusy());
}

} // namespace mirrorball::test
