// SPDX-License-Identifier: Apache-2.0
// Ranks in threads of this program, with a coordinator that is the one of MPI. The oracle is the
// film of the undivided render.

#include <gtest/gtest.h>

#include <thread>

#include "dewbow/base/error.h"
#include "dewbow/base/parallel.h"
#include "dewbow/base/random.h"
#include "dewbow/render/farm/coordinator.h"
#include "dewbow/render/farm/in_process_ranks.h"
#include "dewbow/render/farm/lease_work.h"
#include "dewbow/render/farm/worker.h"

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
const std::string kIdentity = "this render";

struct Picture {
    UnitPlan plan{kLayout.crop, kSamples};
    FilmSums film{kLayout};
};

std::uint64_t undivided_hash() {
    Picture picture;
    const Noise noise;
    noise.render({kLayout.crop, 0, kSamples}, picture.film);
    return picture.film.fingerprint();
}

TeamOptions options() {
    TeamOptions options;
    options.identity = kIdentity;
    options.difference = [](const std::string& identity, int) { return "it is of " + identity; };
    options.threads = 1;
    return options;
}

/// What one rank other than 0 does in a test.
using RankBody = std::function<void(InProcessTransport&)>;

void work(InProcessTransport& transport, const std::string& identity = kIdentity) {
    const Picture picture;
    const Noise noise;
    work_for_rank_0(transport, noise, picture.plan, kLayout, identity, 1);
}
RankBody good_rank() {
    return [](InProcessTransport& transport) { work(transport); };
}
/// @param letters  after which it is heard of no more
RankBody dying_rank(int letters) {
    return [letters](InProcessTransport& transport) {
        transport.letters_of_its_life = letters;
        const Picture picture;
        const Noise noise;
        constexpr double kSilence = 0.1;  // s: it hears no more, and ends
        work_for_rank_0(transport, noise, picture.plan, kLayout, kIdentity, 1, kSilence);
    };
}

TeamReport render_with(const std::vector<RankBody>& others, Picture& picture,
                       const TeamOptions& options, const Estimator& estimator = Noise()) {
    PostOffice office(1 + static_cast<int>(others.size()));
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < others.size(); ++i)
        threads.emplace_back([&office, &others, i] {
            InProcessTransport transport(office, 1 + static_cast<int>(i));
            others[i](transport);
        });
    InProcessTransport transport(office, 0);
    return coordinate(transport, estimator, picture.plan, picture.film, options);
}

void expect_whole(const Picture& picture) {
    EXPECT_EQ(picture.plan.finished_units(), picture.plan.units());
    EXPECT_EQ(picture.film.fingerprint(), undivided_hash());
    EXPECT_GT(picture.film.invalid_samples(), 0);
}

TEST(Team, AnyNumberOfRanksGivesTheSameFilm) {
    for (const std::size_t others : {0u, 1u, 2u, 7u}) {
        Picture picture;
        const TeamReport report =
            render_with(std::vector<RankBody>(others, good_rank()), picture, options());
        expect_whole(picture);
        EXPECT_TRUE(report.all_present);
    }
}

TEST(Team, RankZeroNeedNotRender) {
    TeamOptions only_coordinates = options();
    only_coordinates.threads = 0;
    Picture picture;
    const TeamReport report = render_with({good_rank()}, picture, only_coordinates);
    expect_whole(picture);
    EXPECT_EQ(report.units_of_rank[0], 0u);
    EXPECT_EQ(report.units_of_rank[1], picture.plan.units());
}

TEST(Team, UnitsOfRanksThatDieAreRenderedByOthers) {
    for (const int letters : {0, 1, 2, 3, 5}) {
        TeamOptions impatient = options();
        impatient.longest_parting = 0.2;
        Picture picture;
        const TeamReport report =
            render_with({dying_rank(letters), good_rank()}, picture, impatient);
        expect_whole(picture);
        EXPECT_FALSE(report.all_present) << "the fault did not fire";
    }
}

TEST(Team, ADeadRanksLeasesAreDealtAgain) {
    // Hello and request go out, so that it holds two leases; no result ever does.
    TeamOptions impatient = options();
    impatient.longest_parting = 0.2;
    impatient.threads = 0;
    Picture picture;
    const TeamReport report = render_with({dying_rank(2), good_rank()}, picture, impatient);
    expect_whole(picture);
    EXPECT_GE(report.leases_dealt_again, 1u) << "the fault did not fire";
}

TEST(Team, ARankOfAnotherRenderDoesNotTakePart) {
    std::vector<std::string> warnings;
    TeamOptions listening = options();
    listening.warn = [&](const std::string& warning) { warnings.push_back(warning); };
    Picture picture;
    const TeamReport report =
        render_with({[](InProcessTransport& transport) { work(transport, "another one"); }},
                    picture, listening);
    expect_whole(picture);
    EXPECT_EQ(report.units_of_rank[1], 0u);
    EXPECT_TRUE(report.all_present);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0], "rank 1 does not take part: it is of another one");
}

TEST(Team, ARankThatCannotTakePartSaysWhy) {
    std::vector<std::string> warnings;
    TeamOptions listening = options();
    listening.warn = [&](const std::string& warning) { warnings.push_back(warning); };
    Picture picture;
    const TeamReport report =
        render_with({[](InProcessTransport& transport) { say_bye(transport, "no such file"); }},
                    picture, listening);
    expect_whole(picture);
    EXPECT_TRUE(report.all_present);
    EXPECT_EQ(warnings, std::vector<std::string>{"rank 1 does not take part: no such file"});
}

TEST(Team, SumsThatNobodyAskedForAreLeftOut) {
    std::vector<std::string> warnings;
    TeamOptions listening = options();
    listening.warn = [&](const std::string& warning) { warnings.push_back(warning); };
    listening.longest_parting = 0.2;
    Picture picture;
    render_with({[](InProcessTransport& transport) {
                    transport.send(0, bytes_of(message::Hello{kIdentity, 1}));
                    std::optional<Letter> letter;
                    while (!(letter = transport.receive())) std::this_thread::yield();
                    auto work = std::get<message::Work>(message_from_bytes(letter->bytes));
                    work.lease.runs[0].tile += 1000;
                    transport.send(0, bytes_of(message::Result{work.lease, "x", {}, 0.0}));
                }},
                picture, listening);
    expect_whole(picture);
    EXPECT_EQ(warnings.size(), 1u);
}

TEST(Team, GoesOnWhereAStateEnded) {
    Picture picture;
    const Noise noise;
    std::size_t n = 0;
    for (std::size_t pass = 0; pass < picture.plan.passes(); ++pass)
        for (std::size_t tile = 0; tile < picture.plan.tiles(); ++tile)
            if (n++ % 3 == 0) {
                noise.render(picture.plan.unit(pass, tile), picture.film);
                picture.plan.set_finished(pass, tile);
            }
    render_with({good_rank()}, picture, options());
    expect_whole(picture);
}

TEST(Team, StopsAndKeepsWhatIsFinished) {
    std::atomic<bool> stop{false};
    TeamOptions stoppable = options();
    stoppable.stop = &stop;
    Noise noise;
    std::atomic<int> units{0};
    noise.on_unit = [&] {
        if (++units == 20) stop = true;
    };
    Picture picture;
    render_with({good_rank()}, picture, stoppable, noise);
    EXPECT_LT(picture.plan.finished_units(), picture.plan.units()) << "the fault did not fire";
    EXPECT_GE(picture.plan.finished_units(), 20u);

    // What it kept is what it says: the rest makes it whole.
    render_with({}, picture, options());
    expect_whole(picture);
}

TEST(Team, EndsAtThePassThatIsEnough) {
    TeamOptions two_passes = options();
    two_passes.enough = [](std::size_t passes) { return passes == 2; };
    Picture picture;
    render_with({good_rank(), good_rank()}, picture, two_passes);
    EXPECT_EQ(picture.plan.finished_units(), 2 * picture.plan.tiles());
    EXPECT_EQ(picture.plan.first_open_pass(), 2u);
}

TEST(Team, AWorkerDoesNotWaitForEverForRankZero) {
    PostOffice office(2);
    InProcessTransport transport(office, 1);
    const Picture picture;
    constexpr double kSilence = 0.05;  // s
    EXPECT_EQ(work_for_rank_0(transport, Noise(), picture.plan, kLayout, kIdentity, 1, kSilence),
              Parting::rank_0_lost);
}

TEST(LeaseWork, RefusesUnitsThatAreFinishedAndPixelsOfAnotherSize) {
    Picture picture;
    const Noise noise;
    const Lease lease{0, {{0, 0, 2}}};
    const message::Result result =
        render_lease(lease, noise, picture.plan, kLayout, [] { return false; });
    message::Result longer = result;
    longer.pixels += "x";
    EXPECT_THROW(add_result(longer, picture.plan, picture.film), InputError);
    message::Result twice = result;
    twice.lease.runs.push_back(lease.runs[0]);
    twice.pixels += result.pixels;
    EXPECT_THROW(add_result(twice, picture.plan, picture.film), InputError);
    EXPECT_EQ(picture.plan.finished_units(), 0u);

    add_result(result, picture.plan, picture.film);
    const std::uint64_t hash = picture.film.fingerprint();
    EXPECT_THROW(add_result(result, picture.plan, picture.film), InputError);
    EXPECT_EQ(picture.film.fingerprint(), hash);
}

}  // namespace
}  // namespace dewbow
