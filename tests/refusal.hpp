// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Errors of the library as values.
#pragma once

#include "ocean/error.hpp"
#include "testing.hpp"

namespace ocean::test {

struct Refusal {
    bool refused = false;
    ErrorKind kind = ErrorKind::interrupted;
    std::string message;
    ErrorFields fields{};
    /// Returns whether the sentence has all these words; a failed expectation shows it.
    template <typename... Words>
    testing::AssertionResult says(const Words&... words) const {
        const bool all = ((message.find(words) != std::string::npos) && ...);
        return (all ? testing::AssertionSuccess() : testing::AssertionFailure()) << message;
    }
};

/// Returns the error that an action throws, or none.
template <typename Action>
Refusal refusal_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return {true, error.kind(), error.what(), error.fields()};
    }
    return {};
}

/// Returns the sentence of that error, or "".
template <typename Action>
std::string message_of(const Action& action) {
    return refusal_of(action).message;
}

/// The same of an action whose errors are all of one kind.
template <typename Action>
std::string message_of(ErrorKind kind, const Action& action) {
    const Refusal refusal = refusal_of(action);
    EXPECT_TRUE(!refusal.refused || refusal.kind == kind) << refusal.message;
    return refusal.message;
}

/// Expects that an action is refused with these words.
template <typename Action>
void expect_refusal(ErrorKind kind, std::string_view words, const Action& action) {
    const Refusal refusal = refusal_of(action);
    ASSERT_TRUE(refusal.refused) << "was accepted";
    EXPECT_EQ(refusal.kind, kind);
    EXPECT_TRUE(refusal.says(words)) << "has not: " << words;
}

}  // namespace ocean::test
