// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the bridge on this machine, over loopback: the time from a board's report to a client's
// receive, with 1 and 100 clients, and beside a reader that has stalled; the same from and to OSC;
// 1000 clients connected at once, and the time to stop with them. Prints a line for each; exits
// with 1 if a count is wrong, or if a stalled reader delays others. usage: bridge_load [--quick]
//
// A hundred reports a second reach a client of an idle machine one by one; a busy machine sends
// some of them together. Hence --quick, for ctest, has each report wait until the one before has
// arrived, and compares a stalled reader's server with one without, report by report in turn.
#include <sys/epoll.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <thread>

#include "helpers.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::bridge::test {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

// The number of the report is what is sent: app.time takes any.
const std::string kCounter =
    "[[map]]\nfrom = \"board0/a1\"\nto = \"app.time\"\nin = [0, 1000000]\nout = [0, 1000000]\n"
    "hysteresis = 0\n";

struct Latencies {
    std::vector<double> all;
    std::size_t least_of_a_client = 0;

    double quantile(double q) {
        if (all.empty()) return NAN;
        std::ranges::sort(all);
        return all[std::min(all.size() - 1,
                            static_cast<std::size_t>(q * static_cast<double>(all.size())))];
    }
};

/// `hertz` reports a second; of the values that the clients got, how old they were.
Latencies measure(Served& served, int clients, int hertz, double seconds) {
    const auto reports = static_cast<std::size_t>(hertz * seconds);
    const int poll = ::epoll_create1(EPOLL_CLOEXEC);
    std::vector<RawClient> all;
    for (int i = 0; i < clients; ++i) {
        RawClient raw = served.client();
        raw.ask("SUBSCRIBE app.time");
        raw.line_with("VAL");
        epoll_event event{.events = EPOLLIN, .data = {.u32 = static_cast<std::uint32_t>(i)}};
        ::epoll_ctl(poll, EPOLL_CTL_ADD, raw.descriptor(), &event);
        all.push_back(std::move(raw));
    }
    std::vector<std::atomic<Clock::rep>> sent(reports + 2);
    std::atomic<bool> done = false;
    served.turn(0);
    std::thread board([&] {
        auto due = Clock::now();
        for (std::size_t i = 1; i <= reports; ++i) {
            due += std::chrono::nanoseconds(1'000'000'000 / hertz);
            std::this_thread::sleep_until(due);
            sent[i] = Clock::now().time_since_epoch().count();
            served.turn(static_cast<double>(i));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        done = true;
    });
    Latencies latencies;
    std::vector<std::size_t> counts(static_cast<std::size_t>(clients));
    std::vector<std::string> rest(static_cast<std::size_t>(clients));
    epoll_event events[64];
    while (!done) {
        const int ready = ::epoll_wait(poll, events, 64, 50);
        for (int i = 0; i < ready; ++i) {
            const std::size_t client = events[i].data.u32;
            char block[4096];
            const auto count = ::recv(all[client].descriptor(), block, sizeof block, 0);
            const auto now = Clock::now().time_since_epoch().count();
            if (count <= 0) continue;
            std::string& text = rest[client];
            text.append(block, static_cast<std::size_t>(count));
            for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos;) {
                unsigned long number = 0;
                if (std::sscanf(text.c_str(), "UPD app.time %lu", &number) == 1 && number > 0 &&
                    number <= reports) {
                    latencies.all.push_back(static_cast<double>(now - sent[number]) * 1e-6);
                    ++counts[client];
                }
                text.erase(0, end + 1);
            }
        }
    }
    board.join();
    ::close(poll);
    latencies.least_of_a_client = *std::ranges::min_element(counts);
    return latencies;
}

/// A server and clients that each get every report: the next goes out when all have the one before.
class InTurn {
  public:
    InTurn(ServerOptions options, int clients) : served_(std::move(options), kCounter) {
        for (int i = 0; i < clients; ++i) {
            clients_.push_back(served_.client());
            clients_.back().ask("SUBSCRIBE app.time");
            clients_.back().line_with("VAL");
        }
        served_.turn(0);
    }

    Served& served() { return served_; }
    /// Sends the next report; how many clients got it.
    int pass() {
        // Beyond the least interval between updates, or that would be measured.
        std::this_thread::sleep_for(std::chrono::milliseconds(3));
        const auto start = Clock::now();
        served_.turn(++report_);
        const std::string expected = "UPD app.time " + std::to_string(report_);
        int told = 0;
        for (RawClient& client : clients_) {
            told += client.line_with("UPD") == expected ? 1 : 0;
            latencies_.all.push_back(Milliseconds(Clock::now() - start).count());
        }
        return told;
    }
    Latencies& latencies() { return latencies_; }

  private:
    Served served_;
    std::vector<RawClient> clients_;
    int report_ = 0;
    Latencies latencies_;
};

/// Open Sound Control beside the lines, one value after the other: a message until a client has it,
/// and a client's line until a target has its bundle.
class OscPath {
  public:
    OscPath() : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in local = loopback(0);
        ::bind(socket_, reinterpret_cast<sockaddr*>(&local), sizeof local);
        socklen_t size = sizeof local;
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&local), &size);
        const timeval patience{kPatience / 1000, 0};
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
        served_.emplace(ServerOptions{.commands_per_second = 1e6,
                                      .osc = {.listen = Endpoint{"127.0.0.1", 0},
                                              .to = {{"127.0.0.1", ntohs(local.sin_port)}}}});
        client_.emplace(served_->client());
        client_->ask("SUBSCRIBE app.time");
        client_->line_with("VAL");
        // A snapshot's last value is that of frame_rate; then each bundle holds a change alone.
        while (received().find("frame_rate") == std::string::npos) {
        }
    }
    ~OscPath() { ::close(socket_); }

    /// Beyond the interval of the bundles, or that would be measured.
    std::chrono::milliseconds pause{18};

    Latencies to_client(int count) {
        const sockaddr_in bridge = loopback(served_->server.osc_endpoint()->port);
        return measure(count, [&](int i) {
            char message[] = "/ocean/app/time\0,i\0\0\0\0\0";
            message[22] = static_cast<char>(i >> 8);
            message[23] = static_cast<char>(i);
            ::sendto(socket_, message, 24, 0, reinterpret_cast<const sockaddr*>(&bridge),
                     sizeof bridge);
            return client_->line_with("UPD") == "UPD app.time " + std::to_string(i);
        });
    }
    Latencies to_target(int count) {
        return measure(count, [&](int i) {
            client_->send("SET app.time " + std::to_string(i + 100'000) + "\n");
            return received().find("/ocean/app/time") != std::string::npos;
        });
    }

  private:
    static sockaddr_in loopback(unsigned short port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return address;
    }
    std::string received() const {
        char block[4096];
        const auto count = ::recv(socket_, block, sizeof block, 0);
        return {block, static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
    }
    template <typename Pass>
    Latencies measure(int count, const Pass& pass) const {
        Latencies latencies;
        for (int i = 1; i <= count; ++i) {
            std::this_thread::sleep_for(pause);
            const auto start = Clock::now();
            if (!pass(i)) break;
            latencies.all.push_back(Milliseconds(Clock::now() - start).count());
        }
        latencies.least_of_a_client = latencies.all.size();
        return latencies;
    }

    int socket_;
    std::optional<Served> served_;
    std::optional<RawClient> client_;
};

void print(const char* what, Latencies& latencies, double seconds = 0.0) {
    std::printf("%-44s p10 %.3f ms, p50 %.3f ms, p99 %.3f ms, max %.1f ms", what,
                latencies.quantile(0.1), latencies.quantile(0.5), latencies.quantile(0.99),
                latencies.quantile(1.0));
    if (seconds > 0.0) {
        std::printf(", %.1f updates/s", static_cast<double>(latencies.least_of_a_client) / seconds);
    }
    std::printf("\n");
    std::fflush(stdout);
}

double cpu_seconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1e-6;
}

bool check(bool holds, const char* what) {
    if (!holds) std::printf("FAILED: %s\n", what);
    return holds;
}

/// A client that asks much, reads nothing, and wants to be told of everything.
RawClient stalled_reader(const Served& served) {
    RawClient stalled(served.server.endpoint(), 4096);
    stalled.line();
    std::string questions;
    for (int i = 0; i < 400; ++i) questions += "LIST\n";
    stalled.send("SUBSCRIBE\n" + questions);
    return stalled;
}

bool judge_in_turn() {
    constexpr int kReports = 100;
    bool good = true;
    {
        InTurn alone({}, 1);
        InTurn beside({.commands_per_second = 1e6}, 1);
        const RawClient stalled = stalled_reader(beside.served());
        int told = 0;
        for (int i = 0; i < kReports; ++i) {
            InTurn& first = i % 2 == 0 ? alone : beside;
            InTurn& second = i % 2 == 0 ? beside : alone;
            told += first.pass();
            told += second.pass();
        }
        print("1 client, report after report", alone.latencies());
        print("1 client beside a stalled reader", beside.latencies());
        good &= check(told == 2 * kReports, "updates are missing");
        // Other programs delay most updates of a busy machine. A reader that delays the server
        // delays each update, the fastest ones too.
        good &=
            check(beside.latencies().quantile(0.1) < 2.0 * alone.latencies().quantile(0.1) + 0.5,
                  "a stalled reader is felt");
    }
    InTurn hundred({.clients = 200}, 100);
    int told = 0;
    for (int i = 0; i < kReports; ++i) told += hundred.pass();
    print("100 clients, report after report", hundred.latencies());
    return check(told == 100 * kReports, "updates of a hundred are missing") && good;
}

/// At the pace of a board: figures of a machine that has nothing else to do.
bool measure_at_pace(double seconds) {
    const double enough = 0.9 * 100 * seconds;
    bool good = true;
    double alone = 0.0;
    {
        Served served({}, kCounter);
        Latencies one = measure(served, 1, 100, seconds);
        print("1 client, 100 reports/s", one, seconds);
        alone = one.quantile(0.99);
        good &= check(static_cast<double>(one.least_of_a_client) > enough, "updates are missing");
    }
    {
        Served served({}, kCounter);
        RawClient stalled(served.server.endpoint(), 4096);
        stalled.send("SUBSCRIBE\n");
        Latencies beside = measure(served, 1, 100, seconds);
        print("1 client beside a stalled reader", beside, seconds);
        good &= check(beside.quantile(0.99) < 2.0 * alone + 0.5, "a stalled reader is felt");
    }
    {
        Served served({.clients = 200}, kCounter);
        Latencies hundred = measure(served, 100, 100, seconds);
        print("100 clients, 100 reports/s", hundred, seconds);
        good &= check(static_cast<double>(hundred.least_of_a_client) > 0.5 * enough,
                      "updates of a hundred are missing");
    }
    Served served({}, kCounter);
    Latencies fast = measure(served, 1, 1000, seconds);
    print("1 client, 1000 reports/s", fast, seconds);
    return good;
}

int run(bool quick) {
    const double seconds = 10.0;
    bool good = quick ? judge_in_turn() : measure_at_pace(seconds);
#ifdef OCEAN_HAVE_LIBLO
    {
        OscPath path;
        if (quick) path.pause = {};
        const int count = quick ? 50 : 1000;
        Latencies in = path.to_client(count);
        print("OSC message to a client", in);
        Latencies out = path.to_target(count);
        print("a client's SET to an OSC target", out);
        good &= check(in.all.size() + out.all.size() == 2 * static_cast<std::size_t>(count),
                      "OSC messages are missing");
    }
#endif
    {
        const int count = 1000;
        Served served({.clients = count}, kCounter);
        require_descriptors(2 * count);
        std::vector<RawClient> all;
        for (int i = 0; i < count; ++i) {
            RawClient raw(served.server.endpoint());
            raw.send("SUBSCRIBE app.time\n");
            all.push_back(std::move(raw));
        }
        served.turn(0);
        for (RawClient& raw : all) raw.line_with("VAL");
        served.turn(7);
        std::size_t told = 0;
        for (RawClient& raw : all) told += raw.line_with("UPD") == "UPD app.time 7" ? 1 : 0;
        std::printf("%-44s %zu of %d told\n", "1000 clients held", told, count);
        good &= check(told == count, "a client of 1000 was not told");
        if (!quick) {
            const double cpu = cpu_seconds();
            const auto idle = Clock::now();
            std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
            const double wall = Milliseconds(Clock::now() - idle).count() * 1e-3;
            std::printf("%-44s %.2f %% of a core\n", "at rest with 1000 clients",
                        100.0 * (cpu_seconds() - cpu) / wall);
        }
        const auto start = Clock::now();
        served.server.stop();
        std::printf("%-44s %.1f ms\n", "stop with 1000 clients",
                    Milliseconds(Clock::now() - start).count());
        std::size_t ended = 0;
        for (RawClient& raw : all) ended += raw.line_with("(").empty() ? 1 : 0;
        good &= check(ended == count, "a client of 1000 was not let go");
    }
    return good ? 0 : 1;
}

}  // namespace
}  // namespace ocean::bridge::test

int main(int argc, char** argv) {
    return ocean::bridge::test::run(argc > 1 && std::strcmp(argv[1], "--quick") == 0);
}
