// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "mock_k8055.hpp"

#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>
#include <utility>

namespace {

constexpr const char* kPath = "/sys/devices/pci0/usb1/1-1";

/// A block of the program's memory, as umockdev hands it over.
class Block {
  public:
    Block(UMockdevIoctlData* owner, std::size_t offset, std::size_t size)
        : data_(umockdev_ioctl_data_resolve(owner, offset, size, nullptr)) {}
    ~Block() { umockdev_ioctl_data_unref(data_); }
    Block(const Block&) = delete;
    Block& operator=(const Block&) = delete;

    template <typename Type>
    const Type* as() const {
        return reinterpret_cast<const Type*>(data_->data);
    }
    UMockdevIoctlData* data() const { return data_; }
    template <typename Type>
    void store(Type value) const {
        store(reinterpret_cast<guint8*>(&value), sizeof(value));
    }
    void store(guint8* bytes, std::size_t count) const {
        umockdev_ioctl_data_update(data_, 0, bytes, static_cast<gint>(count));
    }

  private:
    UMockdevIoctlData* data_;
};

}  // namespace

/// A request for bytes, or with bytes, that the program has submitted.
struct MockK8055::Transfer {
    const UMockdevIoctlBase* node;  // that of the handler
    UMockdevIoctlData* urb;         // a reference
    bool done = false;
    int status = 0;
    Bytes bytes = {};

    usbdevfs_urb* fields() const { return reinterpret_cast<usbdevfs_urb*>(urb->data); }
    std::size_t size() const { return static_cast<std::size_t>(fields()->buffer_length); }
    Block buffer() const { return {urb, G_STRUCT_OFFSET(usbdevfs_urb, buffer), size()}; }
    bool is_in() const { return (fields()->endpoint & 0x80) != 0; }
};

MockK8055::MockK8055(Witness witness) : witness_(std::move(witness)), bed_(umockdev_testbed_new()) {
    gchar* root = umockdev_testbed_get_root_dir(bed_);
    root_ = root;
    g_free(root);
}

MockK8055::~MockK8055() {
    for (UMockdevIoctlBase* handler : handlers_) g_object_unref(handler);
    g_object_unref(bed_);
    for (const Transfer& transfer : transfers_) umockdev_ioctl_data_unref(transfer.urb);
    if (pipe_ >= 0) ::close(pipe_);
}

void MockK8055::plug(int address) {
    ++number_;
    std::array<char, 64> node{};
    std::snprintf(node.data(), node.size(), "/dev/bus/usb/001/%03d", number_);
    node_ = node.data();
    UMockdevIoctlBase* handler = umockdev_ioctl_base_new();
    g_signal_connect(handler, "handle-ioctl", G_CALLBACK(on_ioctl), this);
    {
        const std::lock_guard lock(mutex_);
        handlers_.push_back(handler);
        plugged_ = true;
        kernel_driver_ = true;
        claimed_ = false;
    }
    GError* error = nullptr;
    umockdev_testbed_attach_ioctl(bed_, node_.c_str(), handler, &error);
    make_pipe();  // before anybody is told of the node
    if (error == nullptr) {
        umockdev_testbed_add_from_string(bed_, description(address).c_str(), &error);
    }
    if (error != nullptr) witness_.error(error->message);
    umockdev_testbed_uevent(bed_, kPath, "add");
}

void MockK8055::unplug(std::chrono::milliseconds news) {
    {
        const std::lock_guard lock(mutex_);
        plugged_ = false;
        for (Transfer& transfer : transfers_) finish(transfer, -ESHUTDOWN);
        show_ready(true);  // for good: a program that waits for a transfer of later hears of it
    }
    std::this_thread::sleep_for(news);
    umockdev_testbed_uevent(bed_, kPath, "remove");
    umockdev_testbed_remove_device(bed_, kPath);
    unplugged_.push_back(node_);
}

void MockK8055::close_unplugged() {
    for (const std::string& node : std::exchange(unplugged_, {})) {
        GError* error = nullptr;
        umockdev_testbed_detach_ioctl(bed_, node.c_str(), &error);
        if (error != nullptr) witness_.error(error->message);
    }
}

void MockK8055::set(const Bytes& report) {
    const std::lock_guard lock(mutex_);
    report_ = report;
    is_new_ = true;
}
void MockK8055::stall() {
    const std::lock_guard lock(mutex_);
    for (Transfer& transfer : transfers_) {
        if (!transfer.done && transfer.is_in()) return finish(transfer, -EPIPE);
    }
}
/// Returns true if the program may claim the board.
void MockK8055::refuse(bool refused) {
    const std::lock_guard lock(mutex_);
    refused_ = refused;
}

/// The board's own clock has come to another report.
void MockK8055::tick() {
    const std::lock_guard lock(mutex_);
    for (Transfer& transfer : transfers_) {
        if (transfer.done || !transfer.is_in()) continue;
        transfer.bytes = report_;
        finish(transfer, 0);
        witness_.reported();
        if (std::exchange(is_new_, false)) {
            witness_.sent(Clock::now());
        }
        return;
    }
}

/// A low-speed HID device with one interface and two interrupt endpoints of 8 bytes.
std::string MockK8055::description(int address) const {
    const std::string number = std::to_string(number_);
    return "P: /devices/pci0/usb1/1-1\nE: SUBSYSTEM=usb\nE: DRIVER=usb\n"
           "E: BUSNUM=001\nE: DEVNUM=" +
           number + "\nE: DEVNAME=" + node_ +
           "\nE: DEVTYPE=usb_device\nA: bConfigurationValue=1\\n\nA: busnum=1\\n\nA: devnum=" +
           number + "\\n\nA: speed=1.5\\n\nH: descriptors=1201100100000008cf100" +
           std::to_string(address) +
           "55000101020001"
           "09022900010100a032"
           "0904000002030000000921000100012219000705810308000a0705010308000a\n";
}

/// The node as a pipe: the program's poll() wakes when it is drained, which is when a transfer
/// is done, and does not spin.
void MockK8055::make_pipe() {
    const std::string path = root_ + node_;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    const std::lock_guard lock(mutex_);
    ::unlink(path.c_str());
    if (::mkfifo(path.c_str(), 0666) != 0) witness_.error("mkfifo");
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    show_ready(false);
}
void MockK8055::show_ready(bool ready) const {
    std::array<char, 4096> block{};
    if (ready) {
        while (::read(pipe_, block.data(), block.size()) > 0) {
        }
    } else {
        while (::write(pipe_, block.data(), block.size()) > 0) {
        }
    }
}
void MockK8055::finish(Transfer& transfer, int status) const {
    if (transfer.done) return;
    transfer.done = true;
    transfer.status = status;
    show_ready(true);
}

gboolean MockK8055::on_ioctl(UMockdevIoctlBase* node, UMockdevIoctlClient* client, gpointer self) {
    const long result = static_cast<MockK8055*>(self)->answer(
        node, umockdev_ioctl_client_get_request(client), umockdev_ioctl_client_get_arg(client));
    umockdev_ioctl_client_complete(client, result < 0 ? -1 : result,
                                   result < 0 ? static_cast<int>(-result) : 0);
    return TRUE;
}

bool MockK8055::is_there(const UMockdevIoctlBase* node) const {
    return plugged_ && node == handlers_.back();
}

/// Returns the answer of usbfs, or a negative error number if it refuses.
long MockK8055::answer(const UMockdevIoctlBase* node, gulong request, UMockdevIoctlData* argument) {
    const std::lock_guard lock(mutex_);
    const bool reaps = request == USBDEVFS_REAPURB || request == USBDEVFS_REAPURBNDELAY;
    if (!is_there(node) && !reaps) return -ENODEV;
    switch (request) {
        case USBDEVFS_GET_CAPABILITIES: {
            const guint32 able = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                 USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
            Block(argument, 0, sizeof(able)).store(able);
            return 0;
        }
        case USBDEVFS_GETDRIVER: {
            if (!kernel_driver_ && !claimed_) return -ENODATA;
            const Block block(argument, 0, sizeof(usbdevfs_getdriver));
            usbdevfs_getdriver driver = *block.as<usbdevfs_getdriver>();
            std::strcpy(driver.driver, claimed_ ? "usbfs" : "vmk80xx");
            block.store(driver);
            return 0;
        }
        case USBDEVFS_IOCTL:
            return switch_driver(
                Block(argument, 0, sizeof(usbdevfs_ioctl)).as<usbdevfs_ioctl>()->ioctl_code);
        case USBDEVFS_DISCONNECT_CLAIM:
            if (refused_) {
                witness_.refused();
                return -EBUSY;
            }
            if (std::exchange(kernel_driver_, false)) witness_.kernel_driver(false);
            claimed_ = true;
            return 0;
        case USBDEVFS_CLAIMINTERFACE:
            if (kernel_driver_ || refused_) return -EBUSY;
            claimed_ = true;
            return 0;
        case USBDEVFS_RELEASEINTERFACE:
            claimed_ = false;
            return 0;
        case USBDEVFS_SUBMITURB:
            return submit(node, argument);
        case USBDEVFS_DISCARDURB:
            return discard(*reinterpret_cast<gulong*>(argument->data));
        default:
            return reaps ? reap(node, argument) : -ENOTTY;
    }
}

long MockK8055::switch_driver(int code) {
    if (static_cast<unsigned>(code) == USBDEVFS_DISCONNECT) {
        if (!std::exchange(kernel_driver_, false)) return -ENODATA;
        witness_.kernel_driver(false);
        return 0;
    }
    if (static_cast<unsigned>(code) != USBDEVFS_CONNECT) return -ENOTTY;
    kernel_driver_ = true;
    witness_.kernel_driver(true);
    return 1;
}

long MockK8055::submit(const UMockdevIoctlBase* node, UMockdevIoctlData* argument) {
    UMockdevIoctlData* submitted =
        umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
    transfers_.push_back({node, submitted});
    Transfer& transfer = transfers_.back();
    usbdevfs_urb& urb = *transfer.fields();
    const Block buffer = transfer.buffer();  // which makes umockdev fetch it
    if (transfer.is_in()) return 0;
    const auto* bytes = buffer.as<std::uint8_t>();
    witness_.out({bytes, bytes + transfer.size()});
    urb.actual_length = urb.buffer_length;
    finish(transfer, 0);
    return 0;
}

long MockK8055::reap(const UMockdevIoctlBase* node, UMockdevIoctlData* argument) {
    for (auto transfer = transfers_.begin(); transfer != transfers_.end(); ++transfer) {
        if (!transfer->done || transfer->node != node) continue;
        usbdevfs_urb& urb = *transfer->fields();
        urb.status = transfer->status;
        if (transfer->is_in() && transfer->status == 0) {
            const std::size_t count = std::min(transfer->size(), transfer->bytes.size());
            transfer->buffer().store(transfer->bytes.data(), count);
            urb.actual_length = static_cast<int>(count);
        }
        const Block place(argument, 0, sizeof(void*));
        umockdev_ioctl_data_set_ptr(place.data(), 0, transfer->urb);
        transfers_.erase(transfer);
        const bool more = std::ranges::any_of(
            transfers_, [node](const Transfer& left) { return left.done && left.node == node; });
        if (!more && is_there(node)) show_ready(false);
        return 0;
    }
    return is_there(node) ? -EAGAIN : -ENODEV;
}

long MockK8055::discard(gulong address) {
    for (Transfer& transfer : transfers_) {
        if (transfer.done || transfer.urb->client_addr != address) continue;
        finish(transfer, -ENOENT);
        return 0;
    }
    return -EINVAL;
}

MockK8055::Bytes k8055_report(unsigned a1, unsigned a2, unsigned digital, unsigned c1,
                              unsigned c2) {
    const unsigned bits = (digital & 1) << 4 | (digital & 2) << 4 | (digital & 4) >> 2 |
                          (digital & 8) << 3 | (digital & 16) << 3;
    MockK8055::Bytes report;
    for (const unsigned byte : {bits, 1U, a1, a2, c1, c1 >> 8, c2, c2 >> 8}) {
        report.push_back(static_cast<std::uint8_t>(byte));
    }
    return report;
}
