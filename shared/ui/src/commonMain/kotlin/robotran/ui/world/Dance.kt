package robotran.ui.world

import androidx.compose.animation.core.Animatable
import androidx.compose.animation.core.LinearEasing
import androidx.compose.animation.core.tween
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import robotran.simulation.state.SessionState
import robotran.ui.theme.LocalLessMotion

/**
 * [session] with the pupil's robot dancing on the spot for a moment once [isSolved]. Only the picture moves, not the
 * run. With reduced motion the robot stands still.
 */
@Composable
internal fun dancing(session: SessionState, isSolved: Boolean): SessionState {
    val beat = remember { Animatable(0f) }
    val isStill = LocalLessMotion.current
    LaunchedEffect(isSolved, isStill) {
        beat.snapTo(0f)
        if (isSolved && !isStill) {
            beat.animateTo(BEATS, tween(MILLISECONDS, easing = LinearEasing))
            beat.snapTo(0f)
        }
    }
    val angle = swing(beat.value) * DEGREES
    if (angle == 0f) return session
    val first = session.robots.first()
    val pose = first.robot.pose
    val turned = first.copy(robot = first.robot.copy(pose = pose.copy(heading = pose.heading + angle)))
    return session.copy(robots = listOf(turned) + session.robots.drop(1))
}

/** To the left and back, then to the right and back, in one beat; -1..1. */
private fun swing(beat: Float): Float {
    val part = beat % 1f
    return when {
        part < QUARTER -> part / QUARTER
        part < 3 * QUARTER -> 2f - part / QUARTER
        else -> part / QUARTER - 4f
    }
}

private const val BEATS = 3f
private const val MILLISECONDS = 1_500
private const val DEGREES = 14f
private const val QUARTER = 0.25f
