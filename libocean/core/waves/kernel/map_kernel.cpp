// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Plans a frame (which fields, from which sources, to which outputs) and runs the two passes.
#include "map_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/prefault_pages.hpp"
#include "frame_parts.hpp"
#include "ocean/internal/cascades.hpp"
#include "ocean/page_vector.hpp"
#include "ocean/thread_pool.hpp"
#include "packed_modes.hpp"

namespace ocean {

namespace {

/// The field of a source, and the field that is i ky times it.
struct SourceFields {
    SourceKind kind;
    bool rate;
    Linear own;
    int derived;  // a Linear, or -1

    bool serves(LinearSet wanted) const {
        return wanted.contains(own) ||
               (derived >= 0 && wanted.contains(static_cast<Linear>(derived)));
    }
};

constexpr SourceFields kSources[kSourceCount] = {
    {SourceKind::plain, false, Linear::height, static_cast<int>(Linear::slope_y)},
    {SourceKind::along_x, false, Linear::slope_x, -1},
    {SourceKind::toward_x, false, Linear::displacement_x, static_cast<int>(Linear::gradient_xy)},
    {SourceKind::toward_y, false, Linear::displacement_y, static_cast<int>(Linear::gradient_yy)},
    {SourceKind::gradient_xx, false, Linear::gradient_xx, -1},
    {SourceKind::plain, true, Linear::height_rate, -1},
    {SourceKind::toward_x, true, Linear::displacement_x_rate, -1},
    {SourceKind::toward_y, true, Linear::displacement_y_rate, -1},
};

/// A channel that is a multiple of one linear field: its slot and factor.
struct Multiple {
    int slot;
    float factor;
};

/// Returns the linear fields that the outputs read.
LinearSet fields_behind(std::span<const MapOutput> outputs, bool is_flat) {
    return fields_of(outputs) | fields_of(channels_of(outputs), is_flat);
}

/// Adds a slot to those that the outputs read.
void use(FrameTask& task, int slot) {
    int* const end = task.used + task.used_count;
    if (std::find(task.used, end, slot) != end) return;
    *end = slot;
    ++task.used_count;
}

/// Fills in the fields, slots, sources and outputs that a frame requests. intermediate: the fields
/// whose sources lie between the passes, including the outputs' fields.
class Plan {
  public:
    Plan(FrameTask& task, const KernelFrame& frame, std::span<const MapOutput> outputs,
         LinearSet intermediate)
        : task_(task) {
        task.tau = frame.tau;
        task.choppiness = static_cast<float>(frame.settings.choppiness);
        task.foam_threshold = static_cast<float>(frame.settings.foam_threshold);
        task.foam_width = static_cast<float>(frame.settings.foam_width);
        task.foam = frame.foam;
        std::fill(std::begin(task.slot_of), std::end(task.slot_of), -1);
        std::fill(std::begin(task.derived_slot), std::end(task.derived_slot), -1);
        task.direct_count = 0;
        task.output_count = 0;
        number_slots(outputs);
        choose_sources(intermediate);
        for (const MapOutput& output : outputs) add_output(output);
    }

  private:
    static constexpr ChannelSet kNormal = {Channel::nx, Channel::ny, Channel::nz};

    void number_slots(std::span<const MapOutput> outputs) {
        const ChannelSet channels = channels_of(outputs);
        const LinearSet fields = fields_behind(outputs, is_flat());
        task_.slots = 0;
        task_.used_count = 0;
        for (const Linear field : kLinears) {
            if (fields.contains(field)) task_.slot_of[static_cast<int>(field)] = task_.slots++;
        }
        // All of the normal is computed at once, and foam together with its cover.
        ChannelSet derived = channels;
        if (channels.intersects(kNormal)) derived = derived | kNormal;
        if (channels.contains(Channel::cover)) derived = derived | Channel::foam;
        int slot = task_.slots;
        for (int c = 0; c < kChannelCount; ++c) {
            const auto channel = static_cast<Channel>(c);
            if (derived.contains(channel) && kKernelFormulas.contains(channel)) {
                task_.derived_slot[c] = slot++;
                use_fields(channel);
            }
        }
        task_.derived_slots = slot - task_.slots;
        task_.needs_jacobian = channels.intersects(
            {Channel::jacobian, Channel::whitecap, Channel::foam, Channel::cover});
    }

    bool is_flat() const { return task_.choppiness == 0.0f; }

    /// Requests the fields of a channel that combines several.
    void use_fields(Channel channel) {
        const LinearSet fields = fields_of(channel, is_flat());
        for (const Linear field : kLinears) {
            if (fields.contains(field)) use(task_, task_.slot_of[static_cast<int>(field)]);
        }
    }

    void choose_sources(LinearSet intermediate) {
        task_.source_count = 0;
        for (const SourceFields& fields : kSources) {
            if (!fields.serves(intermediate)) continue;
            const int own = task_.slot_of[static_cast<int>(fields.own)];
            const int derived = fields.derived < 0 ? -1 : task_.slot_of[fields.derived];
            task_.source[task_.source_count++] = {fields.kind, fields.rate, own, derived};
        }
    }

    Multiple multiple(Quantity quantity) const {
        const auto slot_of = [this](Linear field) {
            return task_.slot_of[static_cast<int>(field)];
        };
        if (quantity.is_linear()) return {slot_of(quantity.linear()), 1.0f};
        const ChannelInfo& info = channel_info(quantity.channel());
        if (!info.is_multiple()) return {task_.derived_slot[quantity.id], 1.0f};
        return {slot_of(info.field), info.times(task_.choppiness)};
    }

    void add_output(MapOutput output) {
        for (MapOutput::Component& component : output.used()) {
            if (component.quantity == Quantity{}) continue;
            const Multiple source = multiple(component.quantity);
            component.quantity.id = source.slot;
            component.factor *= source.factor;
        }
        output.row_pitch = output.pitch(task_.size);
        const MapOutput::Component& first = output.component[0];
        const bool aligned = reinterpret_cast<std::uintptr_t>(output.data) % 64 == 0 &&
                             output.row_pitch * sizeof(float) % 64 == 0;
        if (output.components == 1 && aligned && first.quantity.id >= 0 &&
            first.quantity.id < task_.slots) {
            task_.direct[task_.direct_count++] = {first.quantity.id, first.factor, output.data,
                                                  output.row_pitch};
            return;
        }
        bool& whole = task_.whole[task_.output_count];
        task_.outputs[task_.output_count++] = output;
        whole = true;
        for (const MapOutput::Component& component : output.used()) {
            const int slot = component.quantity.id;
            whole = whole && slot >= 0;
            if (slot >= 0 && slot < task_.slots) use(task_, slot);
        }
    }

    FrameTask& task_;
};

/// Returns true if displacements are negligible in the precision of the kernel.
bool is_flat(const KernelFrame& frame) {
    return static_cast<float>(frame.settings.choppiness) == 0.0f;
}

/// Resizes to at least `count` floats and loses the contents. Returns true if the memory is new.
bool make_room(PageVector<float>& floats, std::size_t count) {
    if (floats.size() >= count) return false;
    floats = {};
    floats = PageVector<float>(count);
    return true;
}

/// Returns whether outputs of N x N samples are stored past the caches, if making them reads
/// `floats_beside` floats too. A host works between its frames, so that the maps have left the
/// caches when they are written again: storing through the caches would then read each line from
/// memory first. [measured, Zen 5, N = 256, after frames of others: vertices 0.19 ms instead of
/// 0.24 to 0.30, eight planes 0.28 instead of 0.42 to 0.63; a frame after the other takes the same
/// time, or up to 6 % more if its maps are read next. N = 1024: 26 to 46 % less]
/// Foam is read at its next tick: a small one would lose a quarter.
bool are_streamed(const KernelFrame& frame, std::span<const MapOutput> outputs, int n,
                  std::size_t floats_beside, const CacheSizes& caches) {
    const bool has_tick = frame.foam.kept != nullptr;
    std::size_t components = has_tick ? 1 : 0;
    for (const MapOutput& output : outputs) {
        components += static_cast<std::size_t>(output.components);
    }
    const std::size_t written =
        components * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    return (floats_beside + written) * sizeof(float) > caches.shared / (has_tick ? 8 : 32);
}

}  // namespace

void lay_out(FrameTask& task, int lanes) {
    const auto width = static_cast<std::size_t>(lanes);
    const int b = task.size / first_factor(task.size);
    const auto rows = static_cast<std::size_t>(task.columns / b);
    // Odd in values of all lanes, so that the step is not a multiple of the cache's sets.
    task.line_stride = rows * 8 * width + 2 * width;
    task.source_stride = task.line_stride * static_cast<std::size_t>(b / 2);
    // A multiple of 4 KiB, over which a first cache repeats its sets, and a pad that spreads the
    // stores of a group of pass one evenly over them, whatever the number of sources.
    const std::size_t sources = task.source_stride * static_cast<std::size_t>(task.source_count);
    const std::size_t pad = std::max(width * width / 2, std::size_t{16});
    task.pair_stride = (sources + 1023) / 1024 * 1024 + pad;
}

struct MapKernel::Impl {
    std::shared_ptr<const PackedModes> modes;
    std::shared_ptr<const PackedModes> toward;
    const KernelCode& code;
    const CacheSizes caches;
    PageVector<float> wavenumber;
    std::vector<float> twiddle;
    PageVector<float> intermediate;
    std::vector<PageVector<float>> scratch;  // one for each thread
    FrameTask task{};                        // pass one's, for all outputs
    std::vector<FrameTask> part;             // pass two's, by part

    Impl(std::shared_ptr<const PackedModes> packed, const CacheSizes& sizes)
        : code(kernel_code(packed->level())),
          caches(sizes),
          wavenumber(static_cast<std::size_t>(packed->size())) {
        const int size = packed->size();
        const int a = first_factor(size);
        for (int j = 0; j < size / a; ++j) {
            for (int k = 0; k < a; ++k) {
                const double angle = kTwoPi * (j * k) / size;
                twiddle.push_back(static_cast<float>(std::cos(angle)));
                twiddle.push_back(static_cast<float>(std::sin(angle)));
            }
        }
        task.size = size;
        task.twiddle = twiddle.data();
        task.wavenumber = wavenumber.data();
        set_modes(std::move(packed));
    }

    void set_modes(std::shared_ptr<const PackedModes> packed) {
        for (int i = 0; i < task.size; ++i) {
            const double k = packed->wavenumber_step() * signed_wavenumber(i, task.size);
            wavenumber[static_cast<std::size_t>(i)] = static_cast<float>(k);
        }
        task.columns = packed->columns();
        task.packets = packed->packets();
        task.groups = packed->groups();
        task.rate_unit = static_cast<float>(kTwoPi * packed->rate_unit());
        modes = std::move(packed);
        interpolate(nullptr, 0.0f);
    }

    void interpolate(std::shared_ptr<const PackedModes> packed, float share) {
        task.toward = packed != nullptr ? packed->packets() : nullptr;
        task.share = share;
        toward = std::move(packed);
    }

    void begin(const KernelFrame& frame, std::span<const MapOutput> outputs, ThreadPool& pool) {
        divide(frame, outputs);
        const std::size_t floats =
            task.pair_stride * static_cast<std::size_t>(task.size / (2 * code.lanes));
        if (make_room(intermediate, floats)) prefault_pages(intermediate, pool);
        task.intermediate = intermediate.data();
        const bool streams = are_streamed(frame, outputs, task.size, floats, caches);
        for (FrameTask& one : part) {
            one.intermediate = intermediate.data();
            one.stream_outputs = streams;
        }
    }

    void sweep(std::span<const std::uint8_t> strips, ThreadPool* pool) {
        const auto threads = pool != nullptr ? static_cast<std::size_t>(pool->size()) : 1;
        scratch.resize(std::max(scratch.size(), threads));
        for (PageVector<float>& one : scratch) make_room(one, scratch_floats());
        const auto unwanted = static_cast<int>(std::ranges::count(strips, 0));
        const int columns = task.size - unwanted * code.item_width;
        const std::size_t floats =
            task.pair_stride * static_cast<std::size_t>(columns / (2 * code.lanes));
        // If most of the intermediate values stay in the shared cache, storing past it loses 8 % of
        // a frame; otherwise storing through it loses 10 % [measured].
        task.stream_intermediate = floats * sizeof(float) > caches.shared / 4;
        task.strips = unwanted > 0 ? strips.data() : nullptr;
        const auto block = [this](int item, int thread) {
            code.pass_one(task, item, scratch[static_cast<std::size_t>(thread)].data());
        };
        const int blocks = task.columns / code.lanes;
        if (pool != nullptr) {
            pool->for_each_item(blocks, block);
        } else {
            for (int item = 0; item < blocks; ++item) block(item, 0);
        }
    }

    void run(const KernelFrame& frame, std::span<const MapOutput> outputs, ThreadPool& pool) {
        begin(frame, outputs, pool);
        sweep({}, &pool);
        pool.for_each_item(task.size / code.item_width, [this](int item, int thread) {
            pass_two(item, scratch[static_cast<std::size_t>(thread)].data());
        });
    }

    /// Plans pass one, and pass two part by part: outputs that share a field belong to one part,
    /// and parts are joined while their scratch leaves a quarter of a core's cache to other data.
    void divide(const KernelFrame& frame, std::span<const MapOutput> outputs) {
        const auto fields_of_one = [flat = is_flat(frame)](const MapOutput& output) {
            return fields_behind({&output, 1}, flat);
        };
        FrameParts parts;
        for (const MapOutput& output : outputs) parts.add(fields_of_one(output));
        parts.join(caches.core * 3 / 4 / (code.field_floats(task.size) * sizeof(float)));

        const LinearSet fields = fields_behind(outputs, is_flat(frame));
        Plan(task, frame, outputs, fields);
        lay_out(task, code.lanes);
        part.assign(static_cast<std::size_t>(parts.count()), task);
        std::array<MapOutput, kMaxOutputs> own;
        for (int p = 0; p < parts.count(); ++p) {
            const auto end = std::copy_if(
                outputs.begin(), outputs.end(), own.begin(),
                [&](const MapOutput& output) { return parts.of(fields_of_one(output)) == p; });
            Plan(part[static_cast<std::size_t>(p)], frame, {own.begin(), end}, fields);
        }
        for (std::size_t p = 0; p + 1 < part.size(); ++p) look_ahead(part[p], part[p + 1], 0);
        look_ahead(part.back(), part.front(), 1);
    }

    /// Notes the sources that `next` reads, `items` items after the sources of `here`.
    static void look_ahead(FrameTask& here, const FrameTask& next, int items) {
        here.ahead_items = items;
        here.ahead_count = 0;
        for (int s = 0; s < next.source_count; ++s) {
            const bool is_near = items == 0 && here.source[s].is_read();
            if (next.source[s].is_read() && !is_near) here.ahead[here.ahead_count++] = s;
        }
    }

    void pass_two(int item, float* floats) const {
        for (const FrameTask& one : part) code.pass_two(one, item, floats);
    }

    std::size_t scratch_floats() const {
        std::size_t floats = 0;
        for (const FrameTask& one : part) floats = std::max(floats, code.scratch_floats(one));
        return floats;
    }
};

MapKernel::MapKernel(std::shared_ptr<const PackedModes> modes, const CacheSizes& caches)
    : impl_(std::make_unique<Impl>(std::move(modes), caches)) {}
MapKernel::~MapKernel() = default;
MapKernel::MapKernel(MapKernel&&) noexcept = default;
MapKernel& MapKernel::operator=(MapKernel&&) noexcept = default;

void MapKernel::use(std::shared_ptr<const PackedModes> modes) {
    const bool fits = modes->size() == impl_->task.size && modes->level() == impl_->modes->level();
    if (!fits) {
        *this = MapKernel(std::move(modes), impl_->caches);
        return;
    }
    impl_->set_modes(std::move(modes));
}

void MapKernel::interpolate(std::shared_ptr<const PackedModes> toward, float share) {
    impl_->interpolate(std::move(toward), share);
}

void MapKernel::run(const KernelFrame& frame, ThreadPool& pool) {
    std::span<const MapOutput> left = frame.outputs;
    while (!left.empty()) {
        const std::size_t count = std::min(left.size(), std::size_t{kMaxOutputs});
        impl_->run(frame, left.first(count), pool);
        left = left.subspan(count);
    }
}

void MapKernel::begin(const KernelFrame& frame, ThreadPool& pool) {
    impl_->begin(frame, frame.outputs, pool);
}

void MapKernel::sweep(std::span<const std::uint8_t> strips, ThreadPool* pool) {
    impl_->sweep(strips, pool);
}

int MapKernel::strip_width() const {
    return impl_->code.item_width;
}
std::size_t MapKernel::scratch_floats() const {
    return impl_->scratch_floats();
}

void MapKernel::write_strip(int strip, float* scratch) const {
    impl_->pass_two(strip, scratch);
}

void write_rows(const PlanarFields& fields, int resolution, int first, int last,
                const KernelFrame& frame, SimdLevel level) {
    const KernelCode& code = kernel_code(level);
    FrameTask task{};
    task.size = resolution;
    Plan(task, frame, frame.outputs, fields_behind(frame.outputs, is_flat(frame)));
    const std::size_t planes = static_cast<std::size_t>(task.slots) * fields.row_stride *
                               static_cast<std::size_t>(resolution);
    task.stream_outputs = are_streamed(frame, frame.outputs, resolution, planes, cache_sizes());
    // Here directly written planes are outputs like the others.
    for (int d = 0; d < task.direct_count; ++d) {
        const DirectPlane& plane = task.direct[d];
        task.whole[task.output_count] = true;
        MapOutput& output = task.outputs[task.output_count++];
        output = {plane.data, 1, {}, plane.row_pitch};
        output.component[0].quantity.id = plane.slot;
        output.component[0].factor = plane.factor;
        use(task, plane.slot);
    }
    for (int row = first; row < last; ++row) code.write_row(task, fields, row);
}

std::uint64_t packed_bytes(int resolution) {
    // Eleven numbers for two modes of a half plane.
    return Lattice{resolution, 1.0}.size() * sizeof(float) * kPairNumbers / 4;
}

std::uint64_t kernel_bytes(const Grid& grid, LinearSet fields, int resolution) {
    std::uint64_t packed = 0;
    int half_band = 0;
    for (const int divisor : cascade_divisors(grid)) {
        const int half = half_of(grid.resolution, divisor, resolution);
        // If one row of a block has modes, the block has all its lanes.
        const int rows = std::min(divisor, kernel_code(simd_level()).lanes);
        packed += packed_bytes(2 * half) * static_cast<std::uint64_t>(rows);
        half_band = std::max(half_band, (half - 1) * divisor + 1);
    }
    const auto sources =
        std::count_if(std::begin(kSources), std::end(kSources),
                      [fields](const SourceFields& source) { return source.serves(fields); });
    // Complex numbers, one for each ky of the band and each x.
    const std::uint64_t between = static_cast<std::uint64_t>(sources) * 2 * sizeof(float) *
                                  static_cast<std::uint64_t>(half_band) *
                                  static_cast<std::uint64_t>(resolution);
    return std::min(packed, packed_bytes(resolution)) + between;
}

}  // namespace ocean
