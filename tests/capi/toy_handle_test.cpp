// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claim: a subject that the library does not know, a tilted plane, has a C handle as seas and
// terrains have, by the templates alone: what toy_handle.cpp does not write works and refuses.
#include "toy_handle.hpp"

#include "temporary_folder.hpp"
#include "testing.hpp"

namespace {

using Plane = std::unique_ptr<toy_plane, void (*)(toy_plane*)>;

Plane parse(const std::string& toml) {
    toy_plane* plane = nullptr;
    EXPECT_EQ(toy_parse(toml.data(), toml.size(), nullptr, nullptr, &plane), OCEAN_OK)
        << toy_last_error();
    return {plane, toy_free};
}

/// Returns the text of a function of libocean.h's kind: the size first, then as many bytes.
template <typename Write>
std::string text_of(const Write& write) {
    size_t size = 0;
    EXPECT_EQ(write(nullptr, &size), OCEAN_OK) << toy_last_error();
    std::string text(size, '\0');
    EXPECT_EQ(write(text.data(), &size), OCEAN_OK);
    text.resize(size - 1);
    return text;
}

std::string file_of(const Plane& plane) {
    return text_of([&](char* out, size_t* size) { return toy_text(plane.get(), out, size); });
}

std::string value_of(const Plane& plane, const char* name) {
    char out[32] = "";
    EXPECT_EQ(toy_get(plane.get(), name, out, sizeof(out)), OCEAN_OK) << toy_last_error();
    return out;
}

const std::string kFile = "libocean = 1\n\n[plane]\nslope = 2.0\nbase = -1.0\n";

TEST(ToyHandle, IsOpenedFromTextFileAndPresetAndToldAsText) {
    EXPECT_EQ(file_of(parse(kFile)), kFile);
    const ocean::test::TemporaryFolder folder;
    const std::string path = folder.file("hill.toml");
    std::ofstream(path) << kFile;
    toy_plane* opened = nullptr;
    ASSERT_EQ(toy_open(path.c_str(), nullptr, &opened), OCEAN_OK) << toy_last_error();
    EXPECT_EQ(file_of({opened, toy_free}), kFile);
    const auto preset = [](const char* name) {
        return text_of([&](char* out, size_t* size) { return toy_preset(name, out, size); });
    };
    EXPECT_EQ(preset(nullptr), "[\"level\"]");
    EXPECT_EQ(value_of(parse(preset("level")), "slope"), "0");
    EXPECT_NE(text_of(toy_parameters_json).find("\"Rise per metre.\""), std::string::npos);
}

TEST(ToyHandle, ItsParametersAreSetAndReadAndACloneKeepsItsOwn) {
    const Plane plane = parse(kFile);
    toy_plane* copied = nullptr;
    ASSERT_EQ(toy_clone(plane.get(), nullptr, &copied), OCEAN_OK);
    const Plane clone(copied, toy_free);
    EXPECT_EQ(toy_set(plane.get(), "plane.slope", "0.25"), OCEAN_OK);
    EXPECT_EQ(value_of(plane, "slope"), "0.25");
    EXPECT_EQ(value_of(clone, "slope"), "2");
    const char* const names[] = {"slope", "base"};
    const char* const values[] = {"-3", "4"};
    EXPECT_EQ(toy_set_all(plane.get(), names, values, 2), OCEAN_OK) << toy_last_error();
    EXPECT_EQ(
        text_of([&](char* out, size_t* size) { return toy_state_json(plane.get(), out, size); }),
        "{\"slope\": -3}");
}

TEST(ToyHandle, ARefusedChangeLeavesItAndNamesThePart) {
    const Plane plane = parse(kFile);
    EXPECT_EQ(toy_set(plane.get(), "slope", "20"), OCEAN_INVALID_VALUE);
    EXPECT_STREQ(toy_last_error_field(OCEAN_ERROR_PARAMETER), "plane.slope");
    EXPECT_EQ(toy_set(plane.get(), "slop", "2"), OCEAN_INVALID_VALUE);
    const char* const names[] = {"slope", "base"};
    const char* const values[] = {"1", "1"};
    EXPECT_EQ(toy_set_all(plane.get(), names, values, 2), OCEAN_INVALID_VALUE);
    EXPECT_EQ(file_of(plane), kFile);
    toy_plane* none = nullptr;
    EXPECT_EQ(toy_parse("[plane]\n", 8, nullptr, nullptr, &none), OCEAN_BAD_FILE);
    EXPECT_EQ(none, nullptr);
    EXPECT_EQ(toy_set(nullptr, "slope", "2"), OCEAN_INVALID_ARGUMENT);
    EXPECT_STREQ(toy_last_error(), "plane is NULL");
    size_t size = 3;
    char out[3];
    EXPECT_EQ(toy_text(plane.get(), out, &size), OCEAN_BUFFER_TOO_SMALL);
}

TEST(ToyHandle, ItAnswersQueriesOfPoints) {
    const Plane plane = parse(kFile);
    const double xy[] = {3.0, 7.0, -1.0, 0.0};
    ocean_sample samples[2];
    ocean_query_request request{};
    request.struct_size = sizeof(request);
    request.xy = xy;
    request.count = 2;
    request.samples = samples;
    request.sample_size = sizeof(samples[0]);
    ASSERT_EQ(toy_query_points(plane.get(), &request), OCEAN_OK) << toy_last_error();
    EXPECT_EQ(samples[0].height, 5.0f);
    EXPECT_EQ(samples[1].height, -3.0f);
}

}  // namespace
