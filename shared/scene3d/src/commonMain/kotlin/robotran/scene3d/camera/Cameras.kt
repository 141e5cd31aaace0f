package robotran.scene3d.camera

import robotran.scene3d.geometry.Vector3
import robotran.world.Paper
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.geometry.Trigonometry
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The part of a picture that nothing covers, in pixels. Cameras put into its middle what they look at.
 *
 * @property picture the whole picture.
 */
data class PictureWindow(
    val left: Double,
    val top: Double,
    val right: Double,
    val bottom: Double,
    val picture: PictureSize,
) {
    val width: Double get() = (right - left).coerceAtLeast(1.0)
    val height: Double get() = (bottom - top).coerceAtLeast(1.0)
    val centre: ScreenPoint get() = ScreenPoint((left + right) / 2, (top + bottom) / 2)
}

/** Makes the cameras of one picture. */
class Cameras(private val window: PictureWindow, private val trigonometry: Trigonometry) {
    /** In pixels; with it, a picture of any shape shows neither too much at its edges nor too little. */
    private val focal = FOCAL_LENGTH * sqrt(window.width * window.height)
    private val wideFocal = WIDE_FOCAL_LENGTH * sqrt(window.width * window.height)

    /** The greatest pitch of [around], in degrees, see [maxPitch]. */
    val steepest: Double get() = maxPitch(focal, lowerHalf(), trigonometry).coerceIn(MIN_PITCH, MAX_PITCH)

    /**
     * A camera that looks at [target] from the direction [heading] and [pitch], in degrees. With a [zoom] of 1, all of
     * [paper] is in the window, seen from its centre; with 2, it is twice as large.
     */
    fun around(paper: Paper, target: Point, heading: Double, pitch: Double, zoom: Double): Projection {
        val within = pitch.coerceIn(MIN_PITCH, steepest)
        val middle = Vector3(paper.width / 2, paper.height / 2, 0.0)
        val (distance, shift) = fit(paper, middle, heading, within)
        val view = ViewPoint.around(Vector3(target.x, target.y, 0.0), heading, within, distance / zoom, trigonometry)
        val centre = ScreenPoint(window.centre.x, window.centre.y + shift / zoom)
        return Projection(view, focal, centre, window.picture)
    }

    /** A camera behind a robot at [pose], above it, which looks over it in the direction [heading]. */
    fun behind(pose: Pose, heading: Double, pitch: Double, zoom: Double): Projection {
        val sight = heading * RADIANS_PER_DEGREE
        val target = Vector3(
            pose.x + LOOK_AHEAD * trigonometry.cosine(sight),
            pose.y + LOOK_AHEAD * trigonometry.sine(sight),
            0.0,
        )
        val within = pitch.coerceIn(MIN_PITCH, steepest)
        val view = ViewPoint.around(target, heading, within, FOLLOWING_DISTANCE / zoom, trigonometry)
        return Projection(view, focal, window.centre, window.picture)
    }

    /** What a robot at [pose] would see with a wide-angle eye between its bumpers. */
    fun eyeOf(pose: Pose): Projection {
        val heading = pose.heading * RADIANS_PER_DEGREE
        val eye = Vector3(
            pose.x + EYE_POSITION * trigonometry.cosine(heading),
            pose.y + EYE_POSITION * trigonometry.sine(heading),
            EYE_HEIGHT,
        )
        val view = ViewPoint.looking(eye, pose.heading, EYE_PITCH, trigonometry)
        return Projection(view, wideFocal, window.centre, window.picture)
    }

    /**
     * The least distance at which all of [paper] and what stands on it is in the window, and how far the picture must
     * be moved down for that, in pixels: the near half of the paper needs more room than the far one.
     */
    private fun fit(paper: Paper, middle: Vector3, heading: Double, pitch: Double): Pair<Double, Double> {
        val view = ViewPoint.looking(middle, heading, pitch, trigonometry)
        val margin = maxOf(MIN_MARGIN, maxOf(paper.width, paper.height) * MARGIN)
        val corners = listOf(-margin, paper.width + margin).flatMap { x ->
            listOf(-margin, paper.height + margin).map { y -> Vector3(x, y, 0.0) }
        }.map { it - middle }
        var distance = corners.maxOf { abs(it.dot(view.right)) * 2 * focal / window.width - it.dot(view.forward) }
        var shift = 0.0
        repeat(FITTING_STEPS) {
            val heights = corners.map { -it.dot(view.up) * focal / (it.dot(view.forward) + distance) }
            shift = -(heights.max() + heights.min()) / 2
            val tooHigh = (heights.max() - heights.min()) / window.height
            if (tooHigh > 1) distance *= tooHigh
        }
        return distance to shift
    }

    /** What [around] may show below its centre, in pixels: all of it if the window is moved. */
    private fun lowerHalf(): Double = (window.picture.height - window.top) * LOWER_PART

    companion object {
        /** In degrees: lower, the paper would be a line. */
        const val MIN_PITCH = 8.0

        /** In degrees: steeper is the sheet from above, which is a view of its own. */
        const val MAX_PITCH = 65.0

        /** Relative to the geometric mean of the window's sides. */
        private const val FOCAL_LENGTH = 1.1
        private const val WIDE_FOCAL_LENGTH = 0.75

        /** In centimetres: what is seen of the desk around the paper, and its share of the paper's longer side. */
        private const val MIN_MARGIN = 2.0
        private const val MARGIN = 0.02
        private const val FITTING_STEPS = 6

        /** The part of the picture's height that may be below the camera's centre. */
        private const val LOWER_PART = 0.62

        /** In centimetres. */
        private const val LOOK_AHEAD = 10.0
        private const val FOLLOWING_DISTANCE = 62.0

        /** The robot's eye: above the light sensor, and lower than a wall. */
        private const val EYE_POSITION = 7.9
        private const val EYE_HEIGHT = 5.4
        private const val EYE_PITCH = 14.0
    }
}

/**
 * The greatest pitch, in degrees, with which a camera of this [focal] length shows nothing behind its own foot, the
 * point on the paper below it, if its picture reaches [below] pixels down from its centre. A few degrees less than 90
 * less the angle of that part.
 */
fun maxPitch(focal: Double, below: Double, trigonometry: Trigonometry): Double =
    trigonometry.angle(below, focal) / RADIANS_PER_DEGREE - SAFE_ANGLE

/** In degrees. */
private const val SAFE_ANGLE = 2.0
