// SPDX-License-Identifier: Apache-2.0
#include "common.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>

#include "dewbow/base/error.h"
#include "dewbow/base/file.h"
#include "dewbow/image/exr.h"

namespace dewbow::bench {

double relative_index(const PlainScene& scene, const PlainBody& body, Wavelength lambda) {
    return (*body.index)(lambda).value / (*scene.surrounding_index)(lambda).value;
}

double relative_index(const PlainScene& scene, Wavelength lambda) {
    return relative_index(scene, scene.bodies[0], lambda);
}

std::array<Vec3, 4> corners(const PlainLamp& lamp) {
    const Vec3 c = lamp.centre, u = lamp.half_u, v = lamp.half_v;
    return {c - u - v, c + u - v, c + u + v, c - u + v};
}

PlainLamp lamp_for(const PlainSun& sun) {
    constexpr double kDistance_m = 50.0;
    const Tangents frame = tangents_of(sun.direction);
    const double sine = std::sin(sun.angular_radius_rad);
    const double radius = kDistance_m * std::tan(sun.angular_radius_rad);
    PlainLamp lamp;
    lamp.name = "sun";
    lamp.shape = LampShape::disc;
    lamp.centre = -sun.direction * kDistance_m;
    lamp.normal = sun.direction;
    lamp.half_u = frame.t * radius;
    lamp.half_v = frame.b * radius;
    lamp.radiance = sun.irradiance;  // its shape alone counts
    lamp.colour = sun.colour * (1.0 / (std::numbers::pi * sine * sine));
    return lamp;
}

std::string joined(Vec3 v, const char* between) {
    return fmt::format("{}{}{}{}{}", v.x, between, v.y, between, v.z);
}

std::string joined(const Colour<LinearSrgb>& colour, const char* between) {
    return joined(Vec3{colour[0], colour[1], colour[2]}, between);
}

SceneOrder scene_order(const Order& order) {
    return {order.scene.plain, order.knobs, order.threads, order.scene.scene.render.max_depth};
}

Picture read_left_picture(const Order& order) {
    const std::filesystem::path path = order.folder / kPictureFile;
    const Image image = decode_exr(read_file(path), path.string()).image;
    const PlainCamera& camera = order.scene.plain.camera;
    Picture picture = picture_of(image, path.string());
    if (picture.width != camera.width || picture.height != camera.height)
        throw InputError(fmt::format("{}: expected a picture of {} × {} pixels", path.string(),
                                     camera.width, camera.height));
    return picture;
}

std::string version_line(const std::filesystem::path& program, const std::string& option,
                         const std::string& with) {
    const std::string command = fmt::format("'{}' {} 2>&1 </dev/null", program.string(), option);
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string said;
    for (int c = 0; pipe && (c = std::fgetc(pipe.get())) != EOF;) said += char(c);
    const std::size_t begin = said.find(with);
    return begin == std::string::npos ? "?" : said.substr(begin, said.find('\n', begin) - begin);
}

}  // namespace dewbow::bench
