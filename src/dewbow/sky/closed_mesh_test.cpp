// SPDX-License-Identifier: Apache-2.0
#include "dewbow/sky/closed_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace dewbow {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Lines of some 10 m through bodies of some 10 m: roundings of 1e-14 m, over cosines above 1e-4.
constexpr double kRounding_m = 1e-9;

struct Surface {
    std::vector<Vec3> vertices;
    std::vector<TriangleIndices> triangles;

    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
    ClosedMesh mesh() const { return ClosedMesh(vertices, triangles); }
};

/// Six faces with vertices of their own, as files have them that shade faces flat.
void add_box(Surface& surface, const Affine& world_from_box, Vec3 half) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            const std::uint32_t first = std::uint32_t(surface.vertices.size());
            for (int corner = 0; corner < 4; ++corner) {
                double p[3];
                p[axis] = side;
                p[(axis + 1) % 3] = corner == 1 || corner == 2 ? 1.0 : -1.0;
                p[(axis + 2) % 3] = corner >= 2 ? 1.0 : -1.0;
                surface.vertices.push_back(
                    world_from_box.apply({half.x * p[0], half.y * p[1], half.z * p[2]}));
            }
            surface.add_quad(first, first + 1, first + 2, first + 3);
        }
    }
}

/// Around the y axis: a body with a hole, which light may enter twice.
Surface torus(double ring, double tube, int around, int across) {
    Surface surface;
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            const double a = 2.0 * std::numbers::pi * i / around,
                         b = 2.0 * std::numbers::pi * j / across;
            const double r = ring + tube * std::cos(b);
            surface.vertices.push_back({r * std::cos(a), tube * std::sin(b), r * std::sin(a)});
            const auto at = [&](int k, int l) {
                return std::uint32_t((k % around) * across + l % across);
            };
            surface.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        }
    }
    return surface;
}

class Lines {
public:
    double number() { return unit_(random_); }
    Vec3 place(double size) { return {size * number(), size * number(), size * number()}; }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = place(1.0);
            if (length(v) > 0.1 && length(v) < 1.0) return normalised(v);
        }
    }

private:
    std::mt19937_64 random_{8};
    std::uniform_real_distribution<double> unit_{-1.0, 1.0};
};

double length_by_cut(const ClosedMesh& mesh, Vec3 from, Vec3 towards) {
    std::vector<LineInterval> inside;
    mesh.cut({from}, {towards}, kInfinity, inside);
    double sum = 0.0;
    for (const LineInterval& part : inside) sum += part.end - part.begin;
    return sum;
}

void expect_gapless(const std::vector<LengthPiece>& pieces, LineInterval on) {
    ASSERT_FALSE(pieces.empty());
    EXPECT_EQ(pieces.front().begin, on.begin);
    EXPECT_EQ(pieces.back().end, on.end);
    for (std::size_t k = 1; k < pieces.size(); ++k) EXPECT_EQ(pieces[k].begin, pieces[k - 1].end);
}

double at(const std::vector<LengthPiece>& pieces, double s) {
    for (const LengthPiece& piece : pieces) {
        if (s < piece.end) return piece.length + piece.slope * (s - piece.begin);
    }
    return 0.0;
}

TEST(ClosedMesh, ABoxOfTrianglesIsTheBox) {
    const Affine placed =
        translation({1, 2, -3}) * rotation(normalised({1, 2, 3}), 40.0 * unit::deg);
    const Vec3 half{4, 5, 6};
    const ConvexRegion box = ConvexRegion::box(Transform<World, Object>(placed), half);
    Surface surface;
    add_box(surface, placed, half);
    const ClosedMesh mesh = surface.mesh();
    Lines lines;
    int met = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 from = lines.place(10.0), d = lines.direction(), sun = lines.direction();
        const auto expected = box.cut({from}, {d}, 15.0);
        std::vector<LineInterval> found;
        mesh.cut({from}, {d}, 15.0, found);
        ASSERT_EQ(found.size(), expected ? 1u : 0u) << i;
        if (!expected) continue;
        ++met;
        EXPECT_NEAR(found[0].begin, expected->begin, kRounding_m);
        EXPECT_NEAR(found[0].end, expected->end, kRounding_m);
        std::vector<LengthPiece> by_mesh, by_box;
        const LineInterval on{0.0, kInfinity};
        mesh.lengths_towards({from}, {d}, on, {sun}, by_mesh);
        box.lengths_towards({from}, {d}, on, {sun}, by_box);
        expect_gapless(by_mesh, on);
        for (double s = 0.01; s < 30.0; s += 0.9)
            EXPECT_NEAR(at(by_mesh, s), at(by_box, s), kRounding_m) << i << " " << s;
    }
    EXPECT_GT(met, 200);
}

TEST(ClosedMesh, LengthsTowardsADirectionAreExactInABodyWithAHole) {
    const ClosedMesh mesh = torus(5.0, 2.0, 40, 20).mesh();
    Lines lines;
    double longest = 0.0;
    for (int i = 0; i < 300; ++i) {
        const Vec3 from = lines.place(8.0), d = lines.direction(), sun = lines.direction();
        const LineInterval on{1.0, 12.0};
        std::vector<LengthPiece> pieces;
        mesh.lengths_towards({from}, {d}, on, {sun}, pieces);
        expect_gapless(pieces, on);
        for (double s = 1.003; s < 12.0; s += 0.37) {
            const double expected = length_by_cut(mesh, from + d * s, sun);
            EXPECT_NEAR(at(pieces, s), expected, kRounding_m) << i << " " << s;
            longest = std::max(longest, expected);
        }
    }
    EXPECT_GT(longest, 6.0);
}

TEST(ClosedMesh, LightAlongTheLineItself) {
    const ClosedMesh mesh = torus(5.0, 2.0, 40, 20).mesh();
    Lines lines;
    for (int i = 0; i < 100; ++i) {
        const Vec3 from = lines.place(8.0), d = lines.direction();
        for (const Vec3 sun : {d, -d}) {
            const LineInterval on{0.5, kInfinity};
            std::vector<LengthPiece> pieces;
            mesh.lengths_towards({from}, {d}, on, {sun}, pieces);
            expect_gapless(pieces, on);
            for (double s = 0.503; s < 20.0; s += 0.37) {
                EXPECT_NEAR(at(pieces, s), length_by_cut(mesh, from + d * s, sun), kRounding_m)
                    << i << " " << s;
            }
        }
    }
}

// Lines that meet vertices and edges exactly, or run along facets: what they find inside is what
// lies beside them on one side or the other, and nothing leaks to infinity.
TEST(ClosedMesh, EdgesAndVerticesCountOnce) {
    Surface surface;
    add_box(surface, Affine{}, {1, 1, 1});
    const ClosedMesh mesh = surface.mesh();
    const Vec3 sun = normalised({1, -1, 0});  // in the planes of diagonals
    for (const Vec3 d : {Vec3{0, 0, 1}, normalised({0, 1, 1}), normalised({1, 1, 1})}) {
        for (int x = -2; x <= 2; ++x) {
            for (int y = -2; y <= 2; ++y) {
                const Vec3 through{double(x), double(y), 0.0}, from = through - d * 10.0;
                const double inside = length_by_cut(mesh, from, d);
                const bool deep = std::abs(x) + std::abs(y) == 0,
                           off = std::abs(x) == 2 && d.x == 0;
                if (deep) {
                    EXPECT_NEAR(inside, 2.0 / d.z, kRounding_m);
                }
                EXPECT_LE(inside, off ? 0.0 : 2.0 / d.z + kRounding_m);
                std::vector<LengthPiece> pieces;
                mesh.lengths_towards({from}, {d}, {0.0, 40.0}, {sun}, pieces);
                for (const LengthPiece& piece : pieces)
                    EXPECT_LE(piece.length, 2.0 * std::numbers::sqrt2 + kRounding_m);
            }
        }
    }
}

TEST(ClosedMesh, TheVolumeByLinesIsThatOfTheTriangles) {
    const Surface surface = torus(5.0, 2.0, 40, 20);
    double volume = 0.0;  // of tetrahedra to the origin
    for (const TriangleIndices& t : surface.triangles) {
        volume +=
            dot(surface.vertices[t[0]], cross(surface.vertices[t[1]], surface.vertices[t[2]])) /
            6.0;
    }
    const ClosedMesh mesh = surface.mesh();
    constexpr int kLines = 200;  // to a side; the mean of 40 000 lines misses by 1e-3
    const Vec3 down = normalised({0.2, -1.0, 0.1});
    double sum = 0.0;
    const double size = 24.0;
    for (int i = 0; i < kLines; ++i) {
        for (int k = 0; k < kLines; ++k) {
            const Vec3 through{size * ((i + 0.5) / kLines - 0.5), 0.0,
                               size * ((k + 0.5) / kLines - 0.5)};
            const Vec3 from = through - down * 40.0;
            sum += length_by_cut(mesh, from, down) * -down.y;
        }
    }
    EXPECT_NEAR(sum * size * size / (kLines * kLines) / std::abs(volume), 1.0, 1e-3);
}

TEST(ClosedMesh, AHoleIsNamed) {
    Surface surface;
    add_box(surface, Affine{}, {1, 1, 1});
    EXPECT_FALSE(ClosedMesh::open_edges(surface.vertices, surface.triangles));
    surface.triangles.pop_back();
    const auto open = ClosedMesh::open_edges(surface.vertices, surface.triangles);
    ASSERT_TRUE(open);
    EXPECT_EQ(open->count, 3u);
    EXPECT_EQ(std::abs(open->from.x), 1.0);
}

TEST(ClosedMesh, NothingHasNoInside) {
    const ClosedMesh mesh({}, {});
    EXPECT_EQ(length_by_cut(mesh, {0, 0, 0}, {0, 0, 1}), 0.0);
}

}  // namespace
}  // namespace dewbow
