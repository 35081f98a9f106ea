// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Claim: the text is the surface. An open sea or land whose key is set shows, bit for bit, what the
// text with that value shows when it is opened, and setting the key back gives the first maps
// again. The keys are the rows of the tables: a new one joins by itself.

#include <bit>
#include <cstdint>
#include <set>

#include "ocean/land_mask.hpp"
#include "ocean/ocean.hpp"
#include "ocean/parameter_table.hpp"
#include "ocean/sea_bed.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/seafile.hpp"
#include "ocean/terrain.hpp"
#include "ocean/terrain_table.hpp"
#include "ocean/terrainfile.hpp"
#include "paths.hpp"
#include "refusal.hpp"
#include "temporary_folder.hpp"
#include "testing.hpp"

namespace ocean::test {
namespace {

// ---- Other values of a row

/// Values of keys that name files or records, which no row can give: by path, without an item.
const std::map<std::string, std::vector<std::string>> kTexts = {
    {"water.seabed", {"other.asc"}},
    {"time.take", {"other.take"}},
    {"waves.N.file", {data_dir() + "/spectra/ndbc_41010.csv"}},
    {"waves.N.record", {"2020-06-07T11:50"}},
    {"waves.N.place", {"41010"}},
    {"hulls.N.track_file", {"other_boat.gpx"}},
    {"hulls.N.origin_time", {"2026-05-01T10:06:41Z"}},
    {"terrain.measured", {"rings.csv", "other.csv"}},
    {"terrain.base", {"other.asc"}},
};

std::string general_path(const ParameterSpec& spec) {
    if (!spec.in_list()) return spec.path();
    return std::string(spec.section) + ".N." + std::string(spec.key);
}

/// Shares of a slider's range, from its beginning: some value is valid beside the other keys.
constexpr std::array kShares = {0.3, 0.003, 0.00003};
constexpr std::array kFactors = {1.25, 0.8};

double on_slider(const ParameterSpec& spec, double share) {
    return spec.soft_min + share * (spec.soft_max - spec.soft_min);
}

std::vector<ParameterValue> other_whole_numbers(const ParameterSpec& spec, std::int64_t now) {
    const auto least = static_cast<std::int64_t>(spec.min_nonzero);
    if (spec.rule == NumberRule::power_of_two) {
        return now == 0 ? std::vector<ParameterValue>{least, 2 * least}
                        : std::vector<ParameterValue>{2 * now, now / 2};
    }
    const std::int64_t step = spec.rule == NumberRule::even ? 2 : 1;
    return {now + step, now - step};
}

std::vector<ParameterValue> other_numbers(const ParameterSpec& spec, const ParameterValue& now) {
    std::vector<ParameterValue> others;
    const double* const number = std::get_if<double>(&now);
    if (number != nullptr) {
        for (const double factor : kFactors) others.emplace_back(factor * *number);
    }
    for (const double share : kShares) others.emplace_back(on_slider(spec, share));
    return others;
}

/// Returns lists of each length, of numbers that ascend.
std::vector<ParameterValue> other_lists(const ParameterSpec& spec, const ParameterValue& now) {
    std::vector<ParameterValue> others;
    if (const auto* numbers = std::get_if<std::vector<double>>(&now)) {
        std::vector<double> scaled = *numbers;
        for (double& number : scaled) number *= kFactors.front();
        others.emplace_back(scaled);
    }
    const auto length = static_cast<int>(std::min<std::size_t>(spec.max_length, 5));
    for (int count = 1; count <= length; ++count) {
        for (const double share : kShares) {
            std::vector<double> numbers;
            std::vector<std::int64_t> whole = {static_cast<std::int64_t>(spec.min)};
            NumberPairs pairs;
            for (int n = 0; n < count; ++n) {
                numbers.push_back(on_slider(spec, share * (1.0 + 0.75 * n)));
                pairs.push_back({on_slider(spec, share / (1.0 + n)),
                                 spec.second_min + 0.3 * (spec.second_max - spec.second_min)});
                if (n > 0) whole.push_back(3 * whole.back());
            }
            if (spec.type() == "numbers") others.emplace_back(numbers);
            if (spec.type() == "list") others.emplace_back(whole);
            if (spec.type() == "pairs") others.emplace_back(pairs);
        }
    }
    return others;
}

/// Returns texts of values that a row allows beside `now`, although perhaps not beside other keys.
std::vector<std::string> other_texts(const ParameterSpec& spec, const ParameterValue& now) {
    std::vector<ParameterValue> others;
    if (spec.type() == "text") {
        const auto texts = kTexts.find(general_path(spec));
        return texts == kTexts.end() ? std::vector<std::string>() : texts->second;
    } else if (spec.type() == "enum") {
        for (const std::string_view word : spec.choices()) others.emplace_back(std::string(word));
    } else if (spec.type() == "bool") {
        others.emplace_back(!std::get<bool>(now));
    } else if (spec.type() == "int") {
        others = other_whole_numbers(spec, std::get<std::int64_t>(now));
    } else if (spec.type() == "float") {
        others = other_numbers(spec, now);
    } else if (spec.type() == "wave_height") {
        others = {std::string("0.7 Hs"), 0.25};
    } else {
        others = other_lists(spec, now);
    }
    std::erase(others, now);
    std::vector<std::string> texts;
    for (const ParameterValue& other : others) texts.push_back(to_text(other));
    return texts;
}

// ---- Files that the texts name

void write_heights(const std::string& path, double slope) {
    constexpr int kSide = 17;
    std::ofstream file(path);
    file << "ncols " << kSide << "\nnrows " << kSide << "\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    for (int j = 0; j < kSide; ++j) {
        for (int i = 0; i < kSide; ++i) {
            file << slope * (i - 6) + 0.05 * ((7 * i + 3 * j) % 5) << ' ';
        }
        file << '\n';
    }
}

void write_files(const TemporaryFolder& folder) {
    write_heights(folder.file("bed.asc"), 0.6);
    write_heights(folder.file("other.asc"), 0.7);
    folder.write("storm.take", "0 wind_speed 12\n0.2 wind_speed 9\n");
    folder.write("other.take", "0.1 choppiness 0.5\n");
    folder.write("rings.csv", "wavenumber,density\n0.01,5\n0.1,0.5\n1,0.001\n");
    folder.write("other.csv", "wavenumber,density\n0.01,9\n0.1,0.4\n1,0.002\n");
    const auto write_boat = [&](const std::string& name, const std::string& longitude) {
        const std::string place = "\" lon=\"" + longitude + "\"><time>2026-05-01T10:0";
        folder.write(name, "<gpx><trkpt lat=\"-0.0175" + place +
                               "0:00Z</time></trkpt><trkpt lat=\"" + "0.00326" + place +
                               "7:40Z</time></trkpt></gpx>");
    };
    write_boat("boat.gpx", "0.00036");
    write_boat("other_boat.gpx", "0.0004");
}

// ---- What is compared

/// Bits of everything that is shown, by name.
using Shown = std::map<std::string, std::vector<std::uint32_t>>;

template <typename Numbers>
void add(Shown& shown, const std::string& name, const Numbers& numbers) {
    std::vector<std::uint32_t>& bits = shown[name];
    for (const float number : numbers) bits.push_back(std::bit_cast<std::uint32_t>(number));
}

void add_map(Shown& shown, const std::string& name, const Surface& map) {
    for (int c = 0; c < kChannelNumbers; ++c) {
        const auto channel = static_cast<Channel>(c);
        if (map.has(channel))
            add(shown, name + " " + std::string(channel_info(channel).name), map.channel(channel));
    }
}

void add_samples(Shown& shown, const std::vector<QuerySample>& samples) {
    std::vector<float> numbers;
    for (const QuerySample& sample : samples) {
        for (const double number : {sample.height, sample.normal[0], sample.normal[1],
                                    sample.velocity[0], sample.label[0], sample.foam}) {
            numbers.push_back(static_cast<float>(number));
        }
    }
    add(shown, "query", numbers);
}

/// Returns the names of what differs; "" if all is equal.
std::string difference(const Shown& a, const Shown& b) {
    std::string names;
    for (const auto& [name, bits] : a) {
        const auto other = b.find(name);
        if (other == b.end() || other->second != bits) names += name + ", ";
    }
    for (const auto& [name, bits] : b) {
        if (!a.contains(name)) names += name + ", ";
    }
    return names;
}

const std::vector<WorldPoint> kPoints = {{12.5, 40.25}, {71.0, 33.0}, {90.5, 91.5}};
/// Beside the grids, and across the border of a tile.
constexpr Domain kPart{{20.5, 30.25}, {60.0, 45.0}, {13, 10}, false};

/// A sea that is open, as a host has it. Its cover takes longer than all other channels together.
template <bool kWithCover>
class SeaHandle {
  public:
    static const Table<Parameters>& table() { return sea_table(); }

    SeaHandle(const std::string& text, const std::string& folder)
        : folder_(folder), ocean_(parse_sea(text, "sea", folder), {.threads = 1}) {}

    const Parameters& model() const { return ocean_.parameters(); }
    /// Returns the sea with a key of another value. Throws Error.
    Sea changed(const std::string& key, const std::string& value) const {
        Sea sea = ocean_.sea();
        set_parameter(sea.parameters, key, value);
        resolve_files(sea, folder_);
        validate(sea);
        return sea;
    }
    void set(const Sea& sea) { ocean_.change(sea); }

    Shown shown() {
        const double time = ocean_.sea().time_of(9.5);
        Shown shown;
        ChannelSet channels;
        for (int c = 0; c < kChannelCount; ++c) {
            const auto channel = static_cast<Channel>(c);
            if (kWithCover || channel != Channel::cover) channels = channels | channel;
        }
        if (ocean_.repeats()) {
            add_map(shown, "map", ocean_.evaluate(time, channels));
        } else {
            channels = channels | (ocean_.parameters().water.bed ? kMasksOverBed : kHullMasks);
            add_map(shown, "region", ocean_.region(time, kPart, channels));
        }
        std::vector<QuerySample> samples(kPoints.size());
        ocean_.query(time, kPoints, samples, {.foam = kWithCover});
        add_samples(shown, samples);
        return shown;
    }

  private:
    std::string folder_;
    Ocean ocean_;
};

/// A land that is open.
class LandHandle {
  public:
    static const Table<TerrainModel>& table() { return terrain_table(); }

    LandHandle(const std::string& text, const std::string& folder)
        : folder_(folder), land_(parse_terrain(text, "terrain", folder), {.threads = 1}) {}

    const TerrainModel& model() const { return land_.model(); }
    TerrainModel changed(const std::string& key, const std::string& value) const {
        TerrainModel terrain = land_.model();
        set_parameter(terrain, key, value);
        resolve_files(terrain, folder_);
        validate(terrain);
        return terrain;
    }
    void set(const TerrainModel& terrain) { land_.set_model(terrain); }

    Shown shown() {
        Shown shown;
        const Domain whole = land_.domain();
        add_map(shown, "map",
                land_.model().is_placed() ? land_.region(whole, land_.channels())
                                          : land_.surface(land_.channels()));
        Domain part = kPart;
        part.origin = {whole.origin[0] + kPart.origin[0], whole.origin[1] + kPart.origin[1]};
        add_map(shown, "region", land_.region(part, land_.channels()));
        std::vector<QuerySample> samples(kPoints.size());
        land_.query(kPoints, samples);
        add_samples(shown, samples);
        return shown;
    }

  private:
    std::string folder_;
    Terrain land_;
};

// ---- The walk over the keys

std::string text_of(const Sea& sea) {
    return write_sea(sea);
}
std::string text_of(const TerrainModel& terrain) {
    return write_terrain(terrain);
}

struct Base {
    const char* name;
    const char* text;
};

/// Why a key is not among the compared ones.
using Reasons = std::map<std::string, std::string>;

template <typename Handle>
class KeyWalk {
  public:
    KeyWalk() { write_files(folder_); }

    /// Sets each key of a section once, each time back, and compares. An empty section: all keys.
    void walk(const Base& base, std::string_view section = "") {
        Handle open(std::string("libocean = 1\n") + base.text, folder_.path());
        first_ = open.shown();
        for (const auto& row : Handle::table().rows) {
            if (!section.empty() && row.section != section) continue;
            for (std::size_t item = 0; item < row.member.items(open.model()); ++item) {
                set_and_compare(base, open, row, item);
            }
        }
    }

    /// Expects that each key was set by some base, and that some base shows it: all but those of
    /// these lists.
    void expect_all(const Reasons& never_set, const Reasons& never_seen) const {
        for (const auto& row : Handle::table().rows) {
            const std::string path = general_path(row);
            EXPECT_EQ(set_.contains(path), !never_set.contains(path)) << path;
            const bool hidden = never_set.contains(path) || never_seen.contains(path);
            EXPECT_EQ(seen_.contains(path), !hidden) << path << " changes what is shown";
        }
    }

  private:
    template <typename Row>
    void set_and_compare(const Base& base, Handle& open, const Row& row, std::size_t item) {
        const std::string path = row.path(item);
        const ParameterValue before = value_of(open.model(), {&row, item});
        for (const std::string& other : other_texts(row, before)) {
            auto changed = open.changed(path, to_text(before));
            if (refusal_of([&] { changed = open.changed(path, other); }).refused) {
                continue;  // not beside the other keys of this base
            }
            SCOPED_TRACE(std::string(base.name) + ": " + path + " = " + other + ", before " +
                         to_text(before));
            const Shown fresh = Handle(text_of(changed), folder_.path()).shown();
            open.set(changed);
            EXPECT_EQ(difference(open.shown(), fresh), "") << "set, against opened";
            set_.insert(general_path(row));
            if (!difference(fresh, first_).empty()) seen_.insert(general_path(row));
            open.set(open.changed(path, to_text(before)));
            EXPECT_EQ(difference(open.shown(), first_), "") << "set back, against the first maps";
            return;
        }
    }

    TemporaryFolder folder_;
    Shown first_;
    std::set<std::string> set_, seen_;
};

constexpr Base kSeas[] = {
    {"wind sea",
     "[water]\ndepth = 20.0\n"
     "[grid]\nresolution = 32\npatch_size = 100.0\n"
     "[surface]\nfoam_lifetime = 0.4\nfoam_step = 0.1\n"
     "[[waves]]\nspectrum = \"jonswap\"\nspreading = \"hasselmann\"\nwind_speed = 14.0\n"},
    {"swell beside a wind sea, in cascades",
     "[grid]\nresolution = 32\npatch_size = 200.0\ncascades = 2\n"
     "[surface]\nfoam_lifetime = 0.0\nfoam_step = 1.0\n"
     "[time]\nloop_period = 8.0\n"
     "[[waves]]\nspectrum = \"pierson_moskowitz\"\nwind_speed = 12.0\n"
     "[[waves]]\nspectrum = \"jonswap\"\nsignificant_wave_height = 1.0\npeak_period = 7.0\n"
     "wind_direction = 60.0\n"},
    {"foam of a threshold",
     "[grid]\nresolution = 64\npatch_size = 80.0\n"
     "[surface]\nfoam_lifetime = 0.2\nfoam_step = 0.1\nfoam_coverage = \"threshold\"\n"
     "[[waves]]\nspectrum = \"phillips\"\nwind_speed = 11.0\n"},
    {"take",
     "[grid]\nresolution = 32\npatch_size = 100.0\n"
     "[surface]\nfoam_lifetime = 0.2\nfoam_step = 0.1\n"
     "[time]\ntake = \"storm.take\"\n"
     "[[waves]]\nspectrum = \"jonswap\"\nwind_speed = 10.0\n"},
    {"coast",
     "[water]\nseabed = \"bed.asc\"\n"
     "[grid]\nresolution = 32\npatch_size = 160.0\n"
     "[surface]\nfoam_lifetime = 0.2\nfoam_step = 0.1\nshortest_wavelength = 25.0\n"
     "longest_wavelength = 90.0\n[water.shore]\nsurf_foam_lifetime = 0.3\n"
     "[[waves]]\nspectrum = \"jonswap\"\nwind_speed = 10.0\nwind_direction = 10.0\nswell = 0.8\n"},
};

TEST(SetKey, OfAnOpenSeaGivesWhatItsTextGives) {
    KeyWalk<SeaHandle<false>> keys;
    for (const Base& base : kSeas) keys.walk(base);
    const std::string measured =
        "[grid]\nresolution = 32\npatch_size = 200.0\n[surface]\nfoam_lifetime = 0.2\n"
        "foam_step = 0.1\n[[waves]]\nspectrum = \"measured\"\nfile = \"" +
        data_dir() + "/spectra/ndbc_41010.data_spec\"\n";
    keys.walk({"measured", measured.c_str()});
    keys.walk({"crests",
               "[grid]\nresolution = 32\npatch_size = 100.0\n"
               "[surface]\nfoam_lifetime = 0.2\nfoam_step = 0.1\n"
               "[[waves]]\nspectrum = \"jonswap\"\nspreading = \"mitsuyasu\"\nswell = -1.0\n"
               "wind_speed = 9.0\n"
               "[[crests]]\ntime = 0.4\nx = 30.0\ny = 45.0\nheight = \"0.6 Hs\"\n"
               "direction = 20.0\n"},
              "crests");
    keys.walk({"hull",
               "[grid]\nresolution = 32\npatch_size = 200.0\n[surface]\nfoam_lifetime = 0.0\n"
               "[[waves]]\nwind_speed = 6.0\n[[hulls]]\nlength = 12.0\nbeam = 3.0\n"
               "draught = 0.8\nwake_resolution = 64\ntrack_file = \"boat.gpx\"\n"
               "origin = [0.00004, 0.00004]\norigin_time = \"2026-05-01T10:06:40Z\"\n"},
              "hulls");
    keys.expect_all({}, {{"waves.N.place", "the only place of the file is the nearest one"}});
}

TEST(SetKey, OfFoamGivesTheCoverOfItsText) {
    KeyWalk<SeaHandle<true>> keys;
    keys.walk(kSeas[0], "surface");
}

constexpr Base kLands[] = {
    {"tile",
     "[terrain]\nresolution = 32\npatch_size = 640.0\nrms = 20.0\nmean = 5.0\nouter_scale = 400.0\n"
     "ridge_wavelength = 90.0\nridge_direction = 20.0\nanisotropy = 1.5\n"
     "[[terrain.layer]]\nperiod = 320.0\n[[terrain.layer]]\nperiod = 160.0\n"},
    {"tile of a range",
     "[terrain]\nresolution = 32\npatch_size = 640.0\nrange = [100.0, 300.0]\n"
     "longest_wavelength = 400.0\nshortest_wavelength = 45.0\nbreaks = [[200.0, 2.5]]\n"},
    {"tile with gullies",
     "[terrain]\nresolution = 32\npatch_size = 640.0\nrms = 20.0\n"
     "[terrain.gullies]\ndepth = 0.06\nlongest = 150.0\noctaves = 2\n"},
    {"placed land with streams and a shore",
     "[terrain]\nkind = \"placed\"\nresolution = 32\npatch_size = 640.0\nsize = [500.0, 400.0]\n"
     "rms = 20.0\nmean = 30.0\nisland = 45.0\ndetail_wavelength = 8.0\n"
     "[terrain.stream]\nslope = 0.6\nhillslope_area = 600.0\nmax_slope = 0.4\n"
     "[terrain.coast]\nslope = 0.03\nsmooth = 15.0\nshelter = 60.0\n"},
    {"placed land with gullies and a shore",
     "[terrain]\nkind = \"placed\"\nresolution = 32\npatch_size = 640.0\norigin = [50.0, -20.0]\n"
     "rms = 20.0\n[terrain.gullies]\ndepth = 0.06\nlongest = 150.0\n"
     "[terrain.coast]\nslope = 0.03\nlevel = 2.0\nsmooth = 15.0\nshelter = 60.0\n"},
    {"elevation model",
     "[terrain]\nkind = \"placed\"\nbase = \"bed.asc\"\nbase_error = 0.0005\n"
     "detail_wavelength = 4.0\n"},
    {"measured tile", "[terrain]\nresolution = 32\npatch_size = 640.0\nmeasured = \"rings.csv\"\n"},
};

TEST(SetKey, OfAnOpenLandGivesWhatItsTextGives) {
    KeyWalk<LandHandle> keys;
    for (const Base& base : kLands) keys.walk(base);
    keys.expect_all({}, {});
}

}  // namespace
}  // namespace ocean::test
