package robotran.legofirmware.run

import robotran.brick.program.BrickProgram
import robotran.brick.program.RuntimeWarning
import robotran.legofirmware.device.Devices
import robotran.legofirmware.device.RomCalls
import robotran.legofirmware.event.Events
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.messages.FirmwareRunMessages
import robotran.legofirmware.model.FirmwareModel
import robotran.legofirmware.task.AccessControl
import robotran.legofirmware.task.Task
import robotran.legofirmware.task.Tasks
import robotran.legofirmware.warning.FirmwareWarning
import robotran.legofirmware.warning.FirmwareWarnings
import robotran.rcxrom.program.Rom

/** All that the firmware knows; the parts of the machine share it. */
internal class Core(rom: Rom, val messages: FirmwareRunMessages) {
    val calls = RomCalls(rom)
    val devices = Devices(calls)
    val variables = Variables()
    val tasks = Tasks()
    val access = AccessControl(tasks)
    val values = Values(this)
    val events = Events(values, tasks)

    /** The task that executes requests over infrared light. */
    val requests = Task(Task.REQUESTS)

    private var collectedWarnings = FirmwareWarnings(messages)
    private var place: CodeLine? = null

    var model = FirmwareModel.of(FirmwareTarget.RCX2)
        private set

    val now: Long get() = calls.rom.milliseconds

    val warnings: List<RuntimeWarning> get() = collectedWarnings.all

    /** Forgets what belongs to the last program. */
    fun begin(target: FirmwareTarget) {
        model = FirmwareModel.of(target)
        collectedWarnings = FirmwareWarnings(messages)
        events.clear()
    }

    /** The place of what follows in the source; null for the firmware itself. */
    fun at(line: CodeLine?) {
        place = line
        calls.at(line?.line ?: RomCalls.NO_LINE, line?.file)
    }

    fun warning(warning: FirmwareWarning) = collectedWarnings.add(warning, place?.line ?: RomCalls.NO_LINE, place?.file)

    /** The value of a variable; 0 if [task] has none with this number. */
    fun variable(number: Int, task: Task): Int = if (hasVariable(number)) variables.get(number, task) else 0

    fun setVariable(number: Int, value: Int, task: Task) {
        if (hasVariable(number)) variables.set(number, value, task)
    }

    /** What another brick's message does, or a program's own. */
    fun setMessage(message: Int) {
        devices.infrared.message = message
        events.noteMessage()
    }

    /** Stops everything and selects a slot; nothing but a stop if there is none with this number. */
    fun selectSlot(number: Int) {
        tasks.stopAll()
        if (has(number, BrickProgram.MAX_PROGRAMS)) devices.slot = number
    }

    /** Whether [number] is one of [count] things; if not, a warning says so. */
    fun has(number: Int, count: Int): Boolean {
        if (number in 0 until count) return true
        warning(FirmwareWarning.NoPort(number))
        return false
    }

    private fun hasVariable(number: Int): Boolean {
        if (variables.exists(number, model.isSecond)) return true
        warning(FirmwareWarning.NoVariable(number))
        return false
    }
}
