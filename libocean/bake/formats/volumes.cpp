// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// OpenVDB: the water in a box of the world, its surface as a level set and its velocity. All of it
// is asked for at places of the world: there are no maps.
#include "ocean/io/vdb.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "formats/formats.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/checked_text.hpp"
#include "ocean/csv_rows.hpp"
#include "ocean/directional_spectrum.hpp"
#include "ocean/error.hpp"
#include "ocean/io/product_image.hpp"
#include "ocean/ocean.hpp"
#include "ocean/text.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr std::string_view kSurface = "surface";
constexpr std::string_view kVelocity = "vel";
constexpr std::string_view kUsualProducts = "surface,vel";
constexpr std::string_view kCrest = "crest";
constexpr double kFarthest = 1e7;  // m

struct Settings {
    bool surface = false;
    bool velocity = false;
    bool half_floats = false;
    io::Axes axes = io::Axes::zup;
    // Settled before the plan is made; what was not typed is NaN or 0 until then.
    std::optional<std::array<double, 6>> box;  // low and high x, y, z; NaN at the end: the crest
    double voxel = 0.0;                        // m
    double velocity_voxel = 0.0;
    double wave_height = 0.0;  // 4 sqrt(m0), m

    bool to_the_crest() const { return std::isnan(box->back()); }
    std::string products() const {
        std::string names;
        if (surface) names = kSurface;
        if (velocity) names += (names.empty() ? "" : ",") + std::string(kVelocity);
        return names;
    }
    std::string box_text() const {
        std::string text;
        for (const double& side : *box) {
            if (&side != box->data()) text += ',';
            text += std::isnan(side) ? std::string(kCrest) : shortest_text(side);
        }
        return text;
    }
};

const Settings& settings_of(const BakePlan& plan) {
    return std::any_cast<const Settings&>(plan.settings);
}

std::vector<FormatOption> list_options(const Catalogue&) {
    return {{"products", "LIST",
             "Of surface (a level set) and vel (the water's velocity); default " +
                 std::string(kUsualProducts)},
            {"box", "X0,Y0,Z0,X1,Y1,Z1",
             "Of the world, m, z up from still water, Z1 a number or crest; default: one period, "
             "from twice the wave height and at least 4 m below still water, or the bottom, to "
             "the highest crest"},
            {"voxel", "METRES", "Of the surface; default the period / the resolution"},
            {"velocity-voxel", "METRES", "Of the velocity; default twice the voxel"},
            {"type", "TYPE", "float or half; default float"},
            {"axes", "AXES", "zup (x, y, z) or yup (x, z, -y); default zup"}};
}

[[noreturn]] void refuse(const std::string& message) {
    throw Error(ErrorKind::invalid_value, message);
}

/// One more than `limit`, at most.
std::vector<std::string_view> fields_of(const std::string& list, std::size_t limit) {
    return csv::split(list, ',', limit).value_or(std::vector<std::string_view>{});
}

void read_products(const std::string& list, Settings& settings) {
    const std::string text = list.empty() ? std::string(kUsualProducts) : list;
    for (const std::string_view name : fields_of(text, 3)) {
        bool Settings::*const product = name == kSurface    ? &Settings::surface
                                        : name == kVelocity ? &Settings::velocity
                                                            : nullptr;
        if (product == nullptr || settings.*product) {
            refuse("--products " + list + ": of a volume allowed are surface and vel, each once");
        }
        settings.*product = true;
    }
}

std::array<double, 6> read_box(const std::string& text) {
    const std::string what = "--box " + text;
    const std::vector<std::string_view> sides = fields_of(text, 6);
    std::array<double, 6> box{};
    if (sides.size() != box.size()) refuse(what + ": allowed are six numbers, X0,Y0,Z0,X1,Y1,Z1");
    for (std::size_t i = 0; i < box.size(); ++i) {
        const bool is_crest = i + 1 == box.size() && sides[i] == kCrest;
        box[i] = is_crest ? std::nan("") : parse_number(sides[i], what, -kFarthest, kFarthest);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (box[i] >= box[i + 3])
            refuse(what + ": each end is beyond its beginning, or it is empty");
    }
    return box;
}

double read_voxel(const std::string& option, const std::string& text) {
    constexpr double kSmallest = 1e-4;
    return text.empty() ? 0.0
                        : parse_number(text, "--" + option + " " + text, kSmallest, kFarthest);
}

std::any read_options(const BakeOptions& options, const Catalogue&) {
    Settings settings;
    read_products(options.format_option("products"), settings);
    if (const std::string& box = options.format_option("box"); !box.empty()) {
        settings.box = read_box(box);
    }
    settings.voxel = read_voxel("voxel", options.format_option("voxel"));
    settings.velocity_voxel = read_voxel("velocity-voxel", options.format_option("velocity-voxel"));
    if (const std::string& type = options.format_option("type"); !type.empty()) {
        if (type != "float" && type != "half")
            refuse("--type " + type + ": allowed are float, half");
        settings.half_floats = type == "half";
    }
    settings.axes = read_up_axes(options, "a volume");
    return settings;
}

FormatPlan settle(const BakePlan& begun) {
    Settings settings = settings_of(begun);
    const Parameters& parameters = begun.sea.parameters;
    const double variance = make_directional_spectrum(parameters).variance(parameters.water);
    settings.wave_height = 4.0 * std::sqrt(variance);
    if (settings.voxel == 0.0) settings.voxel = parameters.grid.patch_size / begun.resolution;
    if (settings.velocity_voxel == 0.0) settings.velocity_voxel = 2.0 * settings.voxel;
    if (!settings.box) {
        constexpr double kLeastDepth = 4.0;  // m
        const double deep = std::max(kLeastDepth, 2.0 * settings.wave_height);
        settings.box = {0.0,
                        0.0,
                        -std::min(deep, parameters.water.depth),
                        parameters.grid.patch_size,
                        parameters.grid.patch_size,
                        std::nan("")};
    }
    return {{{}, {begun.resolution}}, settings};
}

io::WorldBox world_box(const Settings& settings, double crest) {
    const std::array<double, 6>& side = *settings.box;
    // A level set that ends above the crests: the band is whole.
    const double top = settings.to_the_crest() ? crest : side[5];
    return {{side[0], side[1], side[2]}, {side[3], side[4], std::max(top, side[2] + 1e-3)}};
}

std::vector<BakeFile> list_files(const BakePlan& plan, int frame) {
    return {{plan.pattern.file(frame), frame, 0, settings_of(plan).products()}};
}

std::vector<io::HeaderString> strings_of(const BakePlan& plan, int frame) {
    const Settings& settings = settings_of(plan);
    std::vector<io::HeaderString> strings = io::label_strings(frame_label(plan, frame));
    strings.push_back({"ocean:resolution", std::to_string(plan.resolution)});
    strings.push_back({"ocean:axes", std::string(io::axes_name(settings.axes))});
    strings.push_back({"ocean:field", settings.products()});
    strings.push_back({"ocean:box", settings.box_text()});
    strings.push_back({"ocean:voxel", shortest_text(settings.voxel)});
    strings.push_back({"ocean:velocity_voxel", shortest_text(settings.velocity_voxel)});
    strings.push_back({"ocean:type", settings.half_floats ? "half" : "float"});
    strings.push_back({"ocean:units", "m, m/s"});
    return strings;
}

std::string recipe(const BakePlan& plan, const BakeFile& file) {
    const Settings& settings = settings_of(plan);
    return bake_recipe(plan, file.frame,
                       "vdb " + settings.products() + " " + settings.box_text() + " " +
                           shortest_text(settings.voxel) + " " +
                           shortest_text(settings.velocity_voxel) + " " +
                           (settings.half_floats ? "half " : "float ") +
                           std::string(io::axes_name(settings.axes)) + "\n");
}

bool is_baked(const BakeFile& file) {
    try {
        return !io::read_vdb_header(file.path).empty();
    } catch (const Error&) {
        return false;
    }
}

/// Numbers of all voxels of the box, to crests higher than any that comes.
struct Numbers {
    std::uint64_t surface = 0;
    std::uint64_t velocity = 0;
    std::uint64_t columns = 0;
};

Numbers most_numbers(const BakePlan& plan) {
    const Settings& settings = settings_of(plan);
    const double crest = settings.to_the_crest() ? 2.0 * settings.wave_height : 0.0;
    const io::WorldBox box = world_box(settings, crest);
    constexpr int kLeaf = 8;
    Numbers numbers;
    if (settings.surface) {
        const auto voxels = io::voxels_around(box, settings.voxel, io::kLevelSetBand + kLeaf);
        numbers.surface = voxels.voxels();
        numbers.columns = voxels.columns();
    }
    if (settings.velocity) {
        const auto voxels = io::voxels_around(box, settings.velocity_voxel, kLeaf);
        numbers.velocity = 3 * voxels.voxels();
        numbers.columns = std::max(numbers.columns, voxels.columns());
    }
    return numbers;
}

QueryOptions height_query(const BakePlan& plan) {
    return {.foam = false, .resolution = plan.resolution};
}

/// Waves that the velocity's voxels hold: two of them, at least.
QueryOptions velocity_query(const BakePlan& plan) {
    const double voxel = settings_of(plan).velocity_voxel;
    int resolution = kMinResolution;
    while (2 * resolution <= plan.resolution &&
           2 * resolution * voxel <= plan.sea.parameters.grid.patch_size * (1.0 + 1e-9)) {
        resolution *= 2;
    }
    return {.foam = false, .resolution = resolution};
}

std::uint64_t frame_bytes(const BakePlan& plan) {
    const Numbers numbers = most_numbers(plan);
    constexpr std::uint64_t kOfColumn =
        sizeof(io::SurfaceColumn) + sizeof(float) + 8 * sizeof(io::Velocity);  // a leaf's layers
    const int grid = plan.sea.parameters.grid.resolution;
    // Leaves have a mask too.
    return (numbers.surface + numbers.velocity) * (sizeof(float) + 1) +
           numbers.columns * kOfColumn + SurfaceQuery::map_bytes(grid, height_query(plan)) +
           2 * SurfaceQuery::map_bytes(grid, velocity_query(plan));
}

std::uint64_t most_bytes(const BakePlan& plan, const BakeFile&) {
    const Numbers numbers = most_numbers(plan);
    const std::uint64_t size = settings_of(plan).half_floats ? 2 : sizeof(float);
    return 2 * plan.sea_text.size() + 8192 + (numbers.surface + numbers.velocity) * size;
}

/// Calls take(first, samples) for pieces of the columns.
template <typename Take>
void query_columns(const FrameWork& work, const io::VoxelRange& voxels, const QueryOptions& options,
                   const Take& take) {
    constexpr std::size_t kPiece = 1 << 16;
    const auto width = static_cast<std::size_t>(voxels.count[0]);
    std::vector<WorldPoint> points;
    std::vector<QuerySample> samples;
    for (std::size_t first = 0; first < voxels.columns(); first += kPiece) {
        points.clear();
        for (std::size_t at = first; at < std::min(first + kPiece, voxels.columns()); ++at) {
            points.push_back({voxels.place(0, static_cast<int>(at % width)),
                              voxels.place(1, static_cast<int>(at / width))});
        }
        samples.resize(points.size());
        work.ocean.query(work.time(), points, samples, options);
        take(first, samples);
    }
}

/// Of the columns of a range; folds are counted.
struct Columns {
    std::vector<io::SurfaceColumn> surface;
    double crest = -kFarthest;
    std::size_t folded = 0;
};

Columns columns_of(const FrameWork& work, const io::VoxelRange& voxels) {
    Columns columns{std::vector<io::SurfaceColumn>(voxels.columns())};
    query_columns(work, voxels, height_query(work.plan),
                  [&](std::size_t first, const std::vector<QuerySample>& samples) {
                      for (std::size_t i = 0; i < samples.size(); ++i) {
                          const QuerySample& sample = samples[i];
                          columns.surface[first + i] = {static_cast<float>(sample.height),
                                                        static_cast<float>(sample.normal[2])};
                          columns.crest = std::max(columns.crest, sample.height);
                          columns.folded += sample.folded ? 1 : 0;
                      }
                  });
    return columns;
}

/// The range of a box that ends so many voxels above its crests.
io::VoxelRange range_to(const Settings& settings, double voxel, int beyond, double crest) {
    return io::voxels_around(world_box(settings, crest + io::kLevelSetBand * voxel), voxel, beyond);
}

io::VdbGrid make_surface(const FrameWork& work, io::VolumeAxes axes) {
    const Settings& settings = settings_of(work.plan);
    const Columns columns =
        columns_of(work, range_to(settings, settings.voxel, io::kLevelSetBand, 0.0));
    if (columns.folded > 0) {
        work.warn(format_text(
            "at %g s %zu of %zu columns lie where the crests have folded over: they take the top "
            "sheet",
            work.time(), columns.folded, columns.surface.size()));
    }
    const io::WorldBox box =
        world_box(settings, columns.crest + io::kLevelSetBand * settings.voxel);
    if (columns.crest < box.low[2]) {
        work.warn(
            format_text("at %g s no water reaches the box, and its surface is empty", work.time()));
    }
    return io::make_level_set(box, io::voxels_around(box, settings.voxel, io::kLevelSetBand),
                              columns.surface, axes, work.ocean.pool());
}

io::VdbGrid make_velocity(const FrameWork& work, io::VolumeAxes axes) {
    constexpr int kBeyond = 1;  // so that what is read at the box's sides has voxels around it
    const Settings& settings = settings_of(work.plan);
    const double size = settings.velocity_voxel;
    const Columns columns = columns_of(work, range_to(settings, size, kBeyond, 0.0));
    const io::VoxelRange voxels = range_to(settings, size, kBeyond, columns.crest);
    std::vector<float> heights;
    heights.reserve(columns.surface.size());
    for (const io::SurfaceColumn& column : columns.surface) heights.push_back(column.height);

    const QueryOptions query = velocity_query(work.plan);
    const auto width = static_cast<std::size_t>(voxels.count[0]);
    std::vector<WaterPoint> points(voxels.columns());
    std::vector<WaterMotion> motions(voxels.columns());
    double moved_at = -kFarthest;  // the depth that the motions are of
    const auto layer = [&](int k, std::span<io::Velocity> out) {
        const double z = std::min(size * k, 0.0);  // above still water as at it
        if (z != moved_at) {
            for (std::size_t at = 0; at < points.size(); ++at) {
                points[at] = {voxels.place(0, static_cast<int>(at % width)),
                              voxels.place(1, static_cast<int>(at / width)), z};
            }
            work.ocean.water_motion(work.time(), points, motions, query);
            moved_at = z;
        }
        for (std::size_t at = 0; at < out.size(); ++at) {
            out[at] = {static_cast<float>(motions[at].velocity_x),
                       static_cast<float>(motions[at].velocity_y),
                       static_cast<float>(motions[at].velocity_z)};
        }
    };
    return io::make_velocity(voxels, heights, layer, axes, work.ocean.pool());
}

void write(const FrameWork& work, std::span<const BakeFile> files) {
    const Settings& settings = settings_of(work.plan);
    const io::VolumeAxes axes{settings.axes == io::Axes::yup};
    std::vector<io::VdbGrid> grids;
    if (settings.surface) grids.push_back(make_surface(work, axes));
    if (settings.velocity) grids.push_back(make_velocity(work, axes));
    work.put(files.front(), [&] {
        io::write_vdb(grids, strings_of(work.plan, work.frame), settings.half_floats,
                      files.front().path);
    });
}

void adopt(const BakedHeader& header, const Catalogue&, BakeOptions& options) {
    options.take("products", header.text("field"));
    options.take("axes", header.text("axes"));
    options.take("box", header.text("box"));
    options.take("voxel", header.text("voxel"));
    options.take("velocity-voxel", header.text("velocity_voxel"));
    options.take("type", header.text("type"));
}

}  // namespace

const BakeFormat kVdbFormat = {
    .name = "vdb",
    .extension = ".vdb",
    .family = "Volumes VDB",
    .options = list_options,
    .read_options = read_options,
    .settle = settle,
    .files = list_files,
    .recipe = recipe,
    .is_baked = is_baked,
    .frame_bytes = frame_bytes,
    .most_bytes = most_bytes,
    .write = write,
    .read_header = io::read_vdb_header,
    .adopt = adopt,
};

}  // namespace ocean
