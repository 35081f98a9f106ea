// SPDX-FileCopyrightText: The libocean authors
// SPDX-License-Identifier: Apache-2.0
//
// Files for other renderers. One signature for all formats: a Frame, a path, the format's options.
// Every file is written under a temporary name beside its own and renamed when it is whole.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ocean/sea.hpp"
#include "ocean/sea_state.hpp"
#include "ocean/surface.hpp"

namespace ocean::io {

/// What a file says about one moment of a sea. References must outlive the call.
struct Frame {
    const Surface& surface;
    const std::string& sea_text;  // the resolved sea file: goes into headers
    int number;
    double time;                     // s
    Backend backend = Backend::cpu;  // which computed the surface: the last bits differ
};

/// Receives the bytes of a file or of its pixels, piece by piece.
using ByteSink = std::function<void(std::string_view)>;

/// Order of vector components: zup (x, y, z), yup (x, z, -y), tnb (x, z, y).
enum class Axes { zup, yup, tnb };
Axes find_axes(std::string_view name);
std::string_view axes_name(Axes axes);

enum class PixelType { automatic, half_float, full_float };
enum class ExrCompression { none, rle, zips, zip, piz, pxr24 };

struct ExrOptions {
    Axes axes = Axes::tnb;
    /// automatic: float for displacement and velocity, half for the rest.
    PixelType type = PixelType::automatic;
    ExrCompression compression = ExrCompression::zip;
    int threads = 0;
};

/// "zip", "pxr24" ...; a codec that spoils vectors (b44, b44a, dwaa, dwab) is refused with the
/// reason. Throws Error invalid_value.
ExrCompression find_exr_compression(std::string_view name);
std::string_view exr_compression_name(ExrCompression compression);

/// One product in a flat, single-part file: R,G,B or Y. The bottom scanline is j = 0.
/// Throws Error output.
void write_exr(const Frame& frame, const Product& product, const std::string& path,
               const ExrOptions& options);
/// All products in one file for compositors: R,G,B,A = displacement and 1, then normal.X ...
void write_exr_layered(const Frame& frame, std::span<const Product* const> products,
                       const std::string& path, const ExrOptions& options);

/// What the header of an image says, all of it known before its surface is computed.
struct ExrLabel {
    const std::string& sea_text;
    int number;
    double time;  // s
    Backend backend;
    Lattice map;
    std::span<const Product* const> products;  // one, or those of a layered file
    bool layered;
};
/// The bytes of the file before its pixels, as write_exr or write_exr_layered write them.
std::string exr_header_bytes(const ExrLabel& label, const ExrOptions& options);
/// Decodes every pixel of a file that begins with `header`: rows from the top; of a row the
/// channels in the file's order; of a channel half or float values, little-endian. Throws Error
/// bad_file for another header and for damage.
void read_exr_pixels(const std::string& path, std::string_view header, int threads,
                     const ByteSink& sink);

/// The `ocean:` header strings of a baked file, in name order. Throws Error bad_file with the
/// reason; safe on hostile files.
std::vector<std::pair<std::string, std::string>> read_exr_header(const std::string& path);

struct ExrChannel {
    std::string name;
    PixelType type;  // not automatic

    bool operator==(const ExrChannel&) const = default;
};
/// How the first part of a file stores its pixels.
struct ExrLayout {
    int resolution;                             // samples along each side
    std::optional<ExrCompression> compression;  // none: a codec that write_exr does not have
    std::vector<ExrChannel> channels;           // in the file's order
};
/// Throws Error bad_file with the reason; safe on hostile files.
ExrLayout read_exr_layout(const std::string& path);
/// The channels that a file of these products has, in the file's order.
std::vector<ExrChannel> exr_channels(std::span<const Product* const> products, bool layered,
                                     PixelType type);

/// Writes bytes so that `path` is either the old file or the whole new one, also when the disk is
/// full or the process is killed. Throws Error output with the path and the system's reason.
/// All writers here do so. They take no notice of signals: an interrupted program finishes the file
/// or unwinds by an exception, and both leave no temporary.
void write_file_atomically(const std::string& path, std::string_view bytes);

/// Removes what writers killed outright (power, kill -9, out of memory) left in a directory; "" is
/// the current one. Temporaries of writers that still live are kept. Returns how many it removed.
int remove_abandoned_temporaries(const std::string& directory);

/// 16-bit grey height_field of the channel height, whatever its samples are labels of, (N+1)^2 with
/// the wrapped seam, top row far. `path` + ".txt" says lo, hi, unit, quantum and POV-Ray's scale
/// and base, `path` + ".inc" the latter for scenes: height = base + scale * code / 65536. The
/// heights fill three quarters of the codes, so each is right to (hi - lo) / 98304. Needs channel
/// height. Throws Error output.
void write_height_field(const Frame& frame, const std::string& path);
/// The 16-bit codes of such a file, rows from the top, little-endian. Throws Error bad_file.
void read_height_field(const std::string& path, const ByteSink& sink);

/// Maps along the z axis of a DF3 file: height, dx, dz, two of the normal, foam. See df3.cpp.
inline constexpr int kDf3Slices = 6;
/// What write_df3 needs: dx, dy, height, nx, ny, nz, foam.
ChannelSet df3_channels();
std::uint64_t df3_bytes(int resolution);
/// A map as POV-Ray's density_file: heights to 2.4e-7 m, offsets to half a step of the
/// patch mesh's grid, which keeps the seam of copies free of cracks. Throws Error output,
/// invalid_value for a length that is not finite or beyond 1024 m.
void write_df3(const Surface& surface, const std::string& path);
/// Fills the foam of a map with that of one of twice the resolution: means of each sample and, at
/// half its weight, of those beside it, so that nothing moves. What foam becomes from far away.
void average_foam(const Surface& fine, Surface& coarse);

/// Of the folders that `ocean povray` writes: ocean.inc refuses any other.
inline constexpr int kPovrayDataVersion = 1;

/// A folder of frames for POV-Ray. References must outlive it.
struct PovrayFolder {
    const Sea& sea;
    const SeaState& state;
    std::string_view format;  // "df3", "mesh2" or "height_field"
    std::vector<int> maps;    // samples a side of each frame's maps, the finest first
    std::vector<int> frames;  // at least one

    /// Whether POV-Ray's own frame_number can be theirs.
    bool frames_are_consecutive() const;
};
/// The include file that tells a scene all of that, each parameter by its name:
/// `waves.0.wind_speed` is Ocean_Waves_0_Wind_Speed.
std::string povray_declarations(const PovrayFolder& folder);

/// Triangles with a normal at each vertex, z up, metres.
struct Mesh {
    std::vector<float> positions;  // x, y, z of each vertex
    std::vector<float> normals;
    std::vector<float> foam;     // of each vertex, 0 .. 1; empty where there is none
    std::vector<int> triangles;  // three vertex numbers each, counter-clockwise from above
};

/// One period of the displaced surface, (N+1)^2 vertices with the seam closed. Vertices lie on a
/// grid of a power of two (2^-16 m, coarser for large patches), which keeps the seam of copies that
/// lie a period apart free of cracks when the period lies on it too, as every whole number does.
/// Needs dx, dy, height, nx, ny, nz; takes foam too.
Mesh make_patch_mesh(const Surface& surface);
/// Its triangles alone, which are the same for all maps of so many samples a side.
std::vector<int> patch_triangles(int resolution);

/// Where a picture is taken from: what of the sea a mesh must show, and how finely.
struct View {
    double x = 0.0;  // eye, m
    double y = 0.0;
    double height = 6.0;          // above still water, m
    double heading = 0.0;         // degrees counter-clockwise from +x
    double field_of_view = 60.0;  // horizontal, degrees, 1 .. 150; the mesh has a margin around it
    double nearest = 0.0;         // first row, m from the eye; 0 = right for this height
    double horizon = 0.0;         // last row, m; 0 = where the Earth hides the highest crest
    int columns = 720;            // vertices across, and away
    int rows = 1800;
    /// Slope variance of the waves too short for any map, e.g. those that a buoy does not measure:
    /// light meets them too. Added to that of the waves filtered away.
    double unresolved_slope_variance = 0.0;
};

/// Metres to the horizon of still water from `height` metres above it: sqrt(2 R h).
double horizon_distance(double height);

/// Mean slope towards the eye of those facets of a rough surface that the eye sees. `slope_rms`: of
/// the slopes along the line of sight, Gaussian; `elevation_slope`: tangent of the eye's elevation
/// as seen from the mean surface, negative on a side turned away. See visible_slope.cpp.
double mean_visible_slope(double slope_rms, double elevation_slope);

/// A fan of the sea in front of an eye, dense near and coarse far, to the horizon of a round Earth.
/// `levels` are maps of one sea and time, from the finest resolution to the coarsest, each half the
/// one before: each vertex takes what its distance can show, so that nothing aliases, and its
/// normal is turned to the eye by what the filtered-away waves would have shown of themselves.
/// Needs dx, dy, height, nx, ny, nz, slope_x, slope_y. Throws Error invalid_value.
Mesh make_horizon_mesh(std::span<const Surface> levels, const View& view);

/// Triangles as the face_indices of a mesh2.
std::string povray_faces(std::span<const int> triangles);
/// A POV-Ray include file that declares `Ocean_Surface` as a mesh2 in POV-Ray's axes (x, z, y), and
/// Ocean_Time, Ocean_Period, Ocean_Frame_Number; foam is the u of its uv. With a view also its
/// camera: Ocean_Eye, Ocean_Forward, Ocean_View_Angle. Throws Error output.
void write_mesh2(const Mesh& mesh, const Frame& frame, const std::string& path,
                 const View* view = nullptr);

}  // namespace ocean::io
