package robotran.rcxrom.controls

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.controls.MotorState
import robotran.brick.kind.BrickKind
import robotran.rcxrom.memory.RcxMemory

/**
 * The three output ports. As in the ROM, each port has two direction bits and an eight-bit waveform, which rotates by
 * one bit a millisecond. In a millisecond with a 0 bit the port is off and the motor coasts. Source: brickEmu's ROM
 * re-implementation.
 */
internal class Motors(private val memory: RcxMemory) {
    /** The commands for the ports, in the order of [MotorPort]. */
    var states: List<MotorState> = BrickKind.RCX.motorPorts.map { MotorState(it, MotorMode.FLOAT, power = 0) }
        private set

    init {
        states.forEach(::writeToMemory)
    }

    /** Sets the mode and the [power], 0..7, of [port]. If [mode] is null, the port keeps its mode. */
    fun control(port: MotorPort, mode: MotorMode?, power: Int) {
        val state = MotorState(port, mode ?: states[port.ordinal].mode, power)
        states = states.map { if (it.port == port) state else it }
        writeToMemory(state)
    }

    /**
     * Sets the direction bits and the waveform of [port], like the ROM's internal routine. That routine uses only the
     * two lowest bits of a mode, so 0 floats the motor like 4.
     */
    fun control(port: MotorPort, modeBits: Int, power: Int) {
        val mode = MotorMode.entries[(modeBits + MODES - 1) % MODES]
        control(port, mode, power)
    }

    /** Floats all motors at once. Keeps their waveforms. */
    fun shutdown() {
        states = states.map { it.copy(mode = MotorMode.FLOAT) }
        memory.writeByte(DIRECTIONS, 0)
        memory.writeByte(OUTPUT_SHADOW, 0)
        memory.writeByte(OUTPUT_LATCH, 0)
    }

    /** Advances by one millisecond: rotates the waveforms and sets the output latch. */
    fun tick() {
        var output = memory.readByte(DIRECTIONS)
        for (port in BrickKind.RCX.motorPorts) {
            val waveform = memory.readByte(WAVEFORMS + port.ordinal)
            val slotIsOn = waveform and 1 == 1
            memory.writeByte(WAVEFORMS + port.ordinal, (waveform shr 1) or (if (slotIsOn) TOP_BIT else 0))
            if (!slotIsOn) output = output and (DIRECTION_MASK shl shift(port)).inv()
        }
        memory.writeByte(OUTPUT_SHADOW, output)
        memory.writeByte(OUTPUT_LATCH, output)
    }

    /** What the latch makes [port] do in this millisecond. */
    fun output(port: MotorPort): MotorMode = when (memory.readByte(OUTPUT_LATCH) shr shift(port) and DIRECTION_MASK) {
        FORWARD_BITS -> MotorMode.FORWARD
        BACKWARD_BITS -> MotorMode.BACKWARD
        BRAKE_BITS -> MotorMode.BRAKE
        else -> MotorMode.FLOAT
    }

    private fun writeToMemory(state: MotorState) {
        val bits = when (state.mode) {
            MotorMode.FORWARD -> FORWARD_BITS
            MotorMode.BACKWARD -> BACKWARD_BITS
            MotorMode.BRAKE -> BRAKE_BITS
            MotorMode.FLOAT -> 0
        }
        val others = memory.readByte(DIRECTIONS) and (DIRECTION_MASK shl shift(state.port)).inv()
        memory.writeByte(DIRECTIONS, others or (bits shl shift(state.port)))
        memory.writeByte(WAVEFORMS + state.port.ordinal, WAVEFORM_OF_POWER[state.power])
    }

    private fun shift(port: MotorPort): Int = when (port) {
        MotorPort.A -> 6
        MotorPort.B -> 2
        else -> 0
    }

    companion object {
        /** The direction bits of all ports: A in bits 7 and 6, B in 3 and 2, C in 1 and 0. */
        const val DIRECTIONS = 0xEFCA

        /** The three waveforms, motor A first. */
        const val WAVEFORMS = 0xEFCB

        /** A copy of the latch; a real brick cannot read the latch itself. */
        const val OUTPUT_SHADOW = 0xEFCE

        /** The latch that switches the ports; bits as in [DIRECTIONS]. */
        const val OUTPUT_LATCH = 0xF000

        private const val FORWARD_BITS = 2
        private const val BACKWARD_BITS = 1
        private const val BRAKE_BITS = 3
        private const val DIRECTION_MASK = 3
        private const val MODES = 4
        private const val TOP_BIT = 0x80
        private val WAVEFORM_OF_POWER = listOf(0x01, 0x11, 0x49, 0x55, 0x6D, 0x77, 0x7F, 0xFF)
    }
}
