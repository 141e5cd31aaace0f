package robotran.legofirmware.run

import robotran.legofirmware.image.LineTable
import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.OpcodeUse
import robotran.legofirmware.task.LoadedChunk
import robotran.legofirmware.task.Location
import robotran.legofirmware.task.Task
import robotran.legofirmware.warning.FirmwareWarning

/** Executes instructions of tasks. */
internal class Interpreter(private val core: Core) {
    private val arithmetic = Arithmetic(core)
    private val flow = Flow(core)
    private val devices = DeviceCommands(core)
    private val events = EventCommands(core)

    /** The lines of the running program. */
    var lines = LineTable.NONE

    /** Executes the next instruction of [task]: the end of its code counts as one. */
    fun step(task: Task) {
        val location = task.location ?: return
        val chunk = location.chunk
        task.wake()
        task.begun = location
        core.at(lines.lineOf(chunk.id, location.address))
        if (chunk.isEnd(location.address)) return flow.leave(task)
        val placed = chunk.instruction(location.address)
        if (placed == null) {
            core.warning(FirmwareWarning.InvalidOpcode(chunk.code[location.address], location.address))
            return task.stop()
        }
        val opcode = placed.instruction.opcode
        if (opcode.firmware > core.model.target) {
            core.warning(FirmwareWarning.NewerCommand(opcode.mnemonic))
            return task.stop()
        }
        task.location = Location(chunk, placed.end)
        task.isRepeating = !execute(placed.instruction, task, chunk)
        if (task.isRepeating) task.location = location
    }

    /** Executes a request over infrared light, as far as it is also a command of programs. */
    fun request(instruction: Instruction) {
        core.at(null)
        execute(instruction, core.requests, chunk = null)
    }

    /** Returns false if the instruction must be executed again. */
    private fun execute(instruction: Instruction, task: Task, chunk: LoadedChunk?): Boolean {
        if (instruction.opcode.use == OpcodeUse.REQUEST) {
            core.warning(FirmwareWarning.RequestOnly(instruction.opcode.mnemonic))
            return true
        }
        val isDone = arithmetic.execute(instruction, task) || flow.execute(instruction, task, chunk) ||
            events.execute(instruction, task, chunk) || devices.execute(instruction, task)
        return isDone || devices.send(instruction, task) != false
    }
}
