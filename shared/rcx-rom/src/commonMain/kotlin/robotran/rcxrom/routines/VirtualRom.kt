package robotran.rcxrom.routines

import robotran.brick.controls.BrickButton
import robotran.brick.log.CallLog
import robotran.brick.log.CallOutcome
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomSignature
import robotran.rcxrom.call.RomTable
import robotran.rcxrom.clock.Clock
import robotran.rcxrom.controls.Buttons
import robotran.rcxrom.infrared.InfraredLine
import robotran.rcxrom.log.RomLogEntry
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.SerialMemory
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorExpectations
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest
import robotran.rcxrom.sensors.Sensors

/**
 * The ROM as programs and the firmware see it: checks a call, runs the routine and adds the call to the [log].
 *
 * @param routines by address; every routine of [RomTable] that is not a gap.
 * @param clock the brick's clock.
 */
internal class VirtualRom(
    override val memory: RcxMemory,
    private val log: CallLog,
    private val routines: Map<Int, RomRoutine>,
    private val sensors: Sensors,
    private val expectations: SensorExpectations,
    private val buttons: Buttons,
    private val messages: BrickMessages,
    override val infraredLine: InfraredLine,
    private val clock: Clock,
) : Rom {
    override val milliseconds: Long get() = clock.milliseconds()

    override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
        val effect = perform(call)
        log.add(RomLogEntry(milliseconds, call, effect.meaning, sourceLine, effect.outcome, sourceFile))
    }

    override val pressedButtons: Set<BrickButton> get() = buttons.pressed - BrickButton.ON_OFF

    override val hasMessage: Boolean get() = memory.readByte(SerialMemory.VALID) != 0

    override fun readSensor(port: Int, request: SensorRequest): Int = sensors.value(port, request)

    override fun setSensorTypeAndMode(port: Int, type: Int, mode: Int) {
        setSensorValue(port, type, SensorField.TYPE)
        setSensorValue(port, mode, SensorField.MODE)
    }

    override fun setSensorValue(port: Int, value: Int, field: SensorField) {
        sensors.set(port, field, value)
        if (field == SensorField.TYPE) expectations.typeSet(port, sensors.type(port))
    }

    private fun perform(call: RomCall): RomEffect {
        val signature =
            RomTable.find(call.address) ?: return RomEffect(messages.unknownRoutine(), CallOutcome.UNKNOWN_ROUTINE)
        if (signature.gap != null) {
            return RomEffect(messages.notModelled(signature.name, signature.gap), CallOutcome.NOT_MODELLED)
        }
        val arguments = call.arguments.map { it and WORD }
        return refusal(signature, arguments) ?: routines.getValue(call.address)(arguments)
    }

    private fun refusal(signature: RomSignature, arguments: List<Int>): RomEffect? {
        val needed = signature.parameters.size
        val group = signature.codeGroup
        return when {
            arguments.size < needed -> refused(messages.tooFewArguments(signature.name, needed, arguments.size))
            group == null || arguments[0] shr BYTE_BITS == group -> null
            else -> refused(messages.wrongCodeGroup(signature.name, group))
        }
    }

    private companion object {
        const val WORD = 0xFFFF
        const val BYTE_BITS = 8
    }
}
