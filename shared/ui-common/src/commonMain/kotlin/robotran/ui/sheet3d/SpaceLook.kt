package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import robotran.scene3d.Scene
import robotran.scene3d.camera.Cameras
import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.ScreenPoint
import robotran.scene3d.elementAt
import robotran.scene3d.geometry.Vector3
import robotran.workshop.state.CameraKind
import robotran.workshop.state.SpaceCamera
import robotran.world.Paper
import robotran.world.geometry.Point
import kotlin.math.abs

/**
 * The camera of the 3D view during gestures. Like [robotran.ui.sheet.SheetLook], it tracks the camera itself, because
 * several movements may arrive before the next frame.
 */
class SpaceLook {
    private var camera = SpaceCamera()
    private var kind = CameraKind.ORBIT
    private var paper = Paper(1.0, 1.0)
    private var cameras: Cameras? = null
    private var projection: Projection? = null
    private var scene: Scene? = null
    private var onCamera: (SpaceCamera) -> Unit = {}

    /** Sets the state of this frame. */
    fun show(
        camera: SpaceCamera,
        kind: CameraKind,
        paper: Paper,
        cameras: Cameras,
        projection: Projection,
        scene: Scene,
        onCamera: (SpaceCamera) -> Unit,
    ) {
        this.camera = camera
        this.kind = kind
        this.paper = paper
        this.cameras = cameras
        this.projection = projection
        this.scene = scene
        this.onCamera = onCamera
    }

    /** What is at the pixel [position]. */
    fun hit(position: Offset): TouchedPlace? {
        val projection = projection ?: return null
        val scene = scene ?: return null
        val pixel = ScreenPoint(position.x.toDouble(), position.y.toDouble())
        elementAt(scene, projection, pixel)?.let {
            return TouchedPlace(Point(it.point.x, it.point.y), it.point.z, projection.scaleAt(it.point), isSolid = true)
        }
        return ground(position)
    }

    /** What of the paper or desk is at the pixel [position]; null for the sky. */
    fun ground(position: Offset): TouchedPlace? {
        val projection = projection ?: return null
        val point = onPlane(position, 0.0) ?: return null
        return TouchedPlace(point, 0.0, projection.scaleAt(Vector3(point.x, point.y, 0.0)), isSolid = false)
    }

    /** The point at [height] above the paper that the pixel [position] shows. */
    fun onPlane(position: Offset, height: Double): Point? =
        projection?.onPlane(ScreenPoint(position.x.toDouble(), position.y.toDouble()), height)

    /** Goes around what the camera looks at, by the way of a finger in pixels: what is near follows the finger. */
    fun orbit(way: Offset) = turn(-way.x * DEGREES_PER_PIXEL, way.y * DEGREES_PER_PIXEL)

    /** Goes around it by these angles, in degrees. */
    fun turn(degrees: Double, pitch: Double) {
        if (kind == CameraKind.ROBOT_EYE) return
        val steepest = cameras?.steepest ?: return
        val now = camera
        val turned = if (kind == CameraKind.FOLLOW) {
            now.copy(turn = wholeTurn(now.turn + degrees))
        } else {
            now.copy(heading = wholeTurn(now.heading + degrees))
        }
        move(turned.copy(pitch = (now.pitch.coerceAtMost(steepest) + pitch).coerceIn(Cameras.MIN_PITCH, steepest)))
    }

    /** Looks from nearer or, with a [factor] below 1, from further away. */
    fun zoom(factor: Double) {
        if (kind == CameraKind.ROBOT_EYE) return
        move(camera.copy(zoom = (camera.zoom * factor).coerceIn(leastZoom(kind), SpaceCamera.MAX_ZOOM)))
    }

    /** Moves what the camera looks at, so that the point of the paper at pixel [from] comes to [to]. */
    fun push(from: Offset, to: Offset) {
        if (kind != CameraKind.ORBIT) return
        val before = onPlane(from, 0.0) ?: return
        val after = onPlane(to, 0.0) ?: return
        val centre = camera.centre ?: Point(paper.width / 2, paper.height / 2)
        // Near the horizon a pixel is far; a step is never longer than the paper.
        val x = (before.x - after.x).takeIf { abs(it) < paper.width } ?: return
        val y = (before.y - after.y).takeIf { abs(it) < paper.height } ?: return
        move(
            camera.copy(
                centre = Point((centre.x + x).coerceIn(0.0, paper.width), (centre.y + y).coerceIn(0.0, paper.height)),
            ),
        )
    }

    /** The view of the beginning. */
    fun reset() = move(SpaceCamera(robot = camera.robot))

    private fun move(camera: SpaceCamera) {
        if (camera == this.camera) return
        this.camera = camera
        cameras?.let { if (kind == CameraKind.ORBIT) projection = it.of(camera, paper) }
        onCamera(camera)
    }

    private fun wholeTurn(degrees: Double) = (degrees % FULL_TURN + FULL_TURN) % FULL_TURN

    private companion object {
        const val DEGREES_PER_PIXEL = 0.35
        const val FULL_TURN = 360.0
    }
}

/** The least zoom: around the paper all of it is seen; a camera behind a robot may go further away. */
fun leastZoom(kind: CameraKind): Double =
    if (kind == CameraKind.ORBIT) SpaceCamera.MIN_ZOOM else SpaceCamera.MIN_ZOOM / 2

/** The projection of a camera around the paper. */
fun Cameras.of(camera: SpaceCamera, paper: Paper): Projection = around(
    paper,
    camera.centre ?: Point(paper.width / 2, paper.height / 2),
    camera.heading,
    camera.pitch,
    camera.zoom,
)

/**
 * A place that a finger touches.
 *
 * @property point seen from above.
 * @property height above the paper: of the surface that is touched.
 * @property scale the pixels of a centimetre there.
 * @property isSolid whether something stands there.
 */
class TouchedPlace(val point: Point, val height: Double, val scale: Double, val isSolid: Boolean)
