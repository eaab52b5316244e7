// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grade/picturediff.h"
#include "widgets/model/job.h"

#include <QObject>
#include <QPoint>

#include <functional>
#include <memory>

namespace pixelplumb {

/// A student's picture beside what a scene's method draws.
struct PictureJudgement {
    FrameSpec frame;
    Picture expected;
    Picture found;
    PictureDiff diff;

    /// Where a pixel of the frame stands in the pictures; none outside.
    std::optional<std::size_t> placeOf(const QPoint &pixel) const;
    /// Same outside the frame.
    PixelVerdict verdictAt(const QPoint &pixel) const;
    /// The first pixel that is wrong, else undecidable, in the order of reading.
    std::optional<QPoint> firstDifference() const;
    /// The next one of any kind after a pixel; after the last, and where there is none, the first.
    std::optional<QPoint> differenceAfter(const std::optional<QPoint> &pixel) const;
};

/// The picture that a student's program drew of the scene in hand, judged anew whenever the scene
/// changes: beside the GUI thread where that may take longer than a moment. One that is under way
/// is finished and shown, so that a long drag is seen moving.
class StudentPicture : public QObject {
    Q_OBJECT

public:
    explicit StudentPicture(QObject *parent = nullptr);

    bool isThere() const { return m_picture.width > 0; }
    /// Of its file, or where it came from; where it is not there, of the one that was expected.
    const QString &name() const { return m_name; }
    /// Why the one that was expected is not there; empty where none was.
    const QString &absence() const { return m_absence; }
    const Picture &picture() const { return m_picture; }
    /// Null where there is no picture, none of the scene's size, or the first is under way.
    const std::shared_ptr<const PictureJudgement> &judgement() const { return m_judgement; }
    /// Why it is not judged; empty where it is, or will be.
    QString misfit() const;
    bool isRunning() const { return m_reading.isRunning() || m_judging.isRunning(); }
    /// That the picture is held to; null before the first.
    std::shared_ptr<const Scene> scene() const { return m_scene; }
    /// While that scene is in hand, which someone got wrong, the picture is held to the right one.
    void setRightOf(const Scene &wrong, const std::shared_ptr<const Scene> &right);

public slots:
    /// Reads a picture file or a raster beside the GUI thread; complains of what is none and of
    /// another size than the frame's, and then keeps the picture that is there.
    void open(const QString &path);
    /// The same of a file in a folder of results, by a name of its own.
    void openResult(const QString &results, const QString &file, const QString &name);
    /// The same of what was copied: a picture, or the bytes of a raster.
    void paste(const QImage &image, const QString &name);
    void paste(const QByteArray &raster, const QString &name);
    void remove();
    /// Removes it and says which is expected in its place, and why that is not there.
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
    std::shared_ptr<const Scene> m_scene;
    std::optional<Scene> m_wrong; ///< in whose place m_right stands
    std::shared_ptr<const Scene> m_right;
    std::shared_ptr<const Scene> m_next; ///< to be judged when the judging under way has ended
    std::shared_ptr<const PictureJudgement> m_judgement;
    Job m_reading;
    Job m_judging;
};

} // namespace pixelplumb
