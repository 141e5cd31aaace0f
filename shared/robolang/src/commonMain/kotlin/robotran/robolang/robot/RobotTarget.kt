package robotran.robolang.robot

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind

/** The robot that a program is compiled for. Its figures belong to the robot, not to the language. */
sealed interface RobotTarget {
    val kind: BrickKind

    /**
     * A robot with an RCX, whose motors run for a time.
     *
     * @property millisecondsPerCentimetre how long both motors run per centimetre.
     * @property millisecondsPerDegree how long they run in opposite directions per degree.
     */
    data class Rcx(val millisecondsPerCentimetre: Double, val millisecondsPerDegree: Double) : RobotTarget {
        override val kind: BrickKind get() = BrickKind.RCX
    }

    /**
     * A robot with an NXT, whose motors count degrees.
     *
     * @property wheelDiameter in centimetres.
     * @property track the distance between the middles of the drive wheels, in centimetres.
     * @property pen the motor of the pen; null if the robot has none.
     */
    data class Nxt(
        val wheelDiameter: Double,
        val track: Double,
        val left: MotorPort = MotorPort.A,
        val right: MotorPort = MotorPort.C,
        val pen: MotorPort? = MotorPort.B,
    ) : RobotTarget {
        override val kind: BrickKind get() = BrickKind.NXT
    }
}
