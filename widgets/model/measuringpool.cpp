// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/model/measuringpool.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

namespace pixelplumb {

QThreadPool *measuringPool()
{
    static QPointer<QThreadPool> pool;
    if (!pool) {
        pool = new QThreadPool(QCoreApplication::instance()); // destroyed with the application
        pool->setMaxThreadCount(1);
    }
    return pool;
}

QString measuringNote()
{
    return measuringPool()->activeThreadCount() > 0
        ? QCoreApplication::translate("pixelplumb::Measuring", "Waiting for another measurement …")
        : QCoreApplication::translate("pixelplumb::Measuring", "Measuring …");
}

} // namespace pixelplumb
