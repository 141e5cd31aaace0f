package robotran.nqc.generate

import robotran.nqc.tree.Variable

/** The names of variables in the order in which they got their places. */
internal class VariableNames {
    class Named(val variable: Variable, val place: Int)

    val all = mutableListOf<Named>()

    fun add(variable: Variable, place: Int) {
        all += Named(variable, place)
    }
}
