package robotran.robolang.python

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Statement

/** What a statement belongs to, which decides what is asked before it. */
internal sealed interface PythonPlace {
    /** The lines before [statement]. */
    fun linesBefore(statement: Statement, program: CheckedProgram): List<String> = emptyList()

    /** The main program without tasks, or a routine that behaviours call. */
    data object Plain : PythonPlace

    /** The main program as a task: it waits while a behaviour acts. */
    data class MainTask(private val uses: PythonUses) : PythonPlace {
        override fun linesBefore(statement: Statement, program: CheckedProgram): List<String> = myTurn(statement, uses)
    }

    /**
     * A routine.
     *
     * @property result the type of what a function gives back; null for a procedure.
     * @property uses of a routine that only the main program calls, in a program with tasks; otherwise null.
     */
    data class Routine(val result: ValueType?, private val uses: PythonUses?) : PythonPlace {
        override fun linesBefore(statement: Statement, program: CheckedProgram): List<String> =
            if (uses == null) emptyList() else myTurn(statement, uses)
    }

    /** The lines of behaviour [number]; if a later one can take over, they end then. */
    class Behaviour(private val number: Int, private val isLast: Boolean, private val first: Statement?) : PythonPlace {
        override fun linesBefore(statement: Statement, program: CheckedProgram): List<String> =
            if (isLast || statement === first || !acts(statement)) {
                emptyList()
            } else {
                listOf("if acting != $number:", "    return")
            }
    }
}

private fun myTurn(statement: Statement, uses: PythonUses): List<String> =
    if (acts(statement)) listOf("await ${uses.use(PythonHelper.MY_TURN)}()") else emptyList()

private fun acts(statement: Statement): Boolean = statement is Command || statement is Statement.Halt
