// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "ocean/error.hpp"

namespace ocean {
namespace {

std::string sentence_of(const ErrorFields& fields) {
    std::string sentence = fields.parameter;
    if (!fields.value.empty()) sentence += (sentence.empty() ? "" : " = ") + fields.value;
    if (!fields.what.empty()) sentence += (sentence.empty() ? "" : ": ") + fields.what;
    if (!fields.allowed.empty()) sentence += "; allowed: " + fields.allowed;
    return sentence;
}

}  // namespace

Error::Error(ErrorKind kind, ErrorFields fields)
    : std::runtime_error(sentence_of(fields)), kind_(kind), fields_(std::move(fields)) {}

}  // namespace ocean
