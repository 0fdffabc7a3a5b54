// SPDX-License-Identifier: Apache-2.0
// Ranks in threads of this program, with a coordinator that is the one of MPI. The oracle is the
// film of the undivided render.

#include <gtest/gtest.h>

#include <thread>

#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/base/random.h"
#include "dewbow/render/farm/in_process_ranks.h"
#include "dewbow/render/farm/lease_work.h"
#include "dewbow/render/farm/team.h"
#include "dewbow/render/farm/worker.h"
#include "dewbow/render/spark_estimator.h"

namespace dewbow {
namespace {

/// Noise by the rules of a true estimator: a function of pixel and index. Every hundredth sample or
/// so is invalid.
class Noise : public Estimator {
public:
    void render(const Unit& unit, FilmSums& film) const override {
        if (on_unit) on_unit();
        for (int y = unit.tile.y0; y < unit.tile.y1; ++y)
            for (int x = unit.tile.x0; x < unit.tile.x1; ++x)
                for (std::int64_t i = unit.first_sample; i < unit.end_sample; ++i)
                    film.add(x, y, sample(x, y, i), i);
    }
    std::function<void()> on_unit;

private:
    static PixelSample sample(int x, int y, std::int64_t index) {
        const SampleKey key(stream_key(1, std::uint32_t(x), std::uint32_t(y)),
                            std::uint32_t(index));
        PixelSample result;
        result.wavelengths =
            sample_wavelengths(WavelengthSampling::visual, 4, key.one(0, Purpose::wavelength));
        for (std::uint32_t k = 0; k < 4; ++k) result.radiance[k] = key.one(k, Purpose::test);
        if (result.radiance[0] < 0.01) result.radiance[1] = -1.0;
        return result;
    }
};

constexpr FilmLayout kLayout{70, 40, {2, 3, 69, 40}, 3, 0};
constexpr std::int64_t kSamples = 41;

RenderIdentity identity() {
    RenderIdentity identity;
    identity.film = kLayout;
    identity.samples_per_pixel = kSamples;
    return identity;
}

struct Picture {
    explicit Picture(RenderIdentity of = identity()) : state(std::move(of)) {}
    RenderState state;
    LiveState live{state};
    std::size_t finished() const { return state.plan.finished_units(); }
    std::size_t units() const { return state.plan.units(); }
};

std::uint64_t undivided_hash() {
    FilmSums film(kLayout);
    Noise().render({kLayout.crop, 0, kSamples}, film);
    return film.fingerprint();
}

/// What one rank other than 0 does in a test.
using RankBody = std::function<void(InProcessTransport&)>;

RankBody good_rank() {
    return
        [](InProcessTransport& transport) { work_for_rank_0(transport, Noise(), identity(), 1); };
}
/// @param letters  after which it is heard of no more
RankBody dying_rank(int letters) {
    return [letters](InProcessTransport& transport) {
        transport.letters_of_its_life = letters;
        constexpr double kSilence = 0.1;  // s: it hears no more, and ends
        work_for_rank_0(transport, Noise(), identity(), 1, kSilence);
    };
}

struct Outcome {
    TeamReport report;
    bool all_have_left = false;
    std::vector<std::string> warnings;
};

/// How a test wants the render to go.
struct Wish {
    const Estimator& estimator;
    std::size_t end_pass = 1000;
    std::function<bool()> stopped = [] { return false; };
    int threads_of_rank_0 = 1;
};

Outcome render_with(const std::vector<RankBody>& others, Picture& picture,
                    const Wish& wish = {Noise()}) {
    constexpr double kParting = 0.3;  // s
    PostOffice office(1 + static_cast<int>(others.size()));
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < others.size(); ++i)
        threads.emplace_back([&office, &others, i] {
            InProcessTransport transport(office, 1 + static_cast<int>(i));
            others[i](transport);
        });
    InProcessTransport transport(office, 0);
    Outcome outcome;
    Team team(transport,
              {wish.threads_of_rank_0,
               [&](const std::string& text) { outcome.warnings.push_back(text); }, kParting});
    team.render(
        wish.estimator, picture.state, picture.live,
        std::min(wish.end_pass, picture.state.plan.passes()), [](std::size_t) {}, wish.stopped);
    team.part();
    outcome.report = team.report();
    outcome.all_have_left = team.all_have_left();
    return outcome;
}

void expect_whole(const Picture& picture) {
    EXPECT_EQ(picture.finished(), picture.units());
    EXPECT_EQ(picture.state.film.fingerprint(), undivided_hash());
    EXPECT_GT(picture.state.film.invalid_samples(), 0);
}

TEST(Team, AnyNumberOfRanksGivesTheSameFilm) {
    for (const std::size_t others : {0u, 1u, 2u, 7u}) {
        Picture picture;
        const Outcome outcome = render_with(std::vector<RankBody>(others, good_rank()), picture);
        expect_whole(picture);
        EXPECT_TRUE(outcome.warnings.empty());
    }
}

TEST(Team, RankZeroNeedNotRender) {
    Picture picture;
    const Noise noise;
    const Outcome outcome =
        render_with({good_rank()}, picture, {.estimator = noise, .threads_of_rank_0 = 0});
    expect_whole(picture);
    EXPECT_TRUE(outcome.all_have_left);
    EXPECT_EQ(outcome.report.units_of_rank[0], 0u);
    EXPECT_EQ(outcome.report.units_of_rank[1], picture.units());
}

TEST(Team, UnitsOfRanksThatDieAreRenderedByOthers) {
    for (const int letters : {0, 1, 2, 3, 5}) {
        Picture picture;
        const Outcome outcome = render_with({dying_rank(letters), good_rank()}, picture);
        expect_whole(picture);
        EXPECT_FALSE(outcome.all_have_left) << "the fault did not fire";
    }
}

TEST(Team, ADeadRanksLeasesAreDealtAgain) {
    // Hello and request go out, so that it holds two leases; no result ever does.
    Picture picture;
    const Noise noise;
    const Outcome outcome = render_with({dying_rank(2), good_rank()}, picture,
                                        {.estimator = noise, .threads_of_rank_0 = 0});
    expect_whole(picture);
    EXPECT_GE(outcome.report.leases_dealt_again, 1u) << "the fault did not fire";
}

TEST(Team, ARankOfAnotherRenderDoesNotTakePart) {
    Picture picture;
    const Outcome outcome = render_with({[](InProcessTransport& transport) {
                                            RenderIdentity other = identity();
                                            other.seed = 5;
                                            work_for_rank_0(transport, Noise(), other, 1);
                                        }},
                                        picture);
    expect_whole(picture);
    EXPECT_EQ(outcome.report.units_of_rank[1], 0u);
    const std::vector<std::string> expected{
        "rank 1 does not take part: the seed is 0 in rank 0 and 5 in rank 1"};
    EXPECT_EQ(outcome.warnings, expected);
}

TEST(Team, ARankThatCannotTakePartSaysWhy) {
    Picture picture;
    const Outcome outcome = render_with(
        {[](InProcessTransport& transport) { say_bye(transport, "no such file"); }}, picture);
    expect_whole(picture);
    EXPECT_TRUE(outcome.all_have_left);
    EXPECT_EQ(outcome.warnings,
              std::vector<std::string>{"rank 1 does not take part: no such file"});
}

TEST(Team, SumsThatNobodyAskedForAreLeftOut) {
    Picture picture;
    const Noise noise;
    const auto liar = [](InProcessTransport& transport) {
        transport.send(0, bytes_of(message::Hello{identity_bytes(identity()), 1}));
        std::optional<Message> message;
        while (!message || !std::holds_alternative<message::Work>(*message))
            if (const auto letter = transport.receive())
                message = message_from_bytes(letter->bytes);
        const Lease& lease = std::get<message::Work>(*message).lease;
        UnitRun run = lease.runs[0];
        run.number += 1000;
        transport.send(0, bytes_of(message::Result{lease.number, {{run, "x", {}}}, 0.0}));
        transport.send(0, bytes_of(message::Bye{}));
    };
    const Outcome outcome =
        render_with({liar, good_rank()}, picture, {.estimator = noise, .threads_of_rank_0 = 0});
    expect_whole(picture);
    const std::vector<std::string> expected{
        "rank 1: it sent sums of other units than it was asked for"};
    EXPECT_EQ(outcome.warnings, expected);
}

TEST(Team, GoesOnWhereAStateEnded) {
    Picture picture;
    const Noise noise;
    const UnitPlan& plan = picture.state.plan;
    std::size_t n = 0;
    for (std::size_t pass = 0; pass < plan.passes(); ++pass)
        for (std::size_t tile = 0; tile < plan.tiles(); ++tile)
            if (n++ % 3 == 0) {
                const Lease lease{0, {{tile, pass, pass + 1}}};
                add_pieces(render_lease(lease, noise, plan, kLayout, [] { return false; }), plan,
                           kLayout, picture.live);
            }
    render_with({good_rank()}, picture);
    expect_whole(picture);
}

TEST(Team, StopsAndKeepsWhatIsFinished) {
    Noise noise;
    std::atomic<int> units{0};
    noise.on_unit = [&] { ++units; };
    Picture picture;
    render_with({good_rank()}, picture,
                {.estimator = noise, .stopped = [&] { return units >= 20; }});
    EXPECT_LT(picture.finished(), picture.units()) << "the fault did not fire";
    EXPECT_GE(picture.finished(), 20u);

    // What it kept is what it says: the rest makes it whole.
    render_with({}, picture);
    expect_whole(picture);
}

TEST(Team, EndsAtThePassThatIsEnough) {
    Picture picture;
    const Noise noise;
    render_with({good_rank(), good_rank()}, picture, {.estimator = noise, .end_pass = 2});
    EXPECT_EQ(picture.finished(), 2 * picture.state.plan.tiles());
    EXPECT_EQ(picture.state.plan.first_open_pass(), 2u);
}

TEST(Team, AWorkerDoesNotWaitForEverForRankZero) {
    PostOffice office(2);
    InProcessTransport transport(office, 1);
    constexpr double kSilence = 0.05;  // s
    EXPECT_EQ(work_for_rank_0(transport, Noise(), identity(), 1, kSilence), Parting::rank_0_lost);
}

TEST(LeaseWork, RefusesUnitsThatAreFinishedAndPixelsOfAnotherSize) {
    Picture picture;
    const Lease lease{0, {{0, 0, 2}}};
    const message::Result result =
        render_lease(lease, Noise(), picture.state.plan, kLayout, [] { return false; });
    const auto check = [&](const message::Result& r) {
        check_pieces(r, picture.state.plan, kLayout);
    };
    EXPECT_NO_THROW(check(result));
    message::Result longer = result;
    longer.pieces[0].sums += "x";
    EXPECT_THROW(check(longer), InputError);
    message::Result twice = result;
    twice.pieces.push_back(result.pieces[0]);
    EXPECT_THROW(check(twice), InputError);
    message::Result elsewhere = result;
    elsewhere.pieces[0].run.end_pass = picture.state.plan.passes() + 1;
    EXPECT_THROW(check(elsewhere), InputError);

    add_pieces(result, picture.state.plan, kLayout, picture.live);
    EXPECT_THROW(check(result), InputError);
}

// ---- with light paths --------------------------------------------------------------------------

SparkEstimator sparks() {
    SparkEstimator estimator(kLayout.width, kLayout.height, 1.0);  // 11200 paths a pass: 2 units
    estimator.invalid_share = 0.001;
    return estimator;
}

RenderIdentity identity_of_sparks() {
    RenderIdentity of = identity();
    of.light_paths = sparks().light_paths();
    return of;
}

RankBody sparkling_rank(int letters = 1 << 30) {
    return [letters](InProcessTransport& transport) {
        transport.letters_of_its_life = letters;
        constexpr double kSilence = 1.0;  // s: one that is dead hears no more, and ends
        work_for_rank_0(transport, sparks(), identity_of_sparks(), 1, kSilence);
    };
}

TEST(LightTeam, AnyNumberOfRanksGivesTheSameFilm) {
    const SparkEstimator estimator = sparks();
    const FilmSums expected = undivided_film(estimator, kLayout, kSamples, kSamplesPerPass);
    const std::vector<std::vector<RankBody>> teams{
        {},
        {sparkling_rank(), sparkling_rank()},
        {sparkling_rank(2), sparkling_rank()},  // one dies with its leases
        {sparkling_rank(5), sparkling_rank()}};
    for (const std::vector<RankBody>& others : teams) {
        Picture picture(identity_of_sparks());
        render_with(others, picture, {.estimator = estimator});
        EXPECT_EQ(picture.finished(), picture.units());
        EXPECT_EQ(picture.state.film.fingerprint(), expected.fingerprint()) << others.size();
        EXPECT_EQ(picture.state.film.invalid().splats, expected.invalid().splats);
    }
    EXPECT_GT(expected.invalid().splats, 0);
}

TEST(LightTeam, RanksRenderAllOfIt) {
    const SparkEstimator estimator = sparks();
    Picture picture(identity_of_sparks());
    const Outcome outcome =
        render_with({sparkling_rank()}, picture, {.estimator = estimator, .threads_of_rank_0 = 0});
    EXPECT_EQ(outcome.report.units_of_rank[1], picture.units());
    EXPECT_EQ(picture.state.film.fingerprint(),
              undivided_film(estimator, kLayout, kSamples, kSamplesPerPass).fingerprint());
}

TEST(LeaseWork, RefusesSplatsThatCannotBe) {
    Picture picture(identity_of_sparks());
    const UnitPlan& plan = picture.state.plan;
    const Lease lease{0, {{plan.tiles() + 1, 2, 3}}};
    const message::Result result =
        render_lease(lease, sparks(), plan, kLayout, [] { return false; });
    const auto check = [&](const message::Result& r) { check_pieces(r, plan, kLayout); };
    EXPECT_NO_THROW(check(result));
    message::Result longer = result;
    longer.pieces[0].sums += "x";
    EXPECT_THROW(check(longer), InputError);
    message::Result elsewhere = result;
    elsewhere.pieces[0].run.number = 0;  // a tile
    EXPECT_THROW(check(elsewhere), InputError);
    elsewhere.pieces[0].run.number = plan.units_per_pass();
    EXPECT_THROW(check(elsewhere), InputError);
    add_pieces(result, plan, kLayout, picture.live);
    EXPECT_THROW(check(result), InputError);
}

}  // namespace
}  // namespace dewbow
