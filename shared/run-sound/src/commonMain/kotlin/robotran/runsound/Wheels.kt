package robotran.runsound

import robotran.simulation.state.RobotState
import kotlin.math.floor

/** The ticks of the wheels. One that has no room is made up for as soon as there is some, so that the rhythm stays. */
internal class Wheels {
    /** 1 or -1 for a wheel whose tick is due, as it rolls forwards or backwards; 0 for none. */
    private var left = 0
    private var right = 0

    fun forget() {
        left = 0
        right = 0
    }

    /** Notes which wheels have come to their next tick. */
    fun look(then: RobotState, now: RobotState) {
        rolled(then.leftWheelTurn, now.leftWheelTurn).let { if (it != 0) left = it }
        rolled(then.rightWheelTurn, now.rightWheelTurn).let { if (it != 0) right = it }
    }

    /** The tick that is due; null for none. Wheels that turn against each other tick one after the other. */
    fun due(milliseconds: Long): RunTone? = when {
        left == 0 && right == 0 -> null
        left == right -> tick(milliseconds, SoundValues.TICK_BOTH, 0.0, left).also { forget() }
        left != 0 -> tick(milliseconds, SoundValues.TICK_LEFT, -1.0, left).also { left = 0 }
        else -> tick(milliseconds, SoundValues.TICK_RIGHT, 1.0, right).also { right = 0 }
    }

    private fun rolled(from: Double, to: Double): Int =
        floor(to * SoundValues.TICKS_PER_TURN).compareTo(floor(from * SoundValues.TICKS_PER_TURN))

    private fun tick(milliseconds: Long, hertz: Double, pan: Double, way: Int) = RunTone(
        milliseconds,
        RunSign.WHEEL,
        if (way < 0) hertz * SoundValues.BACKWARDS else hertz,
        SoundValues.TICK_LENGTH,
        pan,
        Timbre.SQUARE,
        SoundValues.TICK_LOUDNESS,
    )
}
