// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Coordinate reference systems as the text of a .prj file. Their definitions are in a database of
// thousands, which the reader of the model has or has not.
#include <algorithm>

#include "ocean/internal/elevation_rules.hpp"
#include "ocean/io/elevation.hpp"
#include "ocean/text.hpp"

namespace ocean::io {
namespace {

std::string local_text(std::string name) {
    std::ranges::replace(name, '"', '\'');
    return "LOCAL_CS[\"" + name + "\",UNIT[\"metre\",1]]";
}

}  // namespace

std::string elevation_projection(const ElevationModel& model) {
    const std::string name = elevation::crs_name(model.crs);
    if (model.was_degrees) {
        return local_text("metres from " + fixed_text(model.geographic_origin[1], 6) + " N, " +
                          fixed_text(model.geographic_origin[0], 6) + " E" +
                          (name.empty() ? "" : " of " + name));
    }
    if (!model.crs_definition.empty()) return model.crs_definition;
    if (name.empty()) return local_text("metres");
    return elevation::is_geographic(model.crs) == false ? model.crs : local_text(name);
}

}  // namespace ocean::io
