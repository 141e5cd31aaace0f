package robotran.legofirmware.run

import robotran.legofirmware.instructions.Instruction
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.model.absolute
import robotran.legofirmware.task.Task
import robotran.legofirmware.warning.FirmwareWarning

/** Commands that calculate: 16 bits with a sign, which wrap round. */
internal class Arithmetic(private val core: Core) {
    private val places = Places(core)

    /** Returns false if [instruction] is not one of these. */
    fun execute(instruction: Instruction, task: Task): Boolean {
        when (instruction.opcode) {
            Opcode.SETV -> change(instruction, task) { _, value -> value }
            Opcode.SUMV -> change(instruction, task) { old, value -> old + value }
            Opcode.SUBV -> change(instruction, task) { old, value -> old - value }
            Opcode.MULV -> change(instruction, task) { old, value -> old * value }
            Opcode.DIVV -> change(instruction, task) { old, value -> quotient(old, value) }
            Opcode.SGNV -> change(instruction, task) { _, value -> value.compareTo(0) }
            Opcode.ABSV -> change(instruction, task) { _, value -> absolute(value) }
            Opcode.ANDV -> change(instruction, task) { old, value -> old and value }
            Opcode.ORV -> change(instruction, task) { old, value -> old or value }
            Opcode.SET -> places.write(instruction.value(0), core.values.read(instruction.value(1), task), task)
            Opcode.CNTI -> count(instruction, task) { it + 1 }
            Opcode.CNTD -> count(instruction, task) { it - 1 }
            Opcode.CNTZ -> count(instruction, task) { 0 }
            else -> return false
        }
        return true
    }

    private inline fun change(instruction: Instruction, task: Task, calculate: (Int, Int) -> Int) {
        val number = instruction.number(0)
        val value = core.values.read(instruction.value(1), task)
        core.setVariable(number, calculate(core.variable(number, task), value), task)
    }

    /** Truncates towards 0. */
    private fun quotient(dividend: Int, divisor: Int): Int {
        if (divisor != 0) return dividend / divisor
        core.warning(FirmwareWarning.DivisionByZero)
        return dividend
    }

    private inline fun count(instruction: Instruction, task: Task, change: (Int) -> Int) {
        val counter = instruction.number(0)
        if (core.has(counter, COUNTERS)) core.setVariable(counter, change(core.variable(counter, task)), task)
    }

    private companion object {
        /** Counters are the first variables. */
        const val COUNTERS = 3
    }
}
