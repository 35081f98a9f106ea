// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claims: a program that was built without a part says so where that part is requested, and names
// the build that has it.

#include "bakes.hpp"

namespace ocean {
namespace {

/// Returns the standard catalogue without .vdb and .tif.
const Catalogue& poor_catalogue() {
    static const std::vector<const BakeFormat*> formats = [] {
        std::vector<const BakeFormat*> some;
        for (const BakeFormat* format : standard_catalogue().formats) {
            if (format->extension != ".vdb" && format->extension != ".tif") some.push_back(format);
        }
        return some;
    }();
    static const Catalogue catalogue = [] {
        Catalogue without = standard_catalogue();
        without.formats = formats;
        return without;
    }();
    return catalogue;
}

std::string refusal(const std::string& output, const test::FormatOptions& format_options = {},
                    const std::string& backend = "") {
    BakeOptions options = test::sea_bake(output, "", format_options);
    options.backend = backend;
    return test::refusal_of(options, poor_catalogue());
}

TEST(AbsentParts, AreNamedByTheExtension) {
    for (const auto& [output, library] :
         {std::pair{"sea.vdb", "OpenVDB"}, std::pair{"sea.tif", "libtiff"}}) {
        const std::string said = refusal(output);
        EXPECT_TRUE(said.starts_with(std::string("-o ") + output +
                                     ": this program was built without " + library +
                                     "; the build of `cmake --preset release` has it"))
            << said;
    }
    EXPECT_EQ(refusal("sea.exr"), "planned");
}

TEST(AbsentParts, AreNamedByTheOptionsOfVolumes) {
    const std::span<const FormatLibrary> libraries = standard_catalogue().libraries;
    const auto volumes = std::ranges::find(libraries, "OpenVDB", &FormatLibrary::library);
    ASSERT_NE(volumes, libraries.end());
    EXPECT_EQ(volumes->options.size(), 4u);
    for (const char* const option : volumes->options) {
        const std::string said = refusal("sea.exr", {{option, "1"}});
        EXPECT_TRUE(said.starts_with("--" + std::string(option) +
                                     " 1: this program was built without OpenVDB; "))
            << said;
    }
}

TEST(AbsentParts, AreNotAmongTheFormatsThatHelpLists) {
    const Catalogue& catalogue = poor_catalogue();
    EXPECT_EQ(catalogue.format_labels(true), "EXR, DF3, PNG, POV-Ray mesh, PLY, OBJ, USD");
    for (const FormatLibrary& one : catalogue.libraries) EXPECT_TRUE(catalogue.lacks(one));
}

TEST(AbsentParts, AreNamedByTheBackend) {
    for (const std::string backend : {"gl", "thesis"}) {
        const std::string said = refusal("sea.exr", {}, backend);
        EXPECT_TRUE(said.starts_with("backend " + backend + " is not in this program, which was"))
            << said;
    }
}

}  // namespace
}  // namespace ocean
