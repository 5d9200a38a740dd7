// Threads that report to the interface by queued calls.
// SPDX-FileCopyrightText: The Relievo authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/document/background.h"
#include <QMetaObject>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <new>

namespace relievo {
namespace {
// True at most 20 times a second, from whichever thread asks.
struct Ticker {
    std::atomic<std::int64_t> next{0};
    bool due()
    {
        using namespace std::chrono;
        const std::int64_t now = duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
        std::int64_t expected = next.load();
        return now >= expected && next.compare_exchange_strong(expected, now + 50);
    }
};
} // namespace

Background::Then Background::guarded(const std::function<Then()>& work)
{
    const auto failure = [this](const QString& what) -> Then { return [this, what] { Q_EMIT failed(what); }; };
    try {
        return work();
    } catch (const std::bad_alloc&) {
        return failure(tr("there is not enough memory"));
    } catch (const std::exception& error) {
        return failure(tr("internal fault (%1)").arg(error.what()));
    }
}

Background::Background(QObject* parent) : QObject(parent) { }

Background::~Background()
{
    for (Run& run : m_runs)
        run.thread.request_stop();
}

void Background::start(std::function<Then(const Progress&)> work, const QString& what)
{
    m_what = what;
    for (Run& run : m_runs)
        run.thread.request_stop();
    const int id = ++m_lastId;
    const bool wasBusy = busy();
    m_current = id;
    m_runs.push_back({id, std::jthread([this, id, work = std::move(work)](std::stop_token stop) {
                          const auto ticker = std::make_shared<Ticker>();
                          const auto report = [this, id, ticker](float share) {
                              if (ticker->due())
                                  QMetaObject::invokeMethod(
                                      this, [this, id, share] { this->report(id, share); }, Qt::QueuedConnection);
                          };
                          const Then then = guarded([&] { return work(Progress{report, stop}); });
                          QMetaObject::invokeMethod(
                              this, [this, id, then] { finish(id, then); }, Qt::QueuedConnection);
                      })});
    if (!wasBusy)
        Q_EMIT busyChanged(true);
}

void Background::cancel()
{
    if (!busy())
        return;
    for (Run& run : m_runs)
        run.thread.request_stop();
    m_current = 0;
    Q_EMIT busyChanged(false);
}

void Background::report(int id, float share)
{
    if (id == m_current)
        Q_EMIT progressed(share);
}

void Background::finish(int id, const Then& then)
{
    m_runs.remove_if([id](const Run& run) { return run.id == id; });
    if (id != m_current)
        return;
    m_current = 0;
    if (then)
        then();
    if (!busy())
        Q_EMIT busyChanged(false);
}

} // namespace relievo
