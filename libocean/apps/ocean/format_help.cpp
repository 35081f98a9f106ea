// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// See format_help.hpp.
#include "format_help.hpp"

#include <algorithm>
#include <string_view>

#include "help_text.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::app {
namespace {

std::string names_of_channels(const Product& product, const Catalogue& catalogue) {
    std::string names;
    for (std::size_t i = 0; i < static_cast<std::size_t>(product.count); ++i) {
        const ChannelInfo& info = channel_info(product.channels[i], catalogue.channels);
        names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
    return names;
}

/// Returns "Offset of the displaced point from its label [m]: dx, dy, height".
HelpRow product_row(const Product& product, const Catalogue& catalogue) {
    std::string text(product.help);
    if (!product.unit.empty()) text += " [" + std::string(product.unit) + "]";
    const std::string channels = product.count > 1 ? names_of_channels(product, catalogue) : "";
    if (!channels.empty()) text += (text.empty() ? "" : ": ") + channels;
    return {std::string(product.name), text};
}

HelpSection products_of(const ProductChoice& choice, const Catalogue& catalogue) {
    HelpSection section{"Products of --products", {}};
    const std::vector<std::string> allowed = split(choice.allowed, ',');
    for (const Product& product : choice.known) {
        const bool is_allowed =
            choice.allowed.empty() || std::ranges::find(allowed, product.name) != allowed.end();
        if (is_allowed) section.rows.push_back(product_row(product, catalogue));
    }
    if (!choice.nothing.empty()) {
        section.rows.push_back({std::string(choice.nothing), "None of them, vertices only"});
    }
    if (choice.alone != nullptr) section.rows.push_back(product_row(*choice.alone, catalogue));
    return section;
}

HelpRow option_row(const FormatOption& option) {
    std::string text = option.help;
    if (!option.needs.empty()) text += "; needs --" + option.needs;
    return {"--" + option.name + (option.value.empty() ? "" : " " + option.value), text};
}

/// Returns the command line of an example, on two lines if it is long.
HelpRow example_of(const BakeFormat& format, const std::string& output) {
    std::string line = format.holds_displaced
                           ? "ocean bake preset:beaufort_5 -o " + output + " --frames 1-24"
                           : "ocean terrain preset:tujunga -o " + output;
    const std::string more(format.example);
    constexpr std::size_t kIndent = 4;
    const bool is_long = kIndent + line.size() + more.size() + 1 > kHelpColumns;
    if (!more.empty()) line += (is_long ? " \\\n    " : " ") + more;
    return {line, ""};
}

HelpPage page_of(const BakeFormat& format, const Catalogue& catalogue) {
    const std::string extension(format.extension);
    const bool is_of_seas = format.holds_displaced;
    const std::string output = (is_of_seas ? "out/sea.####" : "hills") + extension;
    const std::string command = is_of_seas ? "ocean bake" : "ocean terrain";
    HelpPage page{
        .names = {std::string(format.name)},
        .summary = format_text("%-5s  ", extension.c_str()) + std::string(format.summary),
        .title = std::string(format.summary),
        .usage = command + (is_of_seas ? " SEA" : " TERRAIN") + " -o " + output + " [OPTIONS]",
        .sections = {}};
    if (extension.substr(1) != format.name) page.names.push_back(extension.substr(1));
    page.names.push_back(extension);
    if (const auto choice = format.product_choice(catalogue)) {
        page.sections.push_back(products_of(*choice, catalogue));
    }
    HelpSection options{"Options of this format", {}};
    for (const FormatOption& option : format.options(catalogue)) {
        options.rows.push_back(option_row(option));
    }
    if (options.rows.empty()) options.rows.push_back({"It has none of its own.", ""});
    page.sections.push_back(std::move(options));
    page.sections.push_back({"Example", {example_of(format, output)}});
    page.sections.push_back({"Options of all formats", {{"See `" + command + " --help`.", ""}}});
    return page;
}

}  // namespace

std::vector<HelpPage> format_pages(const Catalogue& catalogue) {
    std::vector<HelpPage> pages;
    for (const BakeFormat* format : catalogue.formats) pages.push_back(page_of(*format, catalogue));
    return pages;
}

std::string option_overview(const std::string& name, const Catalogue& catalogue) {
    std::vector<std::string> homes;
    std::string help;
    bool differs = false;
    for (const BakeFormat* format : catalogue.formats) {
        for (const FormatOption& option : format->options(catalogue)) {
            if (option.name != name) continue;
            differs = differs || (!help.empty() && help != option.help);
            help = option.help;
            homes.emplace_back(format->name);
        }
    }
    const std::string names = joined(homes, ", ");
    if (differs) return "Differs: see the help of " + names;
    return homes.size() > 1 ? help + " (" + names + ")" : help;
}

}  // namespace ocean::app
