// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/studentpicture.h"

#include "core/grade/class/grader.h"
#include "core/grade/class/resultsfolder.h"
#include "core/grade/diagnose/undecidable.h"
#include "core/methods/method.h"
#include "core/runs/scenerun.h"
#include "core/scene/files/fileaccess.h"
#include "widgets/look/typesetting.h"
#include "widgets/model/scenetracer.h"

#include <algorithm>
#include <utility>

namespace pixelplumb {

namespace {

/// Frame pixels; judging more takes longer than a frame of a drag.
constexpr std::int64_t mostJudgedAtOnce = 10'000;

bool isJudgedAtOnce(const Scene &scene)
{
    return std::int64_t(scene.frame.width) * scene.frame.height <= mostJudgedAtOnce
        && scene.solids.empty()
        && std::int64_t(scene.triangles.size() + scene.shapes.size())
        <= TraceCost::mostTrianglesOfSmall
        && traceCostOf(primitivesOnSamples(scene), scene.frame).isSmall();
}

bool canBeDrawn(const Scene &scene)
{
    return methodNamed(QString::fromStdString(scene.method)) && objectionTo(scene).isEmpty();
}

std::shared_ptr<const PictureJudgement> judgementOf(const Scene &asked, Picture found,
                                                    const Margin &margin)
{
    const Scene scene = judgedScene(asked, margin);
    if (found.hasColours)
        coverAllBut(scene.frame.background, found);
    Picture expected = pictureOf(scene);
    PictureDiff diff
        = differenceOf(expected, found, undecidablePixels(scene, expected, found, margin));
    return std::make_shared<const PictureJudgement>(
        PictureJudgement{scene.frame, std::move(expected), std::move(found), std::move(diff)});
}

} // namespace

std::optional<std::size_t> PictureJudgement::placeOf(const QPoint &pixel) const
{
    const int column = pixel.x() - frame.firstColumn;
    const int row = pixel.y() - frame.firstRow;
    if (column < 0 || column >= frame.width || row < 0 || row >= frame.height)
        return std::nullopt;
    return expected.placeOf(column, pictureLine(frame, pixel.y()));
}

Difference PictureJudgement::verdictAt(const QPoint &pixel) const
{
    const std::optional<std::size_t> place = placeOf(pixel);
    return place ? diff.verdicts[*place] : Difference::None;
}

namespace {

Result<Picture> pictureFrom(const Result<QByteArray> &content, const QString &name)
{
    return content ? parsePicture(*content, name) : Result<Picture>(content.error());
}

} // namespace

std::optional<QPoint> PictureJudgement::firstDifference() const
{
    const auto pixel = firstDifferenceIn(diff, frame);
    return pixel ? std::optional(QPoint(pixel->x, pixel->y)) : std::nullopt;
}

std::optional<QPoint> PictureJudgement::differenceAfter(const std::optional<QPoint> &pixel) const
{
    const std::optional<std::size_t> before = pixel ? placeOf(*pixel) : std::nullopt;
    const std::size_t count = diff.verdicts.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t place = ((before ? *before + 1 : 0) + i) % count;
        if (diff.verdicts[place] == Difference::None)
            continue;
        const FramePixel next = pixelOfPlace(frame, place);
        return QPoint(next.x, next.y);
    }
    return std::nullopt;
}

JudgedFrames::JudgedFrames(std::shared_ptr<const PictureJudgement> judgement)
    : m_judgement(std::move(judgement))
    , m_found(m_judgement->frame)
    , m_expected(m_judgement->frame)
{
    const auto fill = [](const FrameBuffer &frame, const QImage &image) {
        for (int line = 0; line < image.height(); ++line) {
            const auto *const pixels = reinterpret_cast<const QRgb *>(image.constScanLine(line));
            std::copy_n(
                pixels, image.width(),
                frame.view().at(frame.spec().firstColumn, rowOfPictureLine(frame.spec(), line)));
        }
    };
    fill(m_found, imageOf(m_judgement->found));
    fill(m_expected, imageOf(m_judgement->expected));
}

const JudgedFrames &StudentPicture::frames() const
{
    if (!m_frames || m_frames->judgement() != m_judgement)
        m_frames.emplace(m_judgement);
    return *m_frames;
}

StudentPicture::StudentPicture(QObject *parent)
    : QObject(parent)
{
    m_reading.setTitle(tr("Reading the student's picture"));
    m_judging.setTitle(tr("Comparing with the student's picture"));
}

QString StudentPicture::misfit() const
{
    if (!isThere() || !m_scene)
        return {};
    if (const QString text = misfitOf(m_picture); !text.isEmpty())
        return text;
    return canBeDrawn(*m_scene) ? QString() : tr("The method does not draw this scene.");
}

QString StudentPicture::misfitOf(const Picture &picture) const
{
    const FrameSpec &frame = m_scene->frame;
    if (picture.width == frame.width && picture.height == frame.height)
        return {};
    return tr("The picture is %1 × %2 pixels%5, the scene's frame %3 × %4; use a picture of the "
              "frame's size, or make the frame the picture's size (Edit ▸ Frame).")
        .arg(picture.width)
        .arg(picture.height)
        .arg(frame.width)
        .arg(frame.height)
        .arg(sizeHint({picture.width, picture.height}, {frame.width, frame.height}));
}

void StudentPicture::open(const QString &path)
{
    const QString name = shownName(path);
    read(name,
         [path, name] { return pictureFrom(readRegularFile(path, largestPictureFile), name); });
}

void StudentPicture::openResult(const QString &results, const QString &file, const QString &name)
{
    read(name,
         [results, file, name] { return pictureFrom(ResultsFolder(results).read(file), name); });
}

void StudentPicture::paste(const QImage &image, const QString &name)
{
    read(name, [image] { return Result<Picture>(pictureIn(image)); });
}

void StudentPicture::paste(const QByteArray &raster, const QString &name)
{
    read(name, [raster, name] { return parsePicture(raster, name); });
}

void StudentPicture::read(const QString &name, const std::function<Result<Picture>()> &reading)
{
    using Outcome = std::optional<Result<Picture>>;
    m_reading.start([reading](const ProgressListener &) -> Outcome { return reading(); },
                    [this, name](const Outcome &outcome) {
                        if (outcome && *outcome)
                            return take(**outcome, name);
                        refuse(outcome ? outcome->error().message()
                                       : tr("%1 does not fit into memory.").arg(name));
                    });
}

/// Complains; the current picture stays.
void StudentPicture::refuse(const QString &why)
{
    if (!isThere() && !m_name.isEmpty()) {
        m_absence = why;
        emit judged();
    }
    emit complaint(why);
}

void StudentPicture::take(const Picture &picture, const QString &name)
{
    if (const QString text = m_scene ? misfitOf(picture) : QString(); !text.isEmpty()) {
        refuse(u"%1: %2"_s.arg(name, text));
        return;
    }
    m_picture = picture;
    m_name = name;
    m_absence.clear();
    m_judging.cancel(); // of the previous picture
    show(nullptr);
    emit taken();
    judge();
}

void StudentPicture::remove() { expect({}, {}); }

void StudentPicture::expect(const QString &name, const QString &absence)
{
    m_reading.cancel();
    m_picture = {};
    m_name = name;
    m_absence = absence;
    judge();
}

void StudentPicture::setMargin(const Margin &margin)
{
    if (m_margin == margin)
        return;
    m_margin = margin;
    judge();
}

void StudentPicture::follow(const std::shared_ptr<const Scene> &scene)
{
    m_scene = m_wrong == *scene ? m_right : scene;
    if (isThere())
        judge();
}

void StudentPicture::setRightOf(const Scene &wrong, const std::shared_ptr<const Scene> &right)
{
    m_wrong = wrong;
    m_right = right;
}

void StudentPicture::judge()
{
    m_next = Next::Nothing;
    if (!isThere() || !m_scene || !misfit().isEmpty()) {
        m_judging.cancel();
        show(nullptr);
        return;
    }
    if (isJudgedAtOnce(*m_scene)) {
        m_judging.cancel();
        show(judgementOf(*m_scene, m_picture, m_margin));
        return;
    }
    if (m_judging.isRunning()) {
        m_next = Next::Judging;
        return;
    }
    m_judging.start([scene = m_scene, picture = m_picture, margin = m_margin](
                        const ProgressListener &) { return judgementOf(*scene, picture, margin); },
                    [this](const std::shared_ptr<const PictureJudgement> &judgement) {
                        show(judgement); // null where memory ran out
                        if (std::exchange(m_next, Next::Nothing) == Next::Judging)
                            judge();
                    });
}

void StudentPicture::show(const std::shared_ptr<const PictureJudgement> &judgement)
{
    m_judgement = judgement;
    emit judged();
}

} // namespace pixelplumb
