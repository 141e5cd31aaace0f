package robotran.robolang.python.writer

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.allExpressions
import robotran.robolang.syntax.allStatements

/** All lines of a program that give a variable, a parameter or the result of a function its value. */
internal class ValueSources(private val program: CheckedProgram) {
    private val routines = program.tree.routines.associateBy { it.name.key }
    private val found = HashMap<Symbol, MutableList<Expression?>>()
    private val ends = HashMap<Symbol, MutableList<Expression>>()

    init {
        collect()
    }

    /** The values that each symbol gets, of a loop the lowest ones; null for one that can be anything. */
    val values: Map<Symbol, List<Expression?>> get() = found

    /** Where the variables of loops end. */
    val endsOfLoops: Map<Symbol, List<Expression>> get() = ends

    private fun add(symbol: Symbol, value: Expression?) {
        found.getOrPut(symbol) { mutableListOf() } += value
    }

    private fun collect() {
        for (statement in allStatements(program.tree)) {
            when (statement) {
                is Statement.Declare -> add(program.symbolOf(statement.name), statement.value)

                is Statement.Assign -> (statement.target as? AssignTarget.Variable)?.let {
                    add(program.symbolOf(it.name), statement.value)
                }

                is Statement.ForRange -> {
                    val symbol = program.symbolOf(statement.variable)
                    val step = statement.step
                    val isUp = step == null || (step as? Expression.Number)?.value?.isNegative == false
                    add(symbol, statement.from)
                    if (!isUp) add(symbol, statement.to)
                    ends.getOrPut(symbol) { mutableListOf() } += statement.to
                }

                is Statement.ForEach -> {
                    val elements = (statement.list as? Expression.ListOf)?.elements ?: listOf(null)
                    elements.forEach { add(program.symbolOf(statement.variable), it) }
                }

                is Statement.Call -> addArguments(statement.name.key, statement.arguments)

                else -> Unit
            }
        }
        allExpressions(program.tree).filterIsInstance<Expression.Call>()
            .forEach { addArguments(it.name.key, it.arguments) }
        for (routine in program.tree.routines) {
            val symbol = program.symbolOf(routine.name)
            returnsIn(routine.body).forEach { add(symbol, it) }
        }
    }

    private fun addArguments(routine: String, arguments: List<Expression>) {
        routines[routine]?.parameters?.zip(arguments)?.forEach { (name, value) -> add(program.symbolOf(name), value) }
    }

    private fun returnsIn(statements: List<Statement>): List<Expression> =
        withInner(statements).mapNotNull { (it as? Statement.Return)?.value }
}
