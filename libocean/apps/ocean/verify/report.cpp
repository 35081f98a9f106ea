// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
#include "report.hpp"

#include <algorithm>

#include "ocean/internal/json.hpp"
#include "svg_plot.hpp"
#include "text.hpp"

namespace ocean::app {
namespace {

using verify::Kind;
using verify::Row;
using verify::Verdict;

std::string number(double value) {
    return significant_text(value, 6);
}

std::string with_unit(const std::string& text, const Row& row) {
    return row.unit.empty() ? text : text + " " + row.unit;
}

std::string_view kind_name(Kind kind) {
    return kind == Kind::equations ? "equations" : "physics";
}

constexpr char kStyle[] = R"(
:root{color-scheme:light}
body{margin:0;background:#fff;color:#1c2a33;font:16px/1.5 system-ui,sans-serif}
main{max-width:70rem;margin:0 auto;padding:1rem}
h1{line-height:1.2}h2{margin-top:2.5rem;border-bottom:1px solid #c9d3da}
a{color:#0b5a8a}nav a{display:inline-block;margin:.3rem 1rem .3rem 0}small{display:block;color:#4a5b66}
table{border-collapse:collapse;width:100%}
th,td{text-align:left;vertical-align:top;padding:.45rem .6rem;border-bottom:1px solid #dde4e8}
td{overflow-wrap:anywhere}
.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}
.pass{color:#17633a}.fail{color:#a3160f;font-weight:bold}.shortfall,.not-run{color:#7a4a00}
tr:target{background:#fff6d6}
dl{display:grid;grid-template-columns:max-content 1fr;gap:.1rem 1rem}dt{color:#4a5b66}dd{margin:0}
.plots{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,22rem),1fr));gap:1rem}
figure{margin:1rem 0 0}figcaption{font-size:.9rem}svg{width:100%;height:auto}
.grid{stroke:#e2e8ec}.tick{font:12px system-ui,sans-serif;fill:#36454f}
.middle{text-anchor:middle}.end{text-anchor:end}
.curve{fill:none;stroke:#5b6b7a;stroke-width:2}.bar{stroke:#b23a1e}.measured{fill:#b23a1e}
@media(max-width:44rem){thead{position:absolute;left:-99rem}tr{display:block;padding:.5rem 0;
border-bottom:1px solid #c9d3da}td{display:block;border:0;padding:.1rem 0}
.n{text-align:left}td[data-label]:before{content:attr(data-label) ": ";color:#4a5b66}}
)";

std::string cell(const char* title, const std::string& text) {
    return format_text("<td class=\"n\" data-label=\"%s\">", title) + html_text(text) + "</td>";
}

std::string html_row(const Row& row) {
    std::string look(verify::verdict_name(row.verdict()));
    std::string html = "<tr id=\"" + row.id + "\"><td><strong>" + html_text(row.claim) +
                       "</strong><small>" + html_text(row.reference) + "</small><small>" +
                       std::string(kind_name(row.kind)) + "; " + html_text(row.method) +
                       (row.bound.empty() ? "" : "; tolerance: " + html_text(row.bound)) +
                       "</small>";
    if (!row.shortfall.empty()) html += "<small>" + html_text(row.shortfall) + "</small>";
    html += "</td>";
    if (row.verdict() == Verdict::not_run) {
        html += "<td colspan=\"4\">" + html_text(row.not_run) + "</td>";
    } else {
        html += cell("expected", with_unit(number(row.expected), row)) +
                cell("measured", number(row.measured)) +
                cell("tolerance", significant_text(row.tolerance, 2)) +
                cell("digits", fixed_text(row.digits(), 1));
    }
    const std::string text = look;
    std::ranges::replace(look, ' ', '-');
    return html + "<td class=\"" + look + "\" data-label=\"verdict\">" + text + "</td></tr>\n";
}

std::string group_of(const Row& row) {
    return row.id.substr(0, row.id.find('.'));
}

std::string html_group(const verify::Group& group, std::span<const Row> rows) {
    std::string table, plots;
    for (const Row& row : rows) {
        if (group_of(row) != group.name) continue;
        table += html_row(row);
        if (row.plot.measured.empty()) continue;
        plots += "<figure>" + svg_plot(row.plot) + "<figcaption>" + html_text(row.plot.title) +
                 "</figcaption></figure>\n";
    }
    if (table.empty()) return "";
    const std::string title = html_text(group.title);
    return "<section><h2 id=\"" + std::string(group.name) + "\">" + title +
           "</h2>\n<table><thead><tr><th scope=\"col\">case</th><th scope=\"col\" class=\"n\">"
           "expected</th><th scope=\"col\" class=\"n\">measured</th><th scope=\"col\" class=\"n\">"
           "tolerance</th><th scope=\"col\" class=\"n\">digits</th><th scope=\"col\">verdict</th>"
           "</tr></thead><tbody>\n" +
           table + "</tbody></table>\n<div class=\"plots\">" + plots + "</div></section>\n";
}

/// Returns a heading and a list of the rows of one verdict.
std::string html_list(const char* title, Verdict verdict, std::span<const Row> rows) {
    std::string items;
    for (const Row& row : rows) {
        if (row.verdict() != verdict) continue;
        items +=
            "<li><a href=\"#" + row.id + "\">" + html_text(row.claim) + "</a>: " +
            html_text(verdict == Verdict::not_run
                          ? row.not_run
                          : number(row.measured) + " for " + with_unit(number(row.expected), row) +
                                " within " + significant_text(row.tolerance, 2) +
                                (row.shortfall.empty() ? "" : "; " + row.shortfall)) +
            "</li>\n";
    }
    return std::string("<h2>") + title + "</h2>\n" +
           (items.empty() ? "<p>None.</p>\n" : "<ul>\n" + items + "</ul>\n");
}

std::string kind_counts(std::span<const Row> rows) {
    std::string text;
    for (const Kind kind : {Kind::equations, Kind::physics}) {
        const auto is_kind = [&](const Row& row) {
            return row.kind == kind && row.verdict() != Verdict::not_run;
        };
        const auto passes = [&](const Row& row) {
            return is_kind(row) && row.verdict() == Verdict::pass;
        };
        text +=
            format_text("<dt>%s</dt><dd>%td of %td pass</dd>\n",
                        kind == Kind::equations ? "The equations are solved"
                                                : "The physics is that of measurements",
                        std::ranges::count_if(rows, passes), std::ranges::count_if(rows, is_kind));
    }
    return text;
}

Json points_json(const std::vector<verify::Point>& points) {
    return json_array(points, [](const verify::Point& point) {
        return JsonArray()
            .add(Json(point.x, significant<6>))
            .add(Json(point.y, significant<6>))
            .add(Json(point.error, significant<3>));
    });
}

JsonObject row_json(const Row& row) {
    JsonObject json;
    json.add("id", row.id)
        .add("group", group_of(row))
        .add("claim", row.claim)
        .add("kind", kind_name(row.kind))
        .add("reference", row.reference)
        .add("method", row.method)
        .add("verdict", verify::verdict_name(row.verdict()));
    if (!row.not_run.empty()) return json.add("reason", row.not_run);
    json.add("unit", row.unit)
        .add("expected", json_number_or_null(row.expected, significant<6>))
        .add("measured", json_number_or_null(row.measured, significant<6>))
        .add("tolerance", Json(row.tolerance, significant<3>))
        .add("bound", row.bound)
        .add("digits", Json(row.digits(), decimals<1>));
    if (!row.shortfall.empty()) json.add("shortfall", row.shortfall);
    if (row.plot.measured.empty()) return json;
    return json.add("plot", JsonObject()
                                .add("title", row.plot.title)
                                .add("x", row.plot.x_label)
                                .add("y", row.plot.y_label)
                                .add("curve", points_json(row.plot.curve))
                                .add("measured", points_json(row.plot.measured)));
}

}  // namespace

std::ptrdiff_t VerifyReport::count(Verdict verdict) const {
    return std::ranges::count(rows, verdict, &Row::verdict);
}

std::string VerifyReport::summary() const {
    std::string text = format_text("%td of %zu cases pass", count(Verdict::pass), rows.size());
    for (const Verdict verdict : {Verdict::fail, Verdict::shortfall, Verdict::not_run}) {
        if (count(verdict) == 0) continue;
        text += format_text(", %s: %td", std::string(verify::verdict_name(verdict)).c_str(),
                            count(verdict));
    }
    return text;
}

std::string row_line(const Row& row) {
    const std::string head = format_text(
        "%-9s %-34s ", std::string(verify::verdict_name(row.verdict())).c_str(), row.id.c_str());
    if (row.verdict() == Verdict::not_run) return head + row.not_run;
    return head + number(row.measured) + " for " + with_unit(number(row.expected), row) + " +- " +
           significant_text(row.tolerance, 2) + ", " + fixed_text(row.digits(), 1) + " digits";
}

std::string VerifyReport::json() const {
    const verify::Build build = verify::this_build();
    JsonArray list(JsonLines{2});
    for (const Row& row : rows) list.add(row_json(row));
    JsonObject counts;
    for (const Verdict verdict :
         {Verdict::pass, Verdict::fail, Verdict::shortfall, Verdict::not_run}) {
        counts.add(verify::verdict_name(verdict), count(verdict));
    }
    JsonObject json;
    json.add("version", build.version)
        .add("compiler", build.compiler)
        .add("system", build.system)
        .add("processor", build.processor)
        .add("cores", build.cores)
        .add("instruction_set", build.instruction_set);
    if (!subject.empty()) json.add("sea", subject);
    return json.add("counts", counts)
               .add("not_modelled", json_array(verify::not_modelled()))
               .add("rows", list)
               .text() +
           "\n";
}

std::string VerifyReport::html() const {
    const verify::Build build = verify::this_build();
    const std::string title = "Verification of libocean " + build.version;
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>" +
        title + "</title>\n<style>" + kStyle + "</style></head><body><main>\n<h1>" + title +
        "</h1>\n<p><strong>" + summary() +
        ".</strong> A case passes if what is measured differs from what is expected by at most "
        "the tolerance, which holds for the stated resolution. Digits of agreement are -log10 of "
        "the relative error, of the error itself where 0 is expected.</p>\n<dl>\n" +
        kind_counts(rows);
    const std::pair<const char*, std::string> facts[] = {
        {"Sea", subject},
        {"Processor", build.processor + format_text(", %d cores", build.cores)},
        {"Instruction set", build.instruction_set},
        {"System", build.system},
        {"Compiler", build.compiler}};
    for (const auto& [name, value] : facts) {
        if (value.empty()) continue;
        html += format_text("<dt>%s</dt><dd>", name) + html_text(value) + "</dd>\n";
    }
    html += "</dl>\n<nav>";
    for (const verify::Group& group : verify::groups()) {
        const auto is_here = [&](const Row& row) { return group_of(row) == group.name; };
        if (std::ranges::none_of(rows, is_here)) continue;
        html += "<a href=\"#" + std::string(group.name) + "\">" + html_text(group.title) + "</a> ";
    }
    html += "</nav>\n" + html_list("What fails", Verdict::fail, rows) +
            html_list("What is outside its tolerance, as the documentation says",
                      Verdict::shortfall, rows) +
            html_list("What did not run", Verdict::not_run, rows) +
            "<h2>What is not modelled</h2>\n<ul>\n";
    for (const std::string_view sentence : verify::not_modelled()) {
        html += "<li>" + html_text(sentence) + "</li>\n";
    }
    html += "</ul>\n";
    for (const verify::Group& group : verify::groups()) html += html_group(group, rows);
    return html + "</main></body></html>\n";
}

}  // namespace ocean::app
