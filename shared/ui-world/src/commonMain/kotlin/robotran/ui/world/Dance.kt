package robotran.ui.world

import androidx.compose.animation.core.Animatable
import androidx.compose.animation.core.LinearEasing
import androidx.compose.animation.core.tween
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import robotran.simulation.state.SessionState
import robotran.uikit.*
import kotlin.math.PI
import kotlin.math.sin

/**
 * [session] with the pupil's robot dancing on the spot for a moment once [isSolved]. Only the picture moves, not the
 * run, so the sheet and the 3D view show the same dance. With reduced motion the robot stands still.
 */
@Composable
internal fun dancing(session: SessionState, isSolved: Boolean): SessionState {
    val danced = remember { Animatable(0f) }
    val isStill = LocalLessMotion.current
    LaunchedEffect(isSolved, isStill) {
        danced.snapTo(0f)
        if (isSolved && !isStill) {
            danced.animateTo(1f, tween(Motion.DANCE, easing = LinearEasing))
            danced.snapTo(0f)
        }
    }
    val angle = danceAngle(danced.value)
    if (angle == 0.0) return session
    val first = session.robots.first()
    val pose = first.robot.pose
    val turned = first.copy(robot = first.robot.copy(pose = pose.copy(heading = pose.heading + angle)))
    return session.copy(robots = listOf(turned) + session.robots.drop(1))
}

/** How far the robot is turned to its left, in degrees, after the part [danced] of its dance: less and less. */
internal fun danceAngle(danced: Float): Double =
    if (danced !in 0f..<1f) 0.0 else MAX_ANGLE * (1 - danced) * sin(2 * PI * SWAYS * danced)

/** In degrees. */
private const val MAX_ANGLE = 22.0

/** From one side to the other and back. */
private const val SWAYS = 4
