package robotran.workshop.state

import androidx.compose.runtime.Immutable
import kotlinx.serialization.Serializable
import robotran.world.geometry.Point

/** From where the 3D view is seen. */
@Serializable
enum class CameraKind {
    /** From anywhere around the paper. */
    ORBIT,

    /** From behind a robot, above it. */
    FOLLOW,

    /** Through the eye of a robot. */
    ROBOT_EYE,
}

/**
 * The camera of the 3D view, independent of the size of the pane.
 *
 * @property heading in which direction it looks, in degrees counter-clockwise from the paper's x axis.
 * @property pitch how many degrees it looks down; the view limits it so that the picture stays sensible.
 * @property zoom relative to all of the paper, [MIN_ZOOM]..[MAX_ZOOM].
 * @property centre what it looks at; null for the middle of the paper.
 * @property turn how far a camera that follows a robot is turned around it, in degrees; 0 behind it.
 * @property robot the robot that is followed, or whose eye it is.
 */
@Immutable
data class SpaceCamera(
    val heading: Double = HEADING,
    val pitch: Double = PITCH,
    val zoom: Double = MIN_ZOOM,
    val centre: Point? = null,
    val turn: Double = 0.0,
    val robot: Int = 0,
) {
    companion object {
        const val MIN_ZOOM = 1.0
        const val MAX_ZOOM = 8.0

        /** Paper as one has it in front of oneself. */
        const val HEADING = 90.0
        const val PITCH = 46.0
    }
}
