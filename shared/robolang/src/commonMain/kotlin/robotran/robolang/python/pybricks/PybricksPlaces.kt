package robotran.robolang.python.pybricks

import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonPlace
import robotran.robolang.python.writer.PythonUses
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Statement

/** The main program as a task: it waits while a behaviour acts. */
internal class MainTaskPlace(private val uses: PythonUses) : PythonPlace {
    override fun linesBefore(statement: Statement): List<String> = myTurn(statement, uses)
}

/**
 * A routine.
 *
 * @property uses of a routine that only the main program calls, in a program with tasks; otherwise null.
 */
internal class RoutinePlace(override val result: ValueType?, private val uses: PythonUses?) : PythonPlace {
    override fun linesBefore(statement: Statement): List<String> =
        if (uses == null) emptyList() else myTurn(statement, uses)
}

/** The lines of behaviour [number]; if a later one can take over, they end then. */
internal class BehaviourPlace(private val number: Int, private val isLast: Boolean, private val first: Statement?) :
    PythonPlace {
    override fun linesBefore(statement: Statement): List<String> =
        if (isLast || statement === first || !acts(statement)) {
            emptyList()
        } else {
            listOf("if acting != $number:", "    return")
        }
}

private fun myTurn(statement: Statement, uses: PythonUses): List<String> =
    if (acts(statement)) listOf("await ${uses.use(PybricksHelper.MY_TURN)}()") else emptyList()

private fun acts(statement: Statement): Boolean = statement is Command || statement is Statement.Halt
