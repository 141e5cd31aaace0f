package robotran.nqc.parse

import robotran.language.source.SourceRange
import robotran.nqc.tree.Variable

/** What names mean at the place where the parser is. */
internal class Scopes(private val predefined: Set<String>) {
    private val scopes = mutableListOf(HashMap<String, Variable>())

    /** Tasks, subroutines and functions of the program with their places. */
    private val units = HashMap<String, SourceRange>()

    private val isGlobal: Boolean get() = scopes.size == 1

    /** All names that a value can begin with here. */
    val variableNames: List<String> get() = scopes.flatMap { it.keys }

    fun <T> inScope(body: () -> T): T {
        scopes += HashMap<String, Variable>()
        try {
            return body()
        } finally {
            scopes.removeAt(scopes.lastIndex)
        }
    }

    /** Declares a variable here; false if its name is taken. */
    fun declare(variable: Variable): Boolean {
        if (isGlobal && isUnit(variable.name)) return false
        return scopes.last().getOrPut(variable.name) { variable } === variable
    }

    /** Declares a task, subroutine or function; false if its name is taken. */
    fun declareUnit(name: String, range: SourceRange): Boolean {
        if (isUnit(name) || name in scopes.first()) return false
        units[name] = range
        return true
    }

    private fun isUnit(name: String) = name in units || name in predefined

    /** The line in which [name] is declared here; null if in none of the program's. */
    fun lineOf(name: String): Int? = (scopes.last()[name]?.range ?: units[name])?.line?.takeIf { it > 0 }

    fun variable(name: String): Variable? = scopes.asReversed().firstNotNullOfOrNull { it[name] }

    /** Whether variables declared here are global. */
    val declaresGlobals: Boolean get() = isGlobal
}
