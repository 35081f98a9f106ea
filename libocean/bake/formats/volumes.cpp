// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Volumes of a frame; see volumes.hpp. All of it is asked for at places of the world: there are no
// maps.
#include "formats/volumes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "formats/formats.hpp"
#include "formats/spray_points.hpp"
#include "ocean/bake/plan.hpp"
#include "ocean/error.hpp"
#include "ocean/internal/checked_text.hpp"
#include "ocean/internal/csv_rows.hpp"
#include "ocean/internal/memory.hpp"
#include "ocean/io/product_image.hpp"
#include "ocean/sea_subject.hpp"
#include "ocean/text.hpp"
#include "source.hpp"

namespace ocean {
namespace {

constexpr Product kVolumeProducts[] = {{"surface", {}, 0, "m"},
                                       {"vel", {}, 0, "m/s", true, kSeaKind},
                                       {"density", {}, 0, "1/m", false, kSeaKind}};
constexpr const Product& kSurface = kVolumeProducts[0];
constexpr const Product& kVelocity = kVolumeProducts[1];
constexpr const Product& kDensity = kVolumeProducts[2];
constexpr std::string_view kUsualProducts = "surface,vel";  // without vel where no water moves
constexpr std::string_view kCrest = "crest";
constexpr double kFarthest = 1e7;  // m

struct Settings {
    bool usual = false;  // nobody asked for products
    bool surface = false;
    bool velocity = false;
    bool density = false;
    bool half_floats = false;
    io::Axes axes = io::Axes::zup;
    // Settled before the plan is made; what was not typed is NaN or 0 until then.
    std::optional<std::array<double, 6>> box;  // low and high x, y, z; NaN at the end: the crest
    double voxel = 0.0;                        // m
    double velocity_voxel = 0.0;
    HeightRange heights;  // of the subject
    /// m^2 of cross-section for each m^2 that turns white: a strong gale leaves 3 km of sight.
    double mist = 0.05;
    SpraySettings spray;  // whose births the mist is of

    bool to_the_crest() const { return std::isnan(box->back()); }
    std::vector<const Product*> product_rows() const {
        std::vector<const Product*> rows;
        if (surface) rows.push_back(&kSurface);
        if (velocity) rows.push_back(&kVelocity);
        if (density) rows.push_back(&kDensity);
        return rows;
    }
    std::string products() const {
        std::string names;
        for (const Product* product : product_rows()) {
            names += (names.empty() ? "" : ",") + std::string(product->name);
        }
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

}  // namespace

std::vector<FormatOption> volume_options() {
    return {
        {"products", "LIST",
         "Of surface (a level set), vel (the water's velocity) and density (mist of spray); "
         "default " +
             std::string(kUsualProducts) + std::string(kSprayProductHelp)},
        {"box", "X0,Y0,Z0,X1,Y1,Z1",
         "Of the world, m, z up from still water, Z1 a number or crest; default: one period, "
         "from twice the wave height and at least 4 m below still water, or the bottom, to "
         "the highest crest"},
        {"voxel", "METRES", "Of the surface; default the period / the resolution"},
        {"velocity-voxel", "METRES", "Of the velocity and the density; default twice the voxel"},
        {"mist", "NUMBER",
         "Of the density: m^2 of cross-section for each m^2 that turns white, 0 to 1000; "
         "default " +
             shortest_text(Settings{}.mist)},
        {"type", "TYPE", "float or half; default float"},
        {"axes", "AXES", "zup (x, y, z) or yup (x, z, -y); default zup"}};
}

namespace {

[[noreturn]] void refuse(const std::string& message) {
    throw Error(ErrorKind::invalid_value, message);
}

/// One more than `limit`, at most.
std::vector<std::string_view> fields_of(const std::string& list, std::size_t limit) {
    return csv::split(list, ',', limit).value_or(std::vector<std::string_view>{});
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

}  // namespace

ProductChoice volume_choice() {
    return {.known = kVolumeProducts,
            .usual = kUsualProducts,
            .one_refusal = "of a volume allowed are surface, vel and density, each once"};
}

std::any read_volumes(const BakeOptions& options, const ChosenProducts& chosen) {
    Settings settings;
    settings.usual = chosen.usual;
    settings.surface = chosen.has(kSurface);
    settings.velocity = chosen.has(kVelocity);
    settings.density = chosen.has(kDensity);
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
    const std::string& mist = options.format_option("mist");
    if (settings.density) {
        settings.spray = read_spray_settings(options);
        if (!mist.empty()) settings.mist = parse_number(mist, "--mist " + mist, 0.0, 1000.0);
    } else {
        refuse_spray_options(options, "spray or density");
        if (!mist.empty()) refuse("--mist " + mist + ": needs --products density");
    }
    return settings;
}

std::vector<const Product*> volume_products(const BakePlan& begun) {
    const Settings& settings = settings_of(begun);
    return settings.usual ? std::vector{&kSurface} : settings.product_rows();
}

FormatPlan settle_volumes(const BakePlan& begun) {
    Settings settings = settings_of(begun);
    if (settings.usual && begun.subject->kind() != kVelocity.subject) settings.velocity = false;
    const Domain domain = begun.subject->domain(begun.resolution);
    settings.heights = begun.subject->height_range();
    if (settings.voxel == 0.0) settings.voxel = domain.step(0);
    if (settings.velocity_voxel == 0.0) settings.velocity_voxel = 2.0 * settings.voxel;
    if (!settings.box) {
        settings.box = {domain.origin[0],
                        domain.origin[1],
                        settings.heights.bottom,
                        domain.origin[0] + domain.size[0],
                        domain.origin[1] + domain.size[1],
                        std::nan("")};
    }
    FrameMaps maps{{}, {begun.resolution}};
    maps.has_past = settings.density;
    return {maps, settings};
}

namespace {

io::WorldBox world_box(const Settings& settings, double crest) {
    const std::array<double, 6>& side = *settings.box;
    // A level set that ends above the crests: the band is whole.
    const double top = settings.to_the_crest() ? crest : side[5];
    return {{side[0], side[1], side[2]}, {side[3], side[4], std::max(top, side[2] + 1e-3)}};
}

}  // namespace

std::vector<BakeFile> list_volumes(const BakePlan& plan, int frame) {
    return {{plan.pattern.file(frame), frame, 0, settings_of(plan).products()}};
}

std::vector<io::HeaderString> volume_strings(const BakePlan& plan, int frame) {
    const Settings& settings = settings_of(plan);
    std::vector<io::HeaderString> strings = io::provenance_strings(provenance_of(plan, frame));
    strings.push_back({"ocean:resolution", std::to_string(plan.resolution)});
    strings.push_back({"ocean:axes", std::string(io::axes_name(settings.axes))});
    strings.push_back({"ocean:field", settings.products()});
    strings.push_back({"ocean:box", settings.box_text()});
    strings.push_back({"ocean:voxel", shortest_text(settings.voxel)});
    strings.push_back({"ocean:velocity_voxel", shortest_text(settings.velocity_voxel)});
    strings.push_back({"ocean:type", settings.half_floats ? "half" : "float"});
    if (settings.density) {
        strings.push_back({"ocean:mist", shortest_text(settings.mist)});
        for (auto& string : spray_setting_strings(settings.spray)) {
            strings.push_back(std::move(string));
        }
    }
    strings.push_back({"ocean:units", settings.density ? "m, m/s, 1/m" : "m, m/s"});
    return strings;
}

std::string volume_recipe(const BakePlan& plan, const BakeFile& file) {
    const Settings& settings = settings_of(plan);
    std::string lines =
        "vdb " + settings.products() + " " + settings.box_text() + " " +
        shortest_text(settings.voxel) + " " + shortest_text(settings.velocity_voxel) + " " +
        (settings.half_floats ? "half " : "float ") + std::string(io::axes_name(settings.axes));
    if (settings.density) {
        lines += " " + shortest_text(settings.mist);
        for (const auto& string : spray_setting_strings(settings.spray)) lines += " " + string.text;
    }
    return bake_recipe(plan, file.frame, lines + "\n");
}

namespace {

/// Numbers of all voxels of the box, to crests higher than any that comes.
struct Numbers {
    std::uint64_t surface = 0;
    std::uint64_t velocity = 0;
    std::uint64_t density = 0;
    std::uint64_t columns = 0;
    std::uint64_t puffs = 0;

    std::uint64_t voxels() const { return surface + velocity + density; }
};

Numbers most_numbers(const BakePlan& plan) {
    const Settings& settings = settings_of(plan);
    const double crest = settings.to_the_crest() ? settings.heights.top : 0.0;
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
    if (settings.density) {
        constexpr double kUpwards = 5.0;  // m/s, and as much is spread
        const double reach = 2.0 * kUpwards * settings.spray.lifetime;
        const auto voxels =
            io::voxels_around(world_box(settings, crest + reach), settings.velocity_voxel, kLeaf);
        numbers.density = voxels.voxels();
        numbers.columns = std::max(numbers.columns, voxels.columns());
        const double period = plan.subject->domain(plan.resolution).size[0];
        double copies = 1.0;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            copies *= (box.high[axis] - box.low[axis] + 2.0 * reach) / period + 1.0;
        }
        numbers.puffs = static_cast<std::uint64_t>(
            copies * static_cast<double>(most_spray(sea_of(*plan.subject), settings.spray)));
    }
    return numbers;
}

QueryOptions height_query(const BakePlan& plan) {
    return {.foam = false, .resolution = plan.resolution};
}

/// Waves that the velocity's voxels hold: two of them, at least.
QueryOptions velocity_query(const BakePlan& plan) {
    const double voxel = settings_of(plan).velocity_voxel;
    const double period = plan.subject->domain(plan.resolution).size[0];
    int resolution = kMinResolution;
    while (2 * resolution <= plan.resolution && 2 * resolution * voxel <= period * (1.0 + 1e-9)) {
        resolution *= 2;
    }
    return {.foam = false, .resolution = resolution};
}

/// Of the mist's puffs and of the spray that they are of.
std::uint64_t mist_bytes(const BakePlan& plan, std::uint64_t puffs) {
    const Grid& grid = sea_of(*plan.subject).parameters.grid;
    const SpraySettings& spray = settings_of(plan).spray;
    const int lattice = spray_lattice(grid).resolution;
    return spray_bytes(most_spray(sea_of(*plan.subject), spray)) +
           puffs * (sizeof(io::DensityPuff) + 2 * sizeof(std::uint32_t)) +
           maps_bytes(lattice, kSprayChannels.size()) +
           work_bytes(grid, plan.backend, kSprayChannels, lattice);
}

}  // namespace

std::uint64_t volume_frame_bytes(const BakePlan& plan) {
    const Numbers numbers = most_numbers(plan);
    constexpr std::uint64_t kOfColumn =
        sizeof(io::SurfaceColumn) + sizeof(float) + 8 * sizeof(io::Velocity);  // a leaf's layers
    // Leaves have a mask too.
    const std::uint64_t mist =
        settings_of(plan).density ? mist_bytes(plan, numbers.puffs) : std::uint64_t{0};
    return mist + numbers.voxels() * (sizeof(float) + 1) + numbers.columns * kOfColumn +
           plan.subject->query_bytes(height_query(plan)) +
           2 * plan.subject->query_bytes(velocity_query(plan));
}

std::uint64_t most_volume_bytes(const BakePlan& plan) {
    const Numbers numbers = most_numbers(plan);
    const std::uint64_t size = settings_of(plan).half_floats ? 2 : sizeof(float);
    return 2 * plan.subject_text.size() + 8192 + numbers.voxels() * size;
}

namespace {

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
        work.source.query(work.time(), points, samples, options);
        take(first, samples);
    }
}

/// Of the columns of a range; folds are counted.
struct Columns {
    std::vector<io::SurfaceColumn> surface;
    double crest = -kFarthest;
    std::size_t folded = 0;

    std::vector<float> heights() const {
        std::vector<float> heights;
        heights.reserve(surface.size());
        for (const io::SurfaceColumn& column : surface) heights.push_back(column.height);
        return heights;
    }
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
                              columns.surface, axes, work.source.pool());
}

io::VdbGrid make_velocity(const FrameWork& work, io::VolumeAxes axes) {
    constexpr int kBeyond = 1;  // so that what is read at the box's sides has voxels around it
    const Settings& settings = settings_of(work.plan);
    const double size = settings.velocity_voxel;
    const Columns columns = columns_of(work, range_to(settings, size, kBeyond, 0.0));
    const io::VoxelRange voxels = range_to(settings, size, kBeyond, columns.crest);
    const std::vector<float> heights = columns.heights();

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
            ocean_of(work.source).water_motion(work.time(), points, motions, query);
            moved_at = z;
        }
        for (std::size_t at = 0; at < out.size(); ++at) {
            out[at] = {static_cast<float>(motions[at].velocity_x),
                       static_cast<float>(motions[at].velocity_y),
                       static_cast<float>(motions[at].velocity_z)};
        }
    };
    return io::make_velocity(voxels, heights, layer, axes, work.source.pool());
}

/// The puffs of all copies of the period that reach into the box.
std::vector<io::DensityPuff> puffs_around(const FrameWork& work, const Settings& settings) {
    const double period = work.plan.subject->domain(work.plan.resolution).size[0];
    const std::array<double, 6>& box = *settings.box;
    const double area = settings.spray.density > 0.0 ? settings.mist / settings.spray.density : 0.0;
    std::vector<io::DensityPuff> puffs;
    for (const MistPuff& mist : ocean_of(work.source).mist(work.time(), settings.spray)) {
        io::DensityPuff puff{{mist.x, mist.y, mist.z}, mist.deviation, area * mist.share};
        const double reach = io::density_reach(puff, settings.velocity_voxel);
        const auto first = [&](std::size_t axis) {
            return std::ceil((box[axis] - reach - puff.place[axis]) / period);
        };
        const auto last = [&](std::size_t axis) {
            return std::floor((box[axis + 3] + reach - puff.place[axis]) / period);
        };
        const double first_x = first(0), last_x = last(0), first_y = first(1), last_y = last(1);
        for (double ny = first_y; ny <= last_y; ++ny) {
            for (double nx = first_x; nx <= last_x; ++nx) {
                puff.place = {mist.x + nx * period, mist.y + ny * period, mist.z};
                puffs.push_back(puff);
            }
        }
    }
    return puffs;
}

io::VdbGrid make_mist(const FrameWork& work, io::VolumeAxes axes) {
    const Settings& settings = settings_of(work.plan);
    const double voxel = settings.velocity_voxel;
    const std::vector<io::DensityPuff> puffs = puffs_around(work, settings);
    if (puffs.empty()) {
        work.warn(
            format_text("at %g s the sea makes no spray, and its mist is empty", work.time()));
    }
    double highest = settings.box->at(2) + voxel;
    for (const io::DensityPuff& puff : puffs) {
        highest = std::max(highest, puff.place[2] + io::density_reach(puff, voxel));
    }
    const io::VoxelRange voxels = io::voxels_around(world_box(settings, highest), voxel, 0);
    const std::vector<float> heights = columns_of(work, voxels).heights();
    return io::make_density(voxels, heights, puffs, axes, work.source.pool());
}

}  // namespace

void write_volumes(const FrameWork& work, std::span<const BakeFile> files) {
    const Settings& settings = settings_of(work.plan);
    const io::VolumeAxes axes{settings.axes == io::Axes::yup};
    std::vector<io::VdbGrid> grids;
    if (settings.surface) grids.push_back(make_surface(work, axes));
    if (settings.velocity) grids.push_back(make_velocity(work, axes));
    if (settings.density) grids.push_back(make_mist(work, axes));
    work.put(files.front(), [&] {
        io::write_vdb(grids, volume_strings(work.plan, work.frame), settings.half_floats,
                      files.front().path);
    });
}

void adopt_volumes(const BakedHeader& header, BakeOptions& options) {
    options.take("box", header.text("box"));
    options.take("voxel", header.text("voxel"));
    options.take("velocity-voxel", header.text("velocity_voxel"));
    options.take("type", header.text("type"));
    if (!header.has("mist")) return;
    options.take("mist", header.text("mist"));
    adopt_spray_settings(header, options);
}

}  // namespace ocean
