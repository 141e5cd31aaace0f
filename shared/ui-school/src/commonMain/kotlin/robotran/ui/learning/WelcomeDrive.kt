package robotran.ui.learning

import robotran.simulation.state.RobotState
import robotran.world.Penbot
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin

/** A command of the robot on the welcome page: a way in centimetres, or a turn to the left in degrees. */
internal sealed interface WelcomeCommand {
    /** In Robolang, as a pupil would write it. */
    val text: String

    data class Forward(val centimetres: Int) : WelcomeCommand {
        override val text get() = "forward $centimetres"
    }

    data class TurnLeft(val degrees: Int) : WelcomeCommand {
        override val text get() = "turn left $degrees"
    }
}

/**
 * What the robot of the welcome page does at one moment.
 *
 * @property command null once it has finished.
 * @property line what it has drawn, and the place of its pen at the end.
 */
internal class WelcomeMoment(val robot: RobotState, val command: WelcomeCommand?, val line: List<Point>)

/**
 * A drive of an exact penbot from [start] with its pen down. It takes as long as in a session, by the calibration in
 * [Penbot], and needs neither session nor physics, so the page shows it at once.
 */
internal class WelcomeDrive(private val start: Pose, private val commands: List<WelcomeCommand>) {
    /** In milliseconds. */
    val duration: Long = commands.sumOf { durationOf(it) }.toLong()

    /** The moment [milliseconds] after the start; the last one after [duration]. */
    fun at(milliseconds: Long): WelcomeMoment {
        var rest = milliseconds.toDouble()
        var pose = start
        var left = 0.0
        var right = 0.0
        val line = mutableListOf(Point(pose.x, pose.y))
        for (command in commands) {
            val share = (rest / durationOf(command)).coerceIn(0.0, 1.0)
            when (command) {
                is WelcomeCommand.Forward -> {
                    pose = pose.moved(command.centimetres * share)
                    line += Point(pose.x, pose.y)
                    left += command.centimetres * share
                    right += command.centimetres * share
                }

                is WelcomeCommand.TurnLeft -> {
                    val arc = command.degrees * share / HALF_TURN * PI * Penbot.WHEEL_TRACK / 2
                    pose = pose.copy(heading = pose.heading + command.degrees * share)
                    left -= arc
                    right += arc
                }
            }
            if (share < 1.0) return WelcomeMoment(robotAt(pose, left, right, isDown = true), command, line)
            rest -= durationOf(command)
        }
        return WelcomeMoment(robotAt(pose, left, right, isDown = false), null, line)
    }

    private fun durationOf(command: WelcomeCommand): Double = when (command) {
        is WelcomeCommand.Forward -> command.centimetres * Penbot.MILLISECONDS_PER_CENTIMETRE
        is WelcomeCommand.TurnLeft -> abs(command.degrees) * Penbot.MILLISECONDS_PER_DEGREE
    }

    private fun robotAt(pose: Pose, left: Double, right: Double, isDown: Boolean) = RobotState(
        pose,
        left / Penbot.WHEEL_CIRCUMFERENCE,
        right / Penbot.WHEEL_CIRCUMFERENCE,
        penDown = isDown,
        leftBumperPressed = false,
        rightBumperPressed = false,
    )

    private fun Pose.moved(centimetres: Double): Pose {
        val angle = heading / HALF_TURN * PI
        return copy(x = x + centimetres * cos(angle), y = y + centimetres * sin(angle))
    }

    companion object {
        private const val HALF_TURN = 180.0

        /** The paper of the welcome page, in centimetres. */
        const val WIDTH = 72.0
        const val HEIGHT = 48.0

        /** What the pupil may try next: the square of the first program, a star, and a square that grows. */
        val ALL: List<WelcomeDrive> = listOf(
            WelcomeDrive(Pose(25.0, 13.0, 0.0), shape(4, 22, 90)),
            WelcomeDrive(Pose(21.0, 20.7, 0.0), shape(5, 30, 144)),
            WelcomeDrive(Pose(38.5, 24.5, 0.0), (1..8).flatMap { side(4 * it - 1, 91) }),
        )

        private fun shape(sides: Int, centimetres: Int, degrees: Int) = (1..sides).flatMap {
            side(centimetres, degrees)
        }

        private fun side(centimetres: Int, degrees: Int) =
            listOf(WelcomeCommand.Forward(centimetres), WelcomeCommand.TurnLeft(degrees))
    }
}
