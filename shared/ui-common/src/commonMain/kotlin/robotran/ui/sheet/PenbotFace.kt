package robotran.ui.sheet

import androidx.compose.runtime.Immutable
import androidx.compose.ui.geometry.Offset
import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorState
import robotran.brick.state.RunState
import robotran.simulation.state.RobotSnapshot
import robotran.simulation.state.SessionState
import robotran.world.Drive
import robotran.world.ReadyRobots

/**
 * What a penbot's eyes show at one moment. Only drawn: the run knows nothing of it.
 *
 * @property gaze where the pupils are, from the middle of the eyes: x forwards, y to the robot's right, at most 1 long.
 * @property lid how far the eyes are closed, from 0 to 1.
 * @property mood decides the shape of the lids.
 */
@Immutable
data class PenbotFace(val gaze: Offset = Offset.Zero, val lid: Float = 0f, val mood: PenbotMood = PenbotMood.CALM) {
    companion object {
        /** It looks up at the pupil. */
        val STILL = PenbotFace()
    }
}

/**
 * The face of the robot with the index [robot]; it follows from [state] alone.
 *
 * @param isStill whether its eyes never move, as for less motion.
 * @param drive its motors.
 */
fun penbotFace(
    state: SessionState,
    robot: Int,
    isStill: Boolean = false,
    drive: Drive = ReadyRobots.RCX_PENBOT.drive,
): PenbotFace {
    if (isStill) return PenbotFace.STILL
    val snapshot = state.robots[robot]
    return PenbotFace(
        gaze = gazeOf(snapshot, drive),
        lid = lidOf(state.milliseconds, robot, snapshot),
        mood = penbotMood(state, robot),
    )
}

/** Where it drives to; while it stands, it looks up. */
private fun gazeOf(snapshot: RobotSnapshot, drive: Drive): Offset {
    val forwards = if (drive.reversed) -1f else 1f
    val left = driveOf(snapshot.brick.motors[drive.left.ordinal]) * forwards
    val right = driveOf(snapshot.brick.motors[drive.right.ordinal]) * forwards
    return Offset((left + right) / 2, (left - right) / 2)
}

private fun driveOf(motor: MotorState): Float = when (motor.mode) {
    MotorMode.FORWARD -> 1f
    MotorMode.BACKWARD -> -1f
    MotorMode.BRAKE, MotorMode.FLOAT -> 0f
}

/** A blink every few seconds of a run, at times of its own for each robot, so that they do not blink together. */
private fun lidOf(milliseconds: Long, robot: Int, snapshot: RobotSnapshot): Float {
    if (snapshot.brick.run !is RunState.Running) return 0f
    val slot = milliseconds / BLINK_EVERY
    val begin = FIRST_BLINK + (slot * SCATTER + robot * ROBOT_SCATTER) % (BLINK_EVERY - FIRST_BLINK - BLINK)
    return if (milliseconds % BLINK_EVERY in begin..begin + BLINK) 1f else 0f
}

/** Milliseconds of virtual time. */
private const val BLINK_EVERY = 5_200L
private const val BLINK = 140L
private const val FIRST_BLINK = 900L

/** Primes, so that the blinks of one robot, and of several, look unplanned. */
private const val SCATTER = 1_327L
private const val ROBOT_SCATTER = 2_017L
