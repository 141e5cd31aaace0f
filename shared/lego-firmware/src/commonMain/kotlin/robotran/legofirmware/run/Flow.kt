package robotran.legofirmware.run

import robotran.legofirmware.image.ChunkKind
import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.Operand
import robotran.legofirmware.instructions.Relation
import robotran.legofirmware.model.Assumptions
import robotran.legofirmware.task.LoadedChunk
import robotran.legofirmware.task.Location
import robotran.legofirmware.task.Task
import robotran.legofirmware.warning.FirmwareWarning

/** Commands that decide what is executed next. */
internal class Flow(private val core: Core) {
    private val tasks get() = core.tasks

    /** Returns false if [instruction] is not one of these. */
    fun execute(instruction: Instruction, task: Task, chunk: LoadedChunk?): Boolean {
        when (instruction.opcode) {
            Opcode.JMP, Opcode.JMPL -> jump(instruction, task, chunk)
            Opcode.CHK, Opcode.CHKL -> if (isTrue(instruction, task)) jump(instruction, task, chunk)
            Opcode.LOOPS -> beginLoop(core.values.read(instruction.value(0), task), task)
            Opcode.LOOPC, Opcode.LOOPCL -> countLoop(instruction, task, chunk)
            Opcode.DECVJN, Opcode.DECVJNL -> countVariable(instruction, task, chunk)
            Opcode.CALLS -> call(instruction.number(0), task)
            Opcode.RETS -> leave(task)
            Opcode.WAIT -> wait(core.values.read(instruction.value(0), task), task)
            Opcode.START -> if (!tasks.start(
                    instruction.number(0),
                )
            ) {
                core.warning(FirmwareWarning.NoTask(instruction.number(0)))
            }
            Opcode.STOP -> tasks.stop(instruction.number(0))
            Opcode.STOP_ALL -> tasks.stopAll()
            Opcode.PRGM -> core.selectSlot(instruction.number(0))
            Opcode.SETP -> task.priority = instruction.number(0)
            else -> return false
        }
        return true
    }

    /** The end of a subroutine or task, which a brick marks with a return. */
    fun leave(task: Task) {
        val isSub = task.location?.chunk?.id?.kind == ChunkKind.SUB
        val returnTo = task.returnTo
        when {
            !isSub -> task.stop()
            returnTo == null -> tasks.stopAll()

            else -> {
                task.location = returnTo
                task.returnTo = null
            }
        }
    }

    private fun jump(instruction: Instruction, task: Task, chunk: LoadedChunk?) {
        if (chunk == null) return
        val target = instruction.jumpTarget()
        if (target !in 0..chunk.code.size) core.warning(FirmwareWarning.JumpOut)
        task.location = Location(chunk, target)
    }

    private fun isTrue(instruction: Instruction, task: Task): Boolean {
        val test = instruction.operands[0] as Operand.Test
        val left = core.values.read(test.left, task)
        val right = core.values.read(test.right, task)
        return when (test.relation) {
            Relation.AT_MOST -> left <= right
            Relation.AT_LEAST -> left >= right
            Relation.NOT_EQUAL -> left != right
            Relation.EQUAL -> left == right
        }
    }

    private fun beginLoop(count: Int, task: Task) {
        if (!task.loops.push(count.coerceIn(0, Assumptions.LOOP_COUNT))) core.warning(FirmwareWarning.TooManyLoops)
    }

    private fun countLoop(instruction: Instruction, task: Task, chunk: LoadedChunk?) {
        val goesOn = task.loops.countDown()
        if (goesOn == null) core.warning(FirmwareWarning.NoLoop)
        if (goesOn != true) jump(instruction, task, chunk)
    }

    private fun countVariable(instruction: Instruction, task: Task, chunk: LoadedChunk?) {
        val number = instruction.number(0)
        core.setVariable(number, core.variable(number, task) - 1, task)
        if (core.variable(number, task) < 0) jump(instruction, task, chunk)
    }

    private fun call(number: Int, task: Task) {
        val sub = tasks.sub(number)
        if (sub == null) {
            core.warning(FirmwareWarning.NoSub(number))
            return
        }
        if (task.returnTo != null ||
            task.location?.chunk?.id?.kind == ChunkKind.SUB
        ) {
            core.warning(FirmwareWarning.NestedCall)
        }
        task.returnTo = task.location
        task.location = Location(sub, 0)
    }

    private fun wait(hundredths: Int, task: Task) {
        if (hundredths > 0) task.waitUntil(core.now + hundredths * HUNDREDTH)
    }

    private companion object {
        const val HUNDREDTH = 10L
    }
}
