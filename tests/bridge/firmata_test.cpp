// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Firmata: bytes of its protocol 2.5 both ways, wherever they are cut; a board at a pseudo-terminal
// that resets, goes and comes back.
#include <fcntl.h>
#include <stdlib.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <system_error>
#include <thread>

#include "firmata_protocol.hpp"
#include "listening.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/bridge/firmata_source.hpp"
#include "testing.hpp"

namespace ocean::bridge {
namespace {

using namespace std::chrono_literals;
using test::Ear;
using test::open_descriptors;
using Bytes = std::vector<std::uint8_t>;

std::vector<FirmataReport> parse_firmata(const Bytes& bytes) {
    return FirmataParser().feed(bytes);
}

/// The first bytes of an Uno: protocol 2.5, then the name of its program.
const Bytes kGreeting = {0xF9, 2, 5, 0xF0, 0x79, 2, 5, 'S', 0, 't', 0, 'd', 0, 0xF7};

TEST(FirmataParser, KnowsWhatABoardSays) {
    EXPECT_EQ(parse_firmata(kGreeting),
              (std::vector<FirmataReport>{{FirmataKind::version, 2, 5}, {FirmataKind::firmware}}));
    EXPECT_EQ(
        parse_firmata({0xE0, 0x7F, 0x07, 0xE5, 0x01, 0x02, 0x90, 0x04, 0x00, 0x91, 0x00, 0x01}),
        (std::vector<FirmataReport>{{FirmataKind::analog, 0, 1023},
                                    {FirmataKind::analog, 5, 257},
                                    {FirmataKind::digital, 0, 4},
                                    {FirmataKind::digital, 1, 128}}));
}

TEST(FirmataParser, WhatItDoesNotKnowIsSkipped) {
    EXPECT_TRUE(parse_firmata({}).empty());
    EXPECT_TRUE(parse_firmata({1, 2, 3}).empty());
    EXPECT_TRUE(parse_firmata({0xE0, 1}).empty());
    // A text, a message that another breaks off, a reset, one of no such kind; no running status.
    EXPECT_EQ(
        parse_firmata({0xF0, 0x71, 'H', 0, 0xF7, 0xE1, 5, 0xE2, 6, 0, 7, 7, 0xFF, 1, 1, 0xC0, 1}),
        (std::vector<FirmataReport>{{FirmataKind::analog, 2, 6}}));
    EXPECT_TRUE(parse_firmata({0xF0, 0xF7, 0xF7, 0xF0, 0x79, 0xE0, 0xF7}).empty());
    Bytes endless(100'000, 0x79);
    endless.front() = 0xF0;
    EXPECT_TRUE(parse_firmata(endless).empty());
}

TEST(FirmataParser, ItDoesNotMatterWhereAStreamIsCut) {
    Bytes stream = kGreeting;
    for (const int byte : {0xE0, 1, 2, 0x90, 3, 1, 0xE1, 5, 0xE2, 6, 0}) {
        stream.push_back(static_cast<std::uint8_t>(byte));
    }
    const std::vector<FirmataReport> whole = parse_firmata(stream);
    EXPECT_EQ(whole.size(), 5u);
    for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
        FirmataParser parser;
        std::vector<FirmataReport> reports = parser.feed(std::span(stream).first(cut));
        const std::vector<FirmataReport> rest = parser.feed(std::span(stream).subspan(cut));
        reports.insert(reports.end(), rest.begin(), rest.end());
        EXPECT_EQ(reports, whole) << cut;
    }
}

TEST(FirmataWriter, SaysWhatTheProtocolSays) {
    FirmataWriter writer;
    writer.request_version();
    writer.set_pin_mode(4, PinMode::pullup);
    writer.set_sampling_interval(500);
    writer.report_analog(5);
    writer.report_digital(1);
    writer.write_digital(13, true);
    writer.write_pwm(9, 200);
    writer.write_pwm(44, 255);
    ASSERT_EQ(Bytes(writer.bytes().begin(), writer.bytes().end()),
              (Bytes{0xF9, 0xF4, 4, 0x0B, 0xF0, 0x7A, 0x74, 0x03, 0xF7, 0xC5, 1,    0xD1, 1,
                     0xF5, 13,   1, 0xE9, 0x48, 0x01, 0xF0, 0x6F, 44,   0x7F, 0x01, 0xF7}));
    writer.drop(24);
    EXPECT_EQ(writer.bytes().front(), 0xF7);
    writer.drop(1);
    EXPECT_TRUE(writer.empty());
}

/// A line whose other end the test holds, at a path that stays.
class Line {
  public:
    Line() : path_(testing::TempDir() + "firmata_" + std::to_string(::getpid())) {}
    ~Line() { unplug(); }

    const std::string& path() const { return path_; }
    void plug() {
        master_ = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        ASSERT_TRUE(master_ >= 0 && ::grantpt(master_) == 0 && ::unlockpt(master_) == 0);
        char name[64];
        ASSERT_EQ(::ptsname_r(master_, name, sizeof name), 0);
        std::filesystem::create_symlink(name, path_);
    }
    void unplug() {
        std::filesystem::remove(path_);
        if (master_ >= 0) ::close(std::exchange(master_, -1));
    }
    void say(const Bytes& bytes) const {
        ASSERT_EQ(::write(master_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    /// The next bytes that the board gets; questions for its version are left out.
    Bytes get(std::size_t count) const {
        Bytes bytes;
        while (bytes.size() < count) {
            pollfd waits{master_, POLLIN, 0};
            std::uint8_t byte = 0;
            if (::poll(&waits, 1, test::kPatience) <= 0 || ::read(master_, &byte, 1) != 1) break;
            if (byte != 0xF9) bytes.push_back(byte);
        }
        return bytes;
    }
    bool is_asked() const {
        pollfd waits{master_, POLLIN, 0};
        std::uint8_t byte = 0;
        return ::poll(&waits, 1, test::kPatience) > 0 && ::read(master_, &byte, 1) == 1 &&
               byte == 0xF9;
    }
    /// Fills the line from the source's end, which is in this process, until it takes no more.
    void fill() const {
        const std::filesystem::path terminal = std::filesystem::canonical(path_);
        for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
            std::error_code gone;
            if (std::filesystem::read_symlink(entry, gone) != terminal) continue;
            const int end = std::stoi(entry.path().filename());
            for (int refused = 0; refused < 10; ++refused) {
                const Bytes block(64, 0);
                while (::write(end, block.data(), block.size()) > 0) refused = 0;
                std::this_thread::sleep_for(5ms);  // the system moves them on
            }
        }
    }
    /// Returns true if the line held more than `bytes`.
    bool held_more_than(std::size_t bytes) const {
        std::size_t count = 0;
        std::uint8_t block[4096];
        pollfd waits{master_, POLLIN, 0};
        while (count <= bytes && ::poll(&waits, 1, test::kPatience) > 0) {
            const ssize_t got = ::read(master_, block, sizeof block);
            if (got <= 0) break;
            count += static_cast<std::size_t>(got);
        }
        return count > bytes;
    }
    bool is_exclusive() const {
        int exclusive = 0;
        const int end = ::open(path_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
        ::ioctl(end, TIOCGEXCL, &exclusive);
        ::close(end);
        return exclusive != 0;
    }

  private:
    std::string path_;
    int master_ = -1;
};

class FirmataBoard : public testing::Test {
  protected:
    void begin() {
        source = make_firmata_source("f", {line.path(), 57600, {0, 5}, {2}, {4, 12}, {13}, {9}});
        source->start(ear.listener());
    }
    void plug() {
        line.plug();
        ASSERT_TRUE(line.is_asked());
        line.say({0xF9, 2, 5});
        ASSERT_TRUE(ear.hears_event("f CONNECTED: Firmata 2.5 at " + line.path()));
    }
    static Bytes orders() {
        return {0xF4, 2,    0,    0xF4, 4, 0x0B, 0xF4, 12, 0x0B, 0xF4, 13,   1, 0xF4, 9,
                3,    0xF0, 0x7A, 10,   0, 0xF7, 0xC0, 1,  0xC5, 1,    0xD0, 1, 0xD1, 1};
    }
    void expect_orders() const { EXPECT_EQ(line.get(orders().size()), orders()); }

    Ear ear;
    Line line;
    std::unique_ptr<Source> source;
};

TEST_F(FirmataBoard, IsAskedToldAndHeard) {
    begin();
    plug();
    expect_orders();
    line.say({0xE0, 0x7F, 0x07, 0xE0, 0x7F, 0x07, 0xE1, 1, 0, 0x90, 0x14, 0});
    line.say({0x90, 0x10, 0, 0x91, 0x10, 0, 0xE5, 3});
    line.say({0});
    ASSERT_TRUE(ear.hears([](const auto& reports) { return reports.size() >= 6; }));
    EXPECT_EQ(ear.values(), (std::vector<std::string>{"f/a0 = 1023", "f/d2 = 1", "f/d4 = 1",
                                                      "f/d2 = 0", "f/d12 = 1", "f/a5 = 3"}));
    EXPECT_TRUE(line.is_exclusive());
    source->put("f/o13", 1);
    EXPECT_EQ(line.get(3), (Bytes{0xF5, 13, 1}));
    source->put("f/pwm9", 200);
    EXPECT_EQ(line.get(3), (Bytes{0xE9, 0x48, 0x01}));
    source->put("f/pwm9", 200);  // nothing new
    source->stop();
    EXPECT_EQ(line.get(6), (Bytes{0xF5, 13, 0, 0xE9, 0, 0}));
    EXPECT_FALSE(line.is_exclusive());
}

TEST_F(FirmataBoard, AResetIsNoticed) {
    begin();
    plug();
    expect_orders();
    source->put("f/o13", 1);
    EXPECT_EQ(line.get(3), (Bytes{0xF5, 13, 1}));
    line.say(kGreeting);
    expect_orders();
    EXPECT_EQ(line.get(3), (Bytes{0xF5, 13, 1}));
    EXPECT_EQ(ear.events().size(), 1u);
}

TEST_F(FirmataBoard, OutputsAreToldAgainToABoardThatIsBack) {
    begin();
    source->put("f/o13", 1);
    source->put("f/pwm9", 7);
    source->put("f/pwm9", 8);
    for (int i = 0; i < 3; ++i) {
        plug();
        expect_orders();
        EXPECT_EQ(line.get(6), (Bytes{0xF5, 13, 1, 0xE9, 8, 0}));
        line.unplug();
        ASSERT_TRUE(ear.hears_event("f LOST"));
        ear.forget();
    }
}

TEST_F(FirmataBoard, AHundredPlugsLeaveNothingOpen) {
    begin();
    EXPECT_TRUE(source->channels().empty());
    plug();
    EXPECT_EQ(source->channels().size(), 7u);
    line.unplug();
    ASSERT_TRUE(ear.hears_event("f LOST"));
    EXPECT_TRUE(source->channels().empty());
    const std::size_t open = open_descriptors();
    for (int i = 0; i < 100; ++i) {
        ear.forget();
        plug();
        line.unplug();
        ASSERT_TRUE(ear.hears_event("f LOST"));
    }
    EXPECT_EQ(open_descriptors(), open);
}

TEST_F(FirmataBoard, WhatIsNoLineIsSaidOnce) {
    std::ofstream(line.path()) << "no terminal";
    const int watch = ::inotify_init1(IN_CLOEXEC);
    ASSERT_GE(::inotify_add_watch(watch, line.path().c_str(), IN_OPEN), 0);
    begin();
    ASSERT_TRUE(ear.hears_events(1));
    EXPECT_EQ(ear.events().front(), "f BUSY: " + line.path() + ": Inappropriate ioctl for device");
    // It looks once more, and then again: what it had to say of that look is said.
    for (int looks = 0; looks < 3; ++looks) {
        pollfd waits{watch, POLLIN, 0};
        inotify_event opened{};
        ASSERT_EQ(::poll(&waits, 1, test::kPatience), 1);
        ASSERT_EQ(::read(watch, &opened, sizeof opened), static_cast<ssize_t>(sizeof opened));
    }
    ::close(watch);
    EXPECT_EQ(ear.events().size(), 1u);
    std::filesystem::remove(line.path());
    plug();
}

TEST_F(FirmataBoard, ABoardThatTakesNothingHoldsNobodyUp) {
    begin();
    plug();
    expect_orders();
    line.fill();
    for (int i = 0; i < 100'000; ++i) source->put("f/pwm9", i % 256);
    source->stop();
    EXPECT_TRUE(line.held_more_than(4096));
}

TEST_F(FirmataBoard, OnlyOutputsAreToldAndOnlyWhatTheyTake) {
    begin();
    EXPECT_THROW(source->put("f/a0", 1), Error);
    EXPECT_THROW(source->put("f/o12", 1), Error);
    EXPECT_THROW(source->put("f/o13", 2), Error);
    EXPECT_THROW(source->put("f/pwm9", 256), Error);
    source->stop();
    source->stop();
}

}  // namespace
}  // namespace ocean::bridge
