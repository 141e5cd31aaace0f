package robotran.nxt.hardware

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState

/**
 * The three output ports and their counters. Commands and counts cross over to the processor of the ports and back
 * every 2 milliseconds, in [exchange].
 */
internal class MotorPorts {
    private val commanded = Array(PORTS) { MotorState(MotorPort.entries[it], MotorMode.FLOAT, power = 0) }
    private val hubDegrees = IntArray(PORTS)
    private val counted = IntArray(PORTS)
    private val zero = IntArray(PORTS)

    /** The commands that the motors follow, A to C. The list and its elements stay the same until one changes. */
    var states: List<MotorState> = commanded.toList()
        private set

    /** What a program has told [port], 0..2, to do. */
    fun commanded(port: Int): MotorState = commanded[port]

    /**
     * Tells [port] what to do from the next exchange on.
     *
     * @param power -100..100; other values are clamped. Below 0 is backward.
     * @param brakes whether it brakes in the pauses of the pulses, and with power 0; otherwise it rolls.
     */
    fun control(port: Int, power: Int, brakes: Boolean) {
        val mode = when {
            power > 0 -> MotorMode.FORWARD
            power < 0 -> MotorMode.BACKWARD
            brakes -> MotorMode.BRAKE
            else -> MotorMode.FLOAT
        }
        val strength = power.coerceIn(-HIGHEST_POWER, HIGHEST_POWER).let { if (it < 0) -it else it }
        val old = commanded[port]
        if (old.mode == mode && old.power == strength && old.brakesInPauses == brakes) return
        commanded[port] = MotorState(MotorPort.entries[port], mode, strength, brakes)
    }

    /** Sets how far the hub of [port] has turned since the beginning of time. */
    fun setHubDegrees(port: Int, degrees: Int) {
        hubDegrees[port] = degrees
    }

    /** Passes on the commands and takes the counts. */
    fun exchange() {
        hubDegrees.copyInto(counted)
        for (port in 0..<PORTS) {
            if (states[port] !== commanded[port]) {
                states = commanded.toList()
                return
            }
        }
    }

    fun tachoCount(port: Int): Int = counted[port] - zero[port]

    fun resetTachoCount(port: Int) {
        zero[port] = counted[port]
    }

    companion object {
        const val PORTS = 3
        const val EXCHANGE_MILLISECONDS = 2
        const val HIGHEST_POWER = 100
    }
}
