// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/frame/framespec.h"
#include "core/space/spacevector.h"

namespace pixelplumb {

/// Clip coordinates: the frame's sides are at x, y = ±w, the near plane is at z = 0, the far plane
/// at z = w.
template <class Number>
struct ClipPoint {
    Number x = Number(0);
    Number y = Number(0);
    Number z = Number(0);
    Number w = Number(1);
};

/// Transforms points from the scene's space to sample coordinates, by a camera and a frame (Scan
/// Conversion slides, "Projective Rendering Pipeline").
///
/// View space is right-handed: x to the right, y up, the eye at the origin, looking along −z.
/// Clip coordinates of a perspective: x·c/aspect, y·c with c = cot(fieldOfView/2), w = −z and
/// z_clip = (w − near)·far/(far − near); of an orthographic projection: x·2/(height·aspect),
/// y·2/height, w = 1 and z_clip = (−z − near)/(far − near).
template <class Number>
class CameraTransform {
public:
    using Vector = SpaceVector<Number>;

    CameraTransform(const Camera &camera, const FrameSpec &frame)
        : m_projection(camera.projection)
        , m_eye(camera.eye)
        , m_backward(unit(m_eye - Vector(camera.target)))
        , m_right(unit(cross(Vector(camera.up), m_backward)))
        , m_up(cross(m_backward, m_right))
        , m_near(camera.near)
        , m_firstColumn(frame.firstColumn)
        , m_firstRow(frame.firstRow)
        , m_width(frame.width)
        , m_height(frame.height)
        , m_origin(frame.origin)
    {
        using std::acos;
        using std::tan;
        const Number far(camera.far);
        const Number depth = far - m_near;
        if (m_projection == Projection::Perspective) {
            const Number half = Number(camera.fieldOfView) / 180 * acos(Number(0));
            m_scaleY = 1 / tan(half);
            m_scaleZ = far / depth;
        } else {
            m_scaleY = Number(2) / Number(camera.height);
            m_scaleZ = 1 / depth;
        }
        m_scaleX = m_scaleY * m_height / m_width;
    }

    Vector toView(const Vector &point) const
    {
        const Vector fromEye = point - m_eye;
        return {dot(m_right, fromEye), dot(m_up, fromEye), dot(m_backward, fromEye)};
    }

    ClipPoint<Number> toClip(const Vector &view) const
    {
        const Number depth = -view.z;
        return {m_scaleX * view.x, m_scaleY * view.y, m_scaleZ * (depth - m_near),
                m_projection == Projection::Perspective ? depth : Number(1)};
    }

    /// The w of every point on the near plane.
    Number wAtNear() const { return m_projection == Projection::Perspective ? m_near : Number(1); }

    /// (x/w, y/w, z/w); requires w > 0.
    static Vector divided(const ClipPoint<Number> &clip)
    {
        return {clip.x / clip.w, clip.y / clip.w, clip.z / clip.w};
    }

    /// Sample coordinates in px: the frame extends half a pixel beyond its outermost samples.
    std::array<Number, 2> toFrame(const Vector &device) const
    {
        const Number half = Number(1) / 2;
        const Number y = m_origin == FrameOrigin::BottomLeft ? device.y : -device.y;
        return {m_firstColumn + (device.x + 1) * half * m_width - half,
                m_firstRow + (y + 1) * half * m_height - half};
    }

    /// The inverse of toFrame(): the device coordinates of a sample.
    std::array<Number, 2> deviceAt(const Number &x, const Number &y) const
    {
        const Number half = Number(1) / 2;
        const Number upward = (y - m_firstRow + half) * 2 / m_height - 1;
        return {(x - m_firstColumn + half) * 2 / m_width - 1,
                m_origin == FrameOrigin::BottomLeft ? upward : -upward};
    }

    /// How far the frame extends from its middle, sideways and upward, in the plane at a view
    /// depth.
    std::array<Number, 2> halfFrameAt(const Number &depth) const
    {
        const Number w = m_projection == Projection::Perspective ? depth : Number(1);
        return {w / m_scaleX, w / m_scaleY};
    }

    const Vector &eye() const { return m_eye; }
    /// Clip coordinates per unit of view space, sideways, upward and in depth.
    Vector scale() const { return {m_scaleX, m_scaleY, m_scaleZ}; }
    const Vector &right() const { return m_right; }
    const Vector &up() const { return m_up; }
    const Vector &backward() const { return m_backward; }

private:
    Projection m_projection;
    Vector m_eye;
    Vector m_backward;
    Vector m_right;
    Vector m_up;
    Number m_near;
    Number m_scaleX;
    Number m_scaleY;
    Number m_scaleZ;
    Number m_firstColumn;
    Number m_firstRow;
    Number m_width;
    Number m_height;
    FrameOrigin m_origin;
};

} // namespace pixelplumb
