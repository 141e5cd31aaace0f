package robotran.ui.robot

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import robotran.robotediting.elements
import robotran.robotediting.placeOf
import robotran.ui.editing.EditorView
import robotran.ui.editing.push
import robotran.ui.sheet.SheetTransform
import robotran.world.RobotDescription
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import robotran.world.robot.box
import kotlin.math.min

/**
 * The view state of the plan: where the robot is on the screen. The front is up. The scale follows the robot only on
 * request, so that nothing moves under a finger.
 */
internal class PlanView(robot: RobotDescription) : EditorView() {
    private var frame by mutableStateOf(frameOf(robot))
    private var zoom by mutableStateOf(1f)
    private var push by mutableStateOf(Offset.Zero)

    /**
     * Maps the plan to pixels as if the robot stood on a sheet with its middle at the lower left corner of the paper
     * and looked up.
     */
    override val transform: SheetTransform
        get() {
            val across = (frame.top - frame.bottom).toFloat()
            val along = (frame.right - frame.left).toFloat()
            val scale = (min(window.width / across, window.height / along) * zoom).coerceAtLeast(MIN_SCALE)
            val middle = Offset(-(frame.top + frame.bottom).toFloat() / 2, -(frame.left + frame.right).toFloat() / 2)
            val origin = pane.center - middle * scale + push
            return SheetTransform(scale, Rect(origin, origin))
        }

    fun fit(robot: RobotDescription) {
        frame = frameOf(robot)
        zoom = 1f
        push = Offset.Zero
    }

    override fun zoomBy(factor: Double, about: Offset) {
        val next = (zoom * factor.toFloat()).coerceIn(MIN_ZOOM, MAX_ZOOM)
        val from = transform.paper.topLeft
        push += (from - about) * (next / zoom - 1)
        zoom = next
    }

    override fun pushBy(offset: Offset) {
        val reach = min(window.width, window.height)
        push = Offset((push.x + offset.x).coerceIn(-reach, reach), (push.y + offset.y).coerceIn(-reach, reach))
    }

    private companion object {
        const val MIN_ZOOM = 0.5f
        const val MAX_ZOOM = 6f
        const val MIN_SCALE = 0.1f

        /** Around the robot, and half of what is shown at least, in centimetres. */
        const val MARGIN = 4.0
        const val LEAST = 11.0

        fun frameOf(robot: RobotDescription): Bounds {
            val box = robot.box
            val places = robot.elements().mapNotNull(robot::placeOf)
            return Bounds(
                minOf(box.left, places.minOf { it.x }, MARGIN - LEAST) - MARGIN,
                minOf(box.bottom, places.minOf { it.y }, MARGIN - LEAST) - MARGIN,
                maxOf(box.right, places.maxOf { it.x }, LEAST - MARGIN) + MARGIN,
                maxOf(box.top, places.maxOf { it.y }, LEAST - MARGIN) + MARGIN,
            )
        }
    }
}

/** The pixels of a point of the robot. */
internal fun SheetTransform.ofRobot(point: Point): Offset = toPixels(-point.y, point.x)

/** The point of the robot at these pixels. */
internal fun SheetTransform.toRobot(position: Offset): Point = toCentimetres(position).let { Point(it.y, -it.x) }
