package robotran.legofirmware.run

import robotran.legofirmware.device.Clocks
import robotran.legofirmware.device.Outputs
import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.task.Task
import robotran.legofirmware.warning.FirmwareWarning
import robotran.rcxrom.sensors.SensorCode

/** Commands to motors, sensors, loudspeaker, display, clocks, and infrared light. */
internal class DeviceCommands(private val core: Core) {
    private val devices get() = core.devices
    private val log = DatalogCommands(core)

    /** Returns false if [instruction] is not one of these. */
    fun execute(instruction: Instruction, task: Task): Boolean {
        if (toMotors(instruction, task) || toSensors(instruction) || toLoudspeaker(instruction, task)) return true
        when (instruction.opcode) {
            Opcode.VIEW -> devices.viewing.show(core.values.read(instruction.value(0), task), core.model.isSecond)
            Opcode.DISP -> show(instruction.number(0), instruction.value(1))
            Opcode.SETW -> setWatch(instruction.number(0), instruction.number(1))
            Opcode.TMRZ -> resetTimer(instruction.number(0))
            Opcode.TXS -> devices.infrared.setRange(isLong = instruction.number(0) != 0)
            Opcode.MSGZ -> devices.infrared.message = 0
            Opcode.MSGS -> core.setMessage(instruction.number(0))
            Opcode.TOUT -> devices.power.offMinutes = instruction.number(0)
            Opcode.OFFP -> devices.power.requestOff()
            Opcode.LOGZ -> devices.datalog.create(instruction.number(0))
            Opcode.LOG -> log.add(instruction.value(0), task)
            Opcode.PING, Opcode.POLLD, Opcode.REMOTE -> Unit
            else -> return false
        }
        return true
    }

    /**
     * Commands that send; false, and nothing is sent, if the infrared light is still busy. Then the command must be
     * executed again. Null if [instruction] is not one of these.
     */
    fun send(instruction: Instruction, task: Task): Boolean? {
        val opcode = instruction.opcode
        if (opcode != Opcode.MSG && opcode != Opcode.UART) return null
        if (!devices.infrared.isFree) return false
        if (opcode == Opcode.MSG) {
            devices.infrared.send(Opcode.MSGS.code, core.values.read(instruction.value(0), task) and BYTE)
        } else {
            devices.infrared.sendSerial(instruction.number(0), instruction.number(1))
        }
        return true
    }

    private fun setWatch(hours: Int, minutes: Int) = devices.clocks.setWatch(hours * Clocks.MINUTES_IN_HOUR + minutes)

    private fun resetTimer(number: Int) {
        if (core.has(number, Clocks.TIMERS)) devices.clocks.setTimer(number, 0)
    }

    private fun toMotors(instruction: Instruction, task: Task): Boolean {
        val outputs = devices.outputs
        when (instruction.opcode) {
            Opcode.OUT -> outputs.switch(instruction.number(0))
            Opcode.DIR -> outputs.turn(instruction.number(0))
            Opcode.PWR -> power(instruction, task) { mask, power -> outputs.power(mask, power) }
            Opcode.GOUT -> outputs.enable(instruction.number(0))
            Opcode.GDIR -> outputs.turnAll(instruction.number(0))
            Opcode.GPWR -> power(instruction, task) { mask, power -> outputs.limitPower(mask, power) }
            else -> return false
        }
        return true
    }

    private inline fun power(instruction: Instruction, task: Task, set: (Int, Int) -> Unit) {
        val power = core.values.read(instruction.value(1), task)
        if (power in
            0..Outputs.FULL_POWER
        ) {
            set(instruction.number(0), power)
        } else {
            core.warning(FirmwareWarning.WrongPower(power))
        }
    }

    private fun toSensors(instruction: Instruction): Boolean {
        val inputs = devices.inputs
        when (instruction.opcode) {
            Opcode.SENT -> sensor(instruction) { inputs.setType(it, instruction.number(1)) }
            Opcode.SENM -> sensor(instruction) { inputs.setMode(it, instruction.number(1)) }
            Opcode.SENZ -> sensor(instruction) { inputs.clear(it) }
            else -> return false
        }
        return true
    }

    private inline fun sensor(instruction: Instruction, change: (Int) -> Unit) {
        val port = instruction.number(0)
        if (core.has(port, SensorCode.PORTS)) change(port)
    }

    private fun toLoudspeaker(instruction: Instruction, task: Task): Boolean {
        val sounds = devices.sounds
        when (instruction.opcode) {
            Opcode.PLAYS -> sounds.play(instruction.number(0))
            Opcode.PLAYT -> sounds.tone(instruction.number(0), instruction.number(1))
            Opcode.PLAYV -> sounds.tone(core.variable(instruction.number(0), task), instruction.number(1))
            Opcode.PLAYZ -> sounds.clear()
            Opcode.MUTE -> sounds.isMuted = true
            Opcode.SPEAK -> sounds.isMuted = false
            else -> return false
        }
        return true
    }

    private fun show(decimals: Int, value: Operand.Value) =
        devices.viewing.setUserValue(decimals, value.source, value.argument)

    private companion object {
        const val BYTE = 0xFF
    }
}
