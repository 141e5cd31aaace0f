package robotran.robotediting

import robotran.brick.kind.WheelTrim
import robotran.world.RobotDescription

/**
 * What a buggy did on paper when programs drove it with the figures of another description.
 *
 * @property way how far it came when the program said 50 cm.
 * @property turn how far it turned when the program said 360 degrees.
 * @property side how far to the left of the way ahead it ended after [way]; below 0 to the right.
 */
internal data class TestDrives(val way: Double, val turn: Double, val side: Double) {
    /** [robot] with the figures that follow. */
    fun applied(robot: RobotDescription, driven: RobotDescription): RobotDescription {
        // A program with half the time a centimetre drives half as far: gear is what the time is in proportion to.
        val gear = driven.drive.gear * WAY / way
        val track = driven.drive.track * driven.drive.gear * TURN / (turn * gear)
        val slower = slower(track)
        val before = driven.buggy?.trim ?: WheelTrim.NONE
        val left = before.left * if (side < 0) slower else 1.0
        val right = before.right * if (side > 0) slower else 1.0
        val most = maxOf(left, right)
        return robot.copy(
            drive = robot.drive.copy(gear = gear, track = track),
            buggy = robot.buggy?.copy(trim = WheelTrim(left / most, right / most)),
        )
    }

    /**
     * What the power of the faster wheel is to be multiplied by. A robot that ends s beside a way of d has turned by about
     * 2 s / d radians, so one wheel has rolled that times the track farther.
     */
    private fun slower(track: Double): Double = 1 - 2 * (if (side < 0) -side else side) * track / (way * way)

    companion object {
        /** What [robot] says about the drives, the reverse of [applied]. */
        fun of(robot: RobotDescription, driven: RobotDescription): TestDrives {
            val way = WAY * driven.drive.gear / robot.drive.gear
            val turn = TURN * driven.drive.track * driven.drive.gear / (robot.drive.track * robot.drive.gear)
            val now = robot.buggy?.trim ?: WheelTrim.NONE
            val before = driven.buggy?.trim ?: WheelTrim.NONE
            // Above 1 if the right wheel has been slowed down.
            val ratio = now.left / before.left / (now.right / before.right)
            val size = way * way / (2 * robot.drive.track)
            val side = if (ratio > 1) (1 - 1 / ratio) * size else -(1 - ratio) * size
            return TestDrives(way, turn, side)
        }
    }
}
