// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// A NetCDF file by libnetcdf: see netcdf_file.hpp.
#include "netcdf_file.hpp"

#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string_view>

#include "classic_extent.hpp"
#include "netcdf_layout.hpp"
#include "ocean/internal/line_reader.hpp"
#include "ocean/internal/text.hpp"

namespace ocean::netcdf {
namespace {

void require(int status, const std::string& what) {
    if (status != NC_NOERR)
        throw Fault(what, std::string("the NetCDF library says: ") + nc_strerror(status));
}

class File {
  public:
    explicit File(const std::string& path) {
        const int status = nc_open(path.c_str(), NC_NOWRITE, &id_);
        if (status == NC_NOERR) return;
        throw Fault(std::string("is not a whole NetCDF file: ") + nc_strerror(status));
    }
    ~File() { nc_close(id_); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    int id() const { return id_; }

  private:
    int id_ = -1;
};

/// Throws for a truncated classic file. HDF5 checks its own size.
void require_whole(const File& file, const std::string& path) {
    int format = 0;
    require(nc_inq_format(file.id(), &format), "format");
    if (format == NC_FORMAT_NETCDF4 || format == NC_FORMAT_NETCDF4_CLASSIC) return;
    std::ifstream stream(path, std::ios::binary);
    const std::uint64_t promised = classic_extent(stream);
    const std::uint64_t size = std::filesystem::file_size(path);
    if (size >= promised) return;
    throw Fault("the file is cut off: it has " + std::to_string(size) + " bytes of " +
                std::to_string(promised));
}

/// A variable of the header with its ids in the file.
struct Source {
    int group = 0;  // the file itself is a group
    int id = 0;
    nc_type type = NC_NAT;
    std::vector<std::size_t> dimensions;  // with dimensions of characters
};

/// Reads a text attribute, up to kMaxTextBytes.
constexpr std::size_t kMaxHistoryBytes = 65536;

struct Header {
    Content content;
    std::vector<Source> sources;  // one for each variable
};

std::optional<std::string> text_attribute(int file, int variable, const char* name) {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    if (nc_inq_att(file, variable, name, &type, &length) != NC_NOERR) return std::nullopt;
    if (type == NC_CHAR && length <= kMaxHistoryBytes) {
        std::string text(length, '\0');
        if (nc_get_att_text(file, variable, name, text.data()) != NC_NOERR) return std::nullopt;
        return text.substr(0, std::min(text.find('\0'), kMaxTextBytes));
    }
    char* string = nullptr;
    if (type != NC_STRING || length != 1 ||
        nc_get_att_string(file, variable, name, &string) != NC_NOERR) {
        return std::nullopt;
    }
    std::string text = string != nullptr ? std::string(string).substr(0, kMaxTextBytes) : "";
    nc_free_string(1, &string);
    return text;
}

/// Returns the numbers of an attribute, or an empty list if it does not have a few numbers.
std::vector<double> number_attribute(const Source& source, const char* name) {
    constexpr std::size_t kMaxNumbers = 16;
    nc_type type = NC_NAT;
    std::size_t length = 0;
    const bool found = nc_inq_att(source.group, source.id, name, &type, &length) == NC_NOERR;
    if (!found || type == NC_CHAR || type >= NC_STRING || length == 0 || length > kMaxNumbers)
        return {};
    std::vector<double> numbers(length);
    if (nc_get_att_double(source.group, source.id, name, numbers.data()) != NC_NOERR) return {};
    return numbers;
}

/// Returns the file and its groups, a group before its members.
std::vector<int> groups_of(const File& file) {
    constexpr std::size_t kMaxGroups = 256;
    std::vector<int> groups = {file.id()};
    for (std::size_t i = 0; i < groups.size(); ++i) {
        int count = 0;
        require(nc_inq_grps(groups[i], &count, nullptr), "groups");
        if (groups.size() + static_cast<std::size_t>(count) > kMaxGroups) {
            throw Fault("more than 256 groups");
        }
        std::vector<int> inner(static_cast<std::size_t>(count));
        if (count > 0) require(nc_inq_grps(groups[i], nullptr, inner.data()), "groups");
        groups.insert(groups.end(), inner.begin(), inner.end());
    }
    return groups;
}

/// Appends a group's dimensions to the content, and their ids, which are unique in the file.
void read_dimensions(int group, Content& content, std::vector<int>& numbers) {
    int count = 0;
    require(nc_inq_dimids(group, &count, nullptr, 0), "dimensions");
    if (content.dimensions.size() + static_cast<std::size_t>(count) > kMaxDimensions) {
        throw Fault("more than 1024 dimensions");
    }
    std::vector<int> ids(static_cast<std::size_t>(count));
    if (count > 0) require(nc_inq_dimids(group, nullptr, ids.data(), 0), "dimensions");
    for (const int id : ids) {
        char name[NC_MAX_NAME + 1] = "";
        std::size_t size = 0;
        require(nc_inq_dim(group, id, name, &size), "dimensions");
        content.dimensions.push_back({name, size});
        numbers.push_back(id);
    }
}

/// Finds the dimension of characters, usually the last one, by which classic files represent
/// strings.
void drop_characters(const Content& content, Variable& variable) {
    std::vector<std::size_t>& dimensions = variable.dimensions;
    if (dimensions.empty()) return;
    const auto of_characters = [&](std::size_t dimension) {
        return content.dimensions[dimension].name.find("string") != std::string::npos;
    };
    const std::size_t rank = dimensions.size();
    while (!dimensions.empty() && of_characters(dimensions.back())) dimensions.pop_back();
    if (dimensions.size() < rank) return;
    if (of_characters(dimensions.front())) {
        dimensions.erase(dimensions.begin());
    } else {
        dimensions.pop_back();
    }
}

/// Reads text attributes, and the values of flags as text.
std::map<std::string, std::string> text_attributes(int group, int variable) {
    std::map<std::string, std::string> texts;
    int count = 0;
    require(nc_inq_varnatts(group, variable, &count), "attributes");
    for (int i = 0; i < count && texts.size() < kMaxAttributes; ++i) {
        char name[NC_MAX_NAME + 1] = "";
        if (nc_inq_attname(group, variable, i, name) != NC_NOERR) continue;
        if (auto text = text_attribute(group, variable, name)) {
            texts[name] = *text;
        } else if (std::string_view(name) == "flag_values") {
            texts[name] = joined(number_attribute({group, variable, NC_NAT, {}}, name), " ",
                                 [](double value) { return std::to_string(std::lround(value)); });
        }
    }
    return texts;
}

/// Appends the variables of a group that may be needed, without values.
void read_variables(int group, const std::vector<int>& dimension_ids, Header& header) {
    int count = 0;
    require(nc_inq_nvars(group, &count), "variables");
    if (header.sources.size() + static_cast<std::size_t>(count) > kMaxVariables) {
        throw Fault("more than 1024 variables");
    }
    for (int id = 0; id < count; ++id) {
        char name[NC_MAX_NAME + 1] = "";
        int rank = 0;
        Source source{group, id, NC_NAT, {}};
        require(nc_inq_varndims(group, id, &rank), "variables");
        if (static_cast<std::size_t>(rank) > kMaxVariableDimensions) continue;
        std::vector<int> ids(static_cast<std::size_t>(rank));
        require(nc_inq_var(group, id, name, &source.type, nullptr, ids.data(), nullptr),
                "variables");
        if (source.type > NC_STRING) continue;  // compound and other user types
        for (const int dimension : ids) {
            const auto found = std::find(dimension_ids.begin(), dimension_ids.end(), dimension);
            if (found == dimension_ids.end()) throw Fault(name, "has an unknown dimension");
            source.dimensions.push_back(static_cast<std::size_t>(found - dimension_ids.begin()));
        }
        Variable variable{name, source.dimensions, {}, false, {}, {}};
        variable.is_text = source.type == NC_CHAR || source.type == NC_STRING;
        if (source.type == NC_CHAR) drop_characters(header.content, variable);
        variable.attributes = text_attributes(group, id);
        header.content.variables.push_back(std::move(variable));
        header.sources.push_back(std::move(source));
    }
}

Header read_header(const File& file) {
    Header header;
    std::vector<int> dimension_ids;
    const std::vector<int> groups = groups_of(file);
    for (const int group : groups) read_dimensions(group, header.content, dimension_ids);
    for (const int group : groups) read_variables(group, dimension_ids, header);
    header.content.attributes = text_attributes(file.id(), NC_GLOBAL);
    return header;
}

/// Returns the number of a variable's values. Throws if it exceeds the rest of kMaxValues.
std::size_t checked_size(const Content& content, const std::vector<std::size_t>& dimensions,
                         const std::string& name, std::size_t left) {
    std::size_t size = 1;
    double exact = 1.0;
    for (const std::size_t d : dimensions) {
        exact *= static_cast<double>(content.dimensions[d].size);
        size *= content.dimensions[d].size;
    }
    if (exact <= static_cast<double>(left)) return size;
    const auto size_text = [&](std::size_t d) {
        return std::to_string(content.dimensions[d].size);
    };
    throw Fault(name, "has " + joined(dimensions, " x ", size_text) + " values; at most " +
                          std::to_string(kMaxValues) +
                          " are read of a file: cut it by time or place");
}

/// The values that mean "missing" in the file's own type.
std::vector<double> fill_values(const Source& source) {
    std::vector<double> fills = number_attribute(source, "_FillValue");
    if (fills.empty() && source.type != NC_BYTE && source.type != NC_UBYTE) {
        switch (source.type) {
            case NC_SHORT:
                fills = {NC_FILL_SHORT};
                break;
            case NC_INT:
                fills = {NC_FILL_INT};
                break;
            case NC_FLOAT:
            case NC_DOUBLE:
                fills = {NC_FILL_DOUBLE};
                break;
            default:
                break;
        }
    }
    for (const double more : number_attribute(source, "missing_value")) {
        fills.push_back(more);
    }
    // 1e20 in double precision differs from 1e20 in single precision.
    for (double& fill : fills) {
        const bool single =
            source.type == NC_FLOAT && std::abs(fill) <= double{std::numeric_limits<float>::max()};
        if (single) fill = double{static_cast<float>(fill)};
    }
    return fills;
}

struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool packed = false;  // true: compared before scale and offset are applied
};

/// Reads the valid range. A range in the packed type applies to packed values [CF conventions,
/// section 8.1].
Range valid_range(const Source& source) {
    Range range;
    nc_type type = source.type;
    const auto set = [&](double& limit, const char* name, std::size_t size, std::size_t i) {
        const std::vector<double> numbers = number_attribute(source, name);
        if (numbers.size() != size || std::isnan(numbers[i])) return;
        limit = numbers[i];
        nc_inq_atttype(source.group, source.id, name, &type);
    };
    set(range.low, "valid_min", 1, 0);
    set(range.high, "valid_max", 1, 0);
    set(range.low, "valid_range", 2, 0);
    set(range.high, "valid_range", 2, 1);
    range.packed = type == source.type;
    return range;
}

double factor(const Source& source, const std::string& name, const char* key, double otherwise) {
    const std::vector<double> numbers = number_attribute(source, key);
    if (numbers.empty()) return otherwise;
    if (numbers.size() == 1 && std::isfinite(numbers[0])) return numbers[0];
    throw Fault(name, std::string(key) + " is not a number");
}

void read_values(const Source& source, Variable& variable, std::size_t size) {
    variable.values.resize(size);
    if (size == 0) return;
    require(nc_get_var_double(source.group, source.id, variable.values.data()), variable.name);
    const std::vector<double> fills = fill_values(source);
    const Range valid = valid_range(source);
    const double scale = factor(source, variable.name, "scale_factor", 1.0);
    const double add = factor(source, variable.name, "add_offset", 0.0);
    if (scale == 0.0) throw Fault(variable.name, "scale_factor is 0");
    for (double& value : variable.values) {
        const double packed = value;
        value = scale * packed + add;
        const double ranged = valid.packed ? packed : value;
        const bool missing = std::find(fills.begin(), fills.end(), packed) != fills.end() ||
                             ranged < valid.low || ranged > valid.high;
        if (missing) value = std::numeric_limits<double>::quiet_NaN();
    }
}

/// Returns a text without its padding.
std::string trimmed(std::string text) {
    text.erase(std::min(text.find('\0'), text.size()));
    text.erase(text.find_last_not_of(" \t\r\n") + 1);
    return text;
}

/// Reads `count` texts: `size` characters each, or strings.
void read_texts(const Source& source, Variable& variable, std::size_t size, std::size_t count) {
    variable.texts.resize(count);
    if (size == 0) return;
    if (source.type == NC_STRING) {
        std::vector<char*> strings(size, nullptr);
        require(nc_get_var_string(source.group, source.id, strings.data()), variable.name);
        for (std::size_t i = 0; i < count; ++i) {
            variable.texts[i] = trimmed(strings[i] != nullptr ? strings[i] : "");
        }
        nc_free_string(size, strings.data());
        return;
    }
    std::string bytes(size, '\0');
    require(nc_get_var_text(source.group, source.id, bytes.data()), variable.name);
    const bool characters_first =
        !variable.dimensions.empty() && variable.dimensions[0] != source.dimensions[0];
    const std::size_t length = size / count;
    for (std::size_t i = 0; i < count; ++i) {
        std::string text;
        for (std::size_t k = 0; k < length; ++k) {
            text += bytes[characters_first ? k * count + i : i * length + k];
        }
        variable.texts[i] = trimmed(std::move(text));
    }
}

}  // namespace

Content read_file(const std::string& path) {
    const File file(path);
    require_whole(file, path);
    Header header = read_header(file);
    Content& content = header.content;
    std::size_t left = kMaxValues;
    std::vector<Variable> needed;
    for (const std::size_t i : find_layout(content).variables()) {
        Variable& variable = content.variables[i];
        const Source& source = header.sources[i];
        const std::size_t size = checked_size(content, source.dimensions, variable.name, left);
        left -= size;
        if (variable.is_text) {
            const std::size_t count =
                checked_size(content, variable.dimensions, variable.name, kMaxValues);
            read_texts(source, variable, size, count);
        } else {
            read_values(source, variable, size);
        }
        needed.push_back(std::move(variable));
    }
    content.variables = std::move(needed);
    return std::move(content);
}

}  // namespace ocean::netcdf
