package robotran.nqc.generate

import robotran.nqc.tree.FunctionUnit
import robotran.nqc.tree.Statement

/**
 * What statements can name.
 *
 * @property tasks the numbers of the tasks.
 * @property subs the subroutines.
 * @property functions the functions of the program and of the API.
 */
internal class ProgramUnits(
    val tasks: Map<String, Int>,
    val subs: Map<String, SubCode>,
    val functions: Map<String, FunctionUnit>,
) {
    private val jumps = HashMap<Statement, Jumps>()

    fun jumpsOf(body: Statement): Jumps = jumps.getOrPut(body) { Jumps(body) }
}

/** A subroutine whose code is generated before that of the tasks. */
internal class SubCode(val number: Int) {
    /** The tasks that call it. */
    val tasks = HashSet<Int>()

    /** The local variables that it uses. */
    var locals: Set<Int> = emptySet()
}
