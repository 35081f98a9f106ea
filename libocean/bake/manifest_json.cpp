// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// The manifest as JSON, one line for each file. The reader accepts only the writer's form and stops
// at the first deviation, so that it never allocates more than the size of the text.
#include <nlohmann/json.hpp>

#include "manifest.hpp"
#include "ocean/error.hpp"
#include "sha256.hpp"

namespace ocean {
namespace {

using nlohmann::json;

constexpr int kManifestVersion = 1;
constexpr const char* kFilesKey = "files";
constexpr const char* kMissingKey = "missing";

bool is_hash(const std::string& text, std::size_t digits = 64) {
    return text.size() == digits && text.find_first_not_of("0123456789abcdef") == text.npos;
}

bool is_sound(const ManifestEntry& entry) {
    return !entry.name.empty() && entry.name.find('/') == entry.name.npos &&
           entry.name.find('\0') == entry.name.npos && is_hash(entry.sha256) &&
           is_hash(entry.recipe) && (entry.pixels_sha256.empty() || is_hash(entry.pixels_sha256)) &&
           (entry.subject.empty() || is_hash(entry.subject, kShortHashDigits)) &&
           (entry.sequence.empty() || is_hash(entry.sequence, kShortHashDigits));
}

class ManifestReader final : public nlohmann::json_sax<json> {
  public:
    ManifestEntries entries;
    std::string fault;
    bool version_known = false;

    bool null() override { return refuse("null is not expected"); }
    bool boolean(bool) override { return refuse("true or false is not expected"); }
    bool binary(json::binary_t&) override { return refuse("bytes are not expected"); }

    bool number_integer(std::int64_t value) override { return number(value); }
    bool number_unsigned(std::uint64_t value) override { return number(value); }
    bool number_float(double value, const std::string&) override {
        if (place_ != Place::entry || key_ != "time") return refuse("a number is not expected");
        entry_.time = value;
        return true;
    }

    bool string(std::string& value) override {
        if (place_ != Place::entry) return refuse("a text is not expected");
        if (key_ == "name") return entry_.name = value, true;
        if (key_ == "product") return entry_.product = value, true;
        if (key_ == "sha256") return entry_.sha256 = value, true;
        if (key_ == "pixels_sha256") return entry_.pixels_sha256 = value, true;
        if (key_ == "recipe") return entry_.recipe = value, true;
        if (key_ == "subject") return entry_.subject = value, true;
        if (key_ == "sequence") return entry_.sequence = value, true;
        return refuse("'" + key_.substr(0, 40) + "' is unknown or no text");
    }

    bool key(std::string& value) override {
        key_ = value;
        return true;
    }
    bool start_object(std::size_t) override {
        if (place_ == Place::outside) return place_ = Place::top, true;
        if (place_ != Place::list) return refuse("an object is not expected");
        entry_ = {};
        place_ = Place::entry;
        return true;
    }
    bool end_object() override {
        if (place_ == Place::top) return place_ = Place::outside, true;
        place_ = Place::list;
        if (!is_sound(entry_)) return refuse("an entry is incomplete");
        std::string name = entry_.name;
        entries.insert_or_assign(std::move(name), std::move(entry_));
        return true;
    }
    bool start_array(std::size_t) override {
        if (place_ == Place::top && key_ == kFilesKey) return place_ = Place::list, true;
        if (place_ == Place::top && key_ == kMissingKey) return place_ = Place::missing, true;
        return refuse("a list is not expected");
    }
    bool end_array() override { return place_ = Place::top, true; }

    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception&) override {
        return refuse("it is damaged at byte " + std::to_string(position));
    }

  private:
    enum class Place { outside, top, list, entry, missing };

    bool refuse(std::string reason) {
        if (fault.empty()) fault = std::move(reason);
        return false;
    }

    template <typename Whole>
    bool number(Whole value) {
        if (place_ == Place::missing) return true;  // each run determines the missing frames anew
        if (place_ == Place::top && key_ == kManifestKey) {
            version_known = value == static_cast<Whole>(kManifestVersion);
            return version_known || refuse("it is of another version");
        }
        if (place_ == Place::entry && key_ == "frame" && std::in_range<int>(value)) {
            entry_.frame = static_cast<int>(value);
            return true;
        }
        if (place_ == Place::entry && key_ == "bytes" && std::in_range<std::uint64_t>(value)) {
            entry_.bytes = static_cast<std::uint64_t>(value);
            return true;
        }
        return refuse("a number is not expected");
    }

    Place place_ = Place::outside;
    std::string key_;
    ManifestEntry entry_;
};

}  // namespace

std::string manifest_text(const ManifestEntries& entries, std::span<const int> missing) {
    std::string text = "{\n\"" + std::string(kManifestKey) +
                       "\": " + std::to_string(kManifestVersion) + ",\n\"" + kFilesKey + "\": [";
    const char* separator = "\n";
    for (const auto& [name, entry] : entries) {
        nlohmann::ordered_json line = {{"name", name},         {"frame", entry.frame},
                                       {"time", entry.time},   {"product", entry.product},
                                       {"bytes", entry.bytes}, {"sha256", entry.sha256}};
        if (!entry.pixels_sha256.empty()) line["pixels_sha256"] = entry.pixels_sha256;
        line["recipe"] = entry.recipe;
        if (!entry.subject.empty()) line["subject"] = entry.subject;
        if (!entry.sequence.empty()) line["sequence"] = entry.sequence;
        // JSON cannot hold a name that is not UTF-8: its entry will not be found again.
        text += separator + line.dump(-1, ' ', false, json::error_handler_t::replace);
        separator = ",\n";
    }
    text += "\n]";
    if (!missing.empty()) {
        text += ",\n\"" + std::string(kMissingKey) + "\": " + json(missing).dump();
    }
    return text + "\n}\n";
}

ManifestEntries parse_manifest(std::string_view text) {
    ManifestReader reader;
    const bool whole = json::sax_parse(text.begin(), text.end(), &reader);
    if (!whole || !reader.version_known) {
        throw Error(ErrorKind::bad_file, reader.fault.empty() ? "it has no version" : reader.fault);
    }
    return std::move(reader.entries);
}

}  // namespace ocean
