// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads [waves.measured_record] of a sea file: see measured_record.hpp.
#include "measured_record_reader.hpp"

#include <algorithm>
#include <cmath>

#include "measured_record.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/nearest_name.hpp"

namespace ocean {
namespace {

class RecordReader {
  public:
    RecordReader(const std::string& name, const std::string& path) : name_(name), path_(path) {}

    SpectrumRecord read(const toml::table& table) {
        for (const TomlEntry& entry : in_file_order(table)) {
            const auto key = std::find_if(kRecordKeys.begin(), kRecordKeys.end(),
                                          [&](const RecordKey& k) { return k.key == entry.key; });
            if (key == kRecordKeys.end()) throw unknown(entry);
            key_ = key;
            std::visit([&](auto member) { store(record_.*member, *entry.node); }, key->member);
        }
        const std::string fault = record_fault(record_);
        if (fault.empty()) return std::move(record_);
        throw text::error_at(ErrorKind::invalid_value, name_, line_of(table), path_ + ": " + fault);
    }

  private:
    void store(std::string& value, const toml::node& node) const {
        const auto* text = node.as_string();
        if (text == nullptr || text->get().size() > 200) {
            throw wrong(node, "a text of at most 200 bytes");
        }
        value = text->get();
    }
    void store(std::vector<std::string>& texts, const toml::node& node) const {
        const toml::array* list = node.as_array();
        const auto good = [](const toml::node& item) {
            const auto* text = item.as_string();
            return text != nullptr && text->get().size() <= kMaxRecordWarningBytes;
        };
        if (list == nullptr || list->size() > key_->most ||
            !std::all_of(list->begin(), list->end(), good)) {
            throw wrong(node, "an array of at most " + std::to_string(key_->most) +
                                  " texts of at most " + std::to_string(kMaxRecordWarningBytes) +
                                  " bytes");
        }
        texts.clear();
        for (const toml::node& item : *list) texts.push_back(item.as_string()->get());
    }
    void store(double& value, const toml::node& node) const {
        const std::optional<double> number = number_of(node);
        if (!number || !std::isfinite(*number)) {
            throw wrong(node, "a finite number");
        }
        value = *number;
    }
    void store(std::vector<double>& values, const toml::node& node) const {
        const toml::array* list = node.as_array();
        if (list == nullptr || list->size() > key_->most) {
            throw wrong(node, "an array of at most " + std::to_string(key_->most) + " numbers");
        }
        values.clear();
        for (const toml::node& item : *list) {
            const std::optional<double> number = number_of(item);
            const bool missing = number && std::isnan(*number) && key_->may_be_nan;
            if (!number || !(std::isfinite(*number) || missing)) {
                throw wrong(item,
                            key_->may_be_nan ? "finite numbers, nan = missing" : "finite numbers");
            }
            values.push_back(*number);
        }
    }

    Error wrong(const toml::node& node, const std::string& allowed) const {
        return text::error_at(ErrorKind::invalid_value, name_, line_of(node),
                              path_ + "." + std::string(key_->key) + " = " + shown(node) +
                                  ": is not allowed; allowed: " + allowed);
    }
    Error unknown(const TomlEntry& entry) const {
        return text::error_at(ErrorKind::invalid_value, name_, entry.line,
                              path_ + "." + text::printable(entry.key) + ": no such key" +
                                  did_you_mean(entry.key, kRecordKeys, &RecordKey::key));
    }

    const std::string& name_;
    const std::string& path_;
    const RecordKey* key_ = nullptr;
    SpectrumRecord record_;
};

}  // namespace

SpectrumRecord read_measured_record(const toml::table& table, const std::string& name,
                                    const std::string& path) {
    return RecordReader(name, path).read(table);
}

}  // namespace ocean
