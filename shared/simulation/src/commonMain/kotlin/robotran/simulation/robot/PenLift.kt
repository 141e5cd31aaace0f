package robotran.simulation.robot

import robotran.brick.controls.MotorState
import robotran.simulation.config.SimulationLimits
import robotran.world.Penbot
import robotran.world.robot.RobotParameters

/** The pen on its motor. It starts lifted. */
internal class PenLift {
    private val motor = RcxMotor(RobotParameters.PENBOT)

    /** 0 at the upper end stop, 1 at the lower. */
    var depth = 0.0
        private set

    /** Whether the tip touches the paper. */
    val isDown: Boolean get() = depth >= Penbot.PEN_CONTACT

    fun tick(command: MotorState) {
        motor.tick(command)
        depth = (depth + motor.speed * SimulationLimits.TICK_SECONDS / TRAVEL).coerceIn(0.0, 1.0)
    }

    private companion object {
        /** The distance that a tyre on this motor would roll from end stop to end stop, in centimetres. */
        const val TRAVEL = Penbot.PEN_TRAVEL_TIME / Penbot.MILLISECONDS_PER_CENTIMETRE
    }
}
