package robotran.legofirmware.run

import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.model.wrapped
import robotran.legofirmware.task.Task

/** The variables that all tasks and programs share, and those that each task has for itself. */
internal class Variables {
    private val globals = IntArray(FirmwareLimits.GLOBAL_VARIABLES)

    /** Whether [task] has a variable with this number. */
    fun exists(number: Int, hasLocals: Boolean): Boolean =
        number in globals.indices || (hasLocals && number - globals.size in 0 until FirmwareLimits.LOCAL_VARIABLES)

    /** The value of a variable that exists. */
    fun get(number: Int, task: Task): Int =
        if (number < globals.size) globals[number] else task.locals[number - globals.size]

    /** Sets a variable that exists to the low 16 bits of [value]. */
    fun set(number: Int, value: Int, task: Task) {
        if (number < globals.size) {
            globals[number] = wrapped(value)
        } else {
            task.locals[number - globals.size] = wrapped(value)
        }
    }

    fun all(): List<Int> = globals.toList()
}
