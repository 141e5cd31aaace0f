package robotran.legofirmware.run

import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.task.LoadedChunk
import robotran.legofirmware.task.Location
import robotran.legofirmware.task.Monitor
import robotran.legofirmware.task.Task

/** Commands of firmware 2.0 for events and access control. */
internal class EventCommands(private val core: Core) {
    /** Returns false if [instruction] is not one of these. */
    fun execute(instruction: Instruction, task: Task, chunk: LoadedChunk?): Boolean {
        when (instruction.opcode) {
            Opcode.SETE -> core.events.define(instruction.number(0), instruction.number(1), instruction.number(2))
            Opcode.DELE -> core.events.clear()
            Opcode.CALE -> calibrate(instruction)
            Opcode.EVENT -> core.events.fire(core.values.read(instruction.value(0), task))

            Opcode.MONE, Opcode.MONEL -> {
                val mask = core.values.read(instruction.value(0), task)
                task.activeEvents = 0
                task.monitor = monitor(instruction, mask, task, chunk)
            }

            Opcode.MONEX -> task.monitor = null

            Opcode.MONAL -> {
                monitor(instruction, instruction.number(0), task, chunk)?.let { core.access.request(task, it) }
            }

            Opcode.MONAX -> task.access = null
            else -> return false
        }
        return true
    }

    private fun calibrate(instruction: Instruction) = core.events.calibrate(
        instruction.number(0),
        upper = instruction.number(1),
        lower = instruction.number(2),
        hysteresis = instruction.number(HYSTERESIS),
        core.now,
    )

    private fun monitor(instruction: Instruction, mask: Int, task: Task, chunk: LoadedChunk?): Monitor? {
        val handler = Location(chunk ?: return null, instruction.jumpTarget())
        return Monitor(mask, handler, task.returnTo, task.loops.depth)
    }

    private companion object {
        const val HYSTERESIS = 3
    }
}
