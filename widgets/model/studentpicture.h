// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framebuffer.h"
#include "core/grade/pictures/picturediff.h"
#include "core/grade/rounding/margin.h"
#include "widgets/model/job.h"

#include <QtCore>

#include <functional>
#include <memory>

namespace pixelplumb {

/// A student's picture compared with what a scene's method draws.
struct PictureJudgement {
    FrameSpec frame;
    Picture expected;
    Picture found;
    PictureDiff diff;

    /// The index of a frame's pixel in the pictures; none outside.
    std::optional<std::size_t> placeOf(const QPoint &pixel) const;
    /// `None` outside the frame.
    Difference verdictAt(const QPoint &pixel) const;
    /// The first wrong pixel, else the first undecidable one, in reading order.
    std::optional<QPoint> firstDifference() const;
    /// The next differing pixel of any kind after a pixel; after the last one, and without a pixel,
    /// the first.
    std::optional<QPoint> differenceAfter(const std::optional<QPoint> &pixel) const;
};

/// The two pictures of a judgement as frames.
class JudgedFrames {
public:
    explicit JudgedFrames(std::shared_ptr<const PictureJudgement> judgement);

    const std::shared_ptr<const PictureJudgement> &judgement() const { return m_judgement; }
    const FrameBuffer &found() const { return m_found; }
    const FrameBuffer &expected() const { return m_expected; }

private:
    std::shared_ptr<const PictureJudgement> m_judgement;
    FrameBuffer m_found;
    FrameBuffer m_expected;
};

/// The picture that a student's program drew of the current scene, judged anew whenever the scene
/// changes: in a worker thread where that may take more than a moment. A judging in progress is
/// finished and shown, so that a long drag is seen moving.
class StudentPicture : public QObject {
    Q_OBJECT

public:
    explicit StudentPicture(QObject *parent = nullptr);

    bool isThere() const { return m_picture.width > 0; }
    /// The name of its file, or its origin; without a picture, the name of the expected one.
    const QString &name() const { return m_name; }
    /// Why the expected picture is missing; empty where none was expected.
    const QString &absence() const { return m_absence; }
    const Picture &picture() const { return m_picture; }
    /// Null where there is no picture, none of the scene's size, or the first judging is still
    /// running.
    const std::shared_ptr<const PictureJudgement> &judgement() const { return m_judgement; }
    /// The pictures of the judgement, which must be there.
    const JudgedFrames &frames() const;
    /// What it may have otherwise than the expected picture.
    const Margin &margin() const { return m_margin; }
    void setMargin(const Margin &margin);
    /// Why the picture is not judged; empty where it is, or will be.
    QString misfit() const;
    bool isRunning() const { return m_reading.isRunning() || m_judging.isRunning(); }
    /// The scene against which the picture is judged; null before the first.
    std::shared_ptr<const Scene> scene() const { return m_scene; }
    /// While the scene is `wrong`, made from somebody's mistakes, the picture is judged against
    /// `right`.
    void setRightOf(const Scene &wrong, const std::shared_ptr<const Scene> &right);

public slots:
    /// Reads a picture file or a raster in a worker thread. Anything else, or a size other than the
    /// frame's, brings a complaint, and the current picture stays.
    void open(const QString &path);
    /// Opens a file in a folder of results like open(), under another name.
    void openResult(const QString &results, const QString &file, const QString &name);
    /// Takes a copied picture, or the bytes of a raster, like open().
    void paste(const QImage &image, const QString &name);
    void paste(const QByteArray &raster, const QString &name);
    void remove();
    /// Removes the picture; says which one is expected instead, and why it is missing.
    void expect(const QString &name, const QString &absence);
    void follow(const std::shared_ptr<const pixelplumb::Scene> &scene);

signals:
    void taken(); ///< another picture
    void judged(); ///< another judgement, or none
    void complaint(const QString &text);

private:
    void read(const QString &name, const std::function<Result<Picture>()> &reading);
    void take(const Picture &picture, const QString &name);
    void refuse(const QString &why);
    QString misfitOf(const Picture &picture) const;
    void judge();
    void show(const std::shared_ptr<const PictureJudgement> &judgement);

    QString m_name;
    QString m_absence;
    Picture m_picture;
    Margin m_margin;
    std::shared_ptr<const Scene> m_scene;
    std::optional<Scene> m_wrong; ///< for which m_right is substituted
    std::shared_ptr<const Scene> m_right;
    enum class Next { Nothing, Judging };
    Next m_next = Next::Nothing; ///< after the current judging
    std::shared_ptr<const PictureJudgement> m_judgement;
    mutable std::optional<JudgedFrames> m_frames; ///< of m_judgement, or of an earlier one
    Job m_reading;
    Job m_judging;
};

} // namespace pixelplumb
