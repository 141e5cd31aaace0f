package robotran.rcxrom.routines

import robotran.brick.controls.MotorMode
import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.controls.Motors
import robotran.rcxrom.controls.romCode
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.messages.BrickMessages

/** The routines for the output ports. */
internal class MotorRoutines(
    private val memory: RcxMemory,
    private val motors: Motors,
    private val messages: BrickMessages,
) {
    val routines: Map<Int, RomRoutine> = mapOf(
        RomAddress.CONTROL_MOTOR to ::control,
        RomAddress.CONTROL_MOTOR_INTERNALLY to ::controlInternally,
        RomAddress.INIT_MOTORS to { RomEffect(messages.setUp("init motors")) },
        RomAddress.SHUTDOWN_MOTORS to { RomEffect(messages.setUp("shutdown motors")) },
    )

    private fun control(arguments: List<Int>): RomEffect {
        val (code, modeCode, powerWord) = arguments
        val port = BrickKind.RCX.motorPorts.find { it.romCode == code } ?: return refused(messages.unknownCode(code))
        val mode = MotorMode.entries.find { it.code == modeCode }
        val power = powerWord % POWERS
        motors.control(port, mode, power)
        return said(port, ignoredMode = modeCode.toShort().toInt().takeIf { mode == null }, powerWord.toShort().toInt())
    }

    private fun controlInternally(arguments: List<Int>): RomEffect {
        val (code, pointer) = arguments
        val port = BrickKind.RCX.motorPorts.getOrNull(code - RomCode.INTERNAL_MOTOR_A)
            ?: return refused(messages.unknownCode(code))
        val power = memory.readByte(pointer)
        motors.control(port, modeBits = memory.readByte(pointer + 1), power % POWERS)
        return said(port, ignoredMode = null, power)
    }

    private fun said(port: MotorPort, ignoredMode: Int?, givenPower: Int): RomEffect {
        val state = motors.states[port.ordinal]
        return RomEffect(
            messages.motor(
                port,
                state.mode,
                state.power,
                ignoredMode,
                givenPower.takeIf { it != state.power },
            ),
        )
    }

    private companion object {
        const val POWERS = 8
    }
}
