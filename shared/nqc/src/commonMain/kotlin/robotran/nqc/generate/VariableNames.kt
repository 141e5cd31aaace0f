package robotran.nqc.generate

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.VariableTable
import robotran.nqc.tree.Variable

/** The names of variables in the order in which they got their places. */
internal class VariableNames {
    /** @property owner the task or subroutine that knows the variable; null for all. */
    class Named(val variable: Variable, val place: Int, val owner: ChunkId?)

    val all = mutableListOf<Named>()

    /** The task or subroutine whose code is being generated; null before any. */
    var owner: ChunkId? = null

    /** What a debugger shows: all but the parameters of the API. */
    val table: VariableTable
        get() {
            val (shared, own) = all.filter { it.variable.range.line > 0 }.partition { it.owner == null }
            return VariableTable(
                namesOf(shared),
                own.groupBy { checkNotNull(it.owner) }.mapValues { namesOf(it.value) },
            )
        }

    fun add(variable: Variable, index: Int) {
        all += Named(variable, index, owner)
    }

    private fun namesOf(variables: List<Named>) = variables.groupBy({ it.place }, { it.variable.name })
}
