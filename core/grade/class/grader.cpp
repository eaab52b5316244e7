// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/grade/class/grader.h"

#include "core/frame/framebuffer.h"
#include "core/grade/class/delivery.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/grade/pictures/wrongplaces.h"

#include <algorithm>
#include <cmath>

namespace pixelplumb {

namespace {

/// Counts pixels that should be covered, without those left open.
struct CoveredTally {
    std::int64_t asked = 0;
    std::int64_t there = 0; ///< the covered ones of these
    std::int64_t right = 0; ///< those of these with the right bytes
};

CoveredTally tallyOf(const Picture &expected, const PictureDiff &diff)
{
    CoveredTally tally;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected.covered[i] == 0 || diff.verdicts[i] == Difference::Undecidable)
            continue;
        ++tally.asked;
        tally.there += diff.verdicts[i] != Difference::Missing ? 1 : 0;
        tally.right += diff.verdicts[i] == Difference::None ? 1 : 0;
    }
    return tally;
}

bool isPassed(Check check, const Picture &expected, const Delivery &delivery,
              const PictureDiff &diff)
{
    const Picture &found = *delivery.picture;
    switch (check) {
    case Check::Picture:
        return true;
    case Check::Coverage:
        return diff.count(Difference::Missing) + diff.count(Difference::Extra) == 0;
    case Check::Invariants:
        return delivery.brokenInvariants && delivery.brokenInvariants->empty();
    case Check::Colours:
        break;
    }
    const CoveredTally tally = tallyOf(expected, diff);
    return found.hasColours && 2 * tally.there >= tally.asked
        && diff.count(Difference::Colour) == 0;
}

/// The points for a failed check, rounded down to hundredths. Coverage: the pixels rightly covered,
/// as a share of those that are or should be covered. Colours: those with the right bytes, as a
/// share of the covered ones, but at least of half of those that should be covered.
double pointsInPart(const GradedCheck &check, const Picture &expected, const Picture &found,
                    const PictureDiff &diff)
{
    const bool hasParts
        = check.check == Check::Coverage || (check.check == Check::Colours && found.hasColours);
    if (!hasParts)
        return 0;
    const CoveredTally tally = tallyOf(expected, diff);
    const bool isCoverage = check.check == Check::Coverage;
    const std::int64_t doubledOf = isCoverage ? 2 * (tally.asked + diff.count(Difference::Extra))
                                              : std::max(2 * tally.there, tally.asked);
    const std::int64_t reached = isCoverage ? tally.there : tally.right;
    constexpr double ofRounding = 1e-9; // for points that are no binary fractions
    return doubledOf > 0
        ? std::floor(check.of * 200 * double(reached) / double(doubledOf) + ofRounding) / 100
        : 0;
}

bool asksForColours(const AssignedScene &scene)
{
    return scene.points[std::size_t(Check::Colours)] > 0;
}

GradeVerdict verdictOf(const std::vector<GradedScene> &scenes)
{
    std::size_t judged = 0;
    std::int64_t wrong = 0;
    std::int64_t open = 0;
    for (const GradedScene &scene : scenes) {
        judged += scene.fault.isEmpty() ? 1 : 0;
        open += scene.counts.count(Difference::Undecidable);
        wrong += scene.counts.total();
    }
    if (judged == 0)
        return GradeVerdict::Nothing;
    if (judged < scenes.size() || wrong > 0)
        return GradeVerdict::Wrong;
    return open > 0 ? GradeVerdict::Undecidable : GradeVerdict::Right;
}

std::vector<Scene> scenesOf(const Assignment &assignment)
{
    std::vector<Scene> scenes;
    for (const AssignedScene &each : assignment.scenes)
        scenes.push_back(judgedScene(each.scene, assignment.margin));
    return scenes;
}

} // namespace

Grader::Grader(Assignment assignment)
    : m_assignment(std::move(assignment))
    , m_pictures(scenesOf(m_assignment))
{
    for (std::size_t scene = 0; scene < m_assignment.scenes.size(); ++scene)
        m_expected.push_back(*m_pictures.picture(scene, {}));
}

PictureDiff Grader::diffOf(std::size_t scene, const Picture &found) const
{
    const Picture &expected = m_expected[scene];
    return differenceOf(
        expected, found,
        undecidablePixels(m_pictures.scenes()[scene], expected, found, m_assignment.margin));
}

GradedScene Grader::judge(std::size_t scene, const Delivery &delivery) const
{
    const AssignedScene &asked = m_assignment.scenes[scene];
    GradedScene graded;
    graded.scene = asked.name;
    graded.file = delivery.file;
    graded.fault = delivery.fault;
    graded.lack = delivery.lack;
    graded.run = delivery.run;
    graded.trace = delivery.trace;
    graded.note = delivery.note;
    if (delivery.brokenInvariants) {
        graded.brokenInvariants.emplace();
        for (const Invariant invariant : *delivery.brokenInvariants)
            *graded.brokenInvariants += nameOf(invariant);
    }
    PictureDiff diff;
    const auto add = [&graded](const QString &note) {
        graded.note = graded.note ? *graded.note + u"; "_s + note : note;
    };
    if (const auto &picture = delivery.picture) {
        if (!picture->hasColours && asksForColours(asked))
            add(u"a raster of characters has no colours"_s);
        if (picture->isTransparent)
            add(u"the picture "_s + transparencyText());
        diff = diffOf(scene, *picture);
        graded.counts = diff.counts;
        graded.largestError = diff.largestError;
        for (const PictureCause &cause : diff.causes)
            graded.causes += cause.name;
        graded.firstDifference = firstDifferenceIn(diff, asked.scene.frame);
        const QStringList places = wrongPlaces(diff, m_expected[scene], asked.scene.frame);
        if (!places.isEmpty())
            graded.places = places;
    }
    for (std::size_t i = 0; i < allChecks.size(); ++i) {
        GradedCheck check{allChecks[i], false, 0, asked.points[i]};
        if (check.of == 0)
            continue;
        check.isPassed
            = delivery.picture && isPassed(check.check, m_expected[scene], delivery, diff);
        if (check.isPassed)
            check.points = check.of;
        else if (delivery.picture && m_assignment.credit == Credit::Share)
            check.points = pointsInPart(check, m_expected[scene], *delivery.picture, diff);
        graded.checks.push_back(check);
    }
    return graded;
}

Grader &Grader::in(FrameConvention convention)
{
    if (convention == m_convention)
        return *this;
    const std::lock_guard lock(m_mutex);
    std::unique_ptr<Grader> &other = m_others[convention];
    if (!other) {
        Assignment assignment = m_assignment;
        for (AssignedScene &each : assignment.scenes)
            each.scene = sceneIn(each.scene, convention);
        other = std::make_unique<Grader>(std::move(assignment));
        other->m_convention = convention;
    }
    return *other;
}

Grader::WrongPixels Grader::wrongIn(const std::vector<Delivery> &deliveries) const
{
    WrongPixels wrong;
    for (std::size_t scene = 0; scene < deliveries.size(); ++scene) {
        if (const auto &found = deliveries[scene].picture) {
            const PictureDiff diff = diffOf(scene, *found);
            wrong.coverage += diff.count(Difference::Missing) + diff.count(Difference::Extra);
            wrong.all += diff.differing();
        }
    }
    return wrong;
}

Grader &Grader::bestFor(const std::vector<Delivery> &deliveries)
{
    const WrongPixels own = wrongIn(deliveries);
    if (m_assignment.convention == Convention::Asked || own.all == 0)
        return *this;
    Grader *best = this;
    WrongPixels least = own;
    for (const FrameConvention convention : allFrameConventions) {
        Grader &other = in(convention);
        const WrongPixels wrong = other.wrongIn(deliveries);
        // More than half as many is no convention, but a mistake. Levels tell where nothing else
        // does.
        const bool isConvention = own.coverage > 0
            ? 2 * wrong.coverage <= own.coverage
            : wrong.coverage == 0 && 2 * wrong.all <= own.all;
        if (isConvention && wrong < least) {
            best = &other;
            least = wrong;
        }
    }
    return *best;
}

std::optional<GradedWork> Grader::grade(const SubmissionEntry &entry, const std::stop_token &stop)
{
    std::vector<Delivery> deliveries = deliveriesOf(entry, m_assignment, stop);
    std::vector<std::optional<Picture>> delivered;
    for (std::size_t scene = 0; scene < deliveries.size(); ++scene) {
        delivered.push_back(deliveries[scene].picture);
        // Colours that have no points are not judged: the picture counts as a raster.
        if (deliveries[scene].picture && !asksForColours(m_assignment.scenes[scene]))
            deliveries[scene].picture->hasColours = false;
    }
    Grader &best = bestFor(deliveries);
    auto work = best.gradeIn(entry, std::move(deliveries), stop);
    if (work)
        work->pictures = std::move(delivered);
    if (work && &best != this)
        work->submission.convention = best.m_convention;
    return work;
}

std::optional<GradedWork> Grader::gradeIn(const SubmissionEntry &entry,
                                          std::vector<Delivery> deliveries,
                                          const std::stop_token &stop)
{
    GradedWork work;
    GradedSubmission &submission = work.submission;
    submission.name = escapedName(entry.name());
    submission.id = idOf(entry.name());
    std::vector<FoundPicture> found;
    for (std::size_t scene = 0; scene < deliveries.size(); ++scene) {
        submission.scenes.push_back(judge(scene, deliveries[scene]));
        if (auto &picture = deliveries[scene].picture) {
            submission.differing += differingPixels(m_expected[scene], *picture);
            found.push_back({scene, *std::move(picture)});
        }
    }
    submission.verdict = verdictOf(submission.scenes);
    if (submission.differing > 0) {
        auto known = named(found, stop);
        if (!known)
            return std::nullopt;
        submission.pictures = known->pictures;
        submission.candidates = std::move(known->candidates);
        submission.searchError = known->error;
        for (auto &[scene, sets] : known->explanations)
            submission.scenes[scene].explanations = std::move(sets);
    }
    if (stop.stop_requested())
        return std::nullopt;
    return work;
}

std::optional<FramePixel> firstDifferenceIn(const PictureDiff &diff, const FrameSpec &frame)
{
    // An open pixel is returned only where there is no other.
    const auto found = std::ranges::min_element(diff.verdicts, {}, [](Difference verdict) {
        return verdict == Difference::None ? 2 : verdict == Difference::Undecidable ? 1 : 0;
    });
    if (found == diff.verdicts.end() || *found == Difference::None)
        return std::nullopt;
    return pixelOfPlace(frame, std::size_t(found - diff.verdicts.begin()));
}

FramePixel pixelOfPlace(const FrameSpec &frame, std::size_t place)
{
    const auto at = int(place);
    return {frame.firstColumn + at % frame.width, int(rowOfPictureLine(frame, at / frame.width))};
}

QImage imageOf(const Picture &picture)
{
    QImage image(picture.width, picture.height, QImage::Format_RGB32);
    for (int line = 0; line < picture.height; ++line) {
        for (int x = 0; x < picture.width; ++x) {
            const std::size_t place = picture.placeOf(x, line);
            const bool isWhite = picture.covered[place] != 0;
            const Colour ofRaster = isWhite ? Colour{{255, 255, 255}} : Colour{};
            image.setPixel(x, line, packed(picture.hasColours ? picture.colours[place] : ofRaster));
        }
    }
    return image;
}

} // namespace pixelplumb
