package robotran.robolang.check

import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement

/**
 * Counts the variables that a brick needs: fields for globals, and the local variables of each method, including loop
 * counters.
 */
internal class VariableBudget(private val context: CheckContext) {
    private var fields = 0
    private val locals = mutableMapOf<SourceRange?, Int>()
    private val full = mutableSetOf<SourceRange?>()
    private var counters = 0

    /** Adds a global variable declared at [place]. */
    fun field(place: SourceRange) {
        fields++
        if (fields == RobolangLimits.VARIABLES + 1) report(place)
    }

    /** Adds a local variable or parameter of [owner] declared at [place]. */
    fun local(owner: Routine?, place: SourceRange) {
        locals[owner?.range] = (locals[owner?.range] ?: argumentsOf(owner)) + 1
        look(owner, place)
    }

    /** Visits a statement of [owner] by [body]; a loop's counters are in use until its end. */
    fun around(statement: Statement, owner: Routine?, body: () -> Unit) {
        val own = when (statement) {
            is Statement.Repeat -> 1
            is Statement.ForRange, is Statement.ForEach -> 2

            is Statement.RepeatForever, is Statement.RepeatWhile, is Statement.RepeatUntil, is Statement.If,
            is Statement.Break, is Statement.Continue, is Statement.Declare, is Statement.Assign, is Statement.Call,
            is Statement.Return, is Statement.Halt, is Command,
            -> 0
        }
        counters += own
        if (own > 0) look(owner, statement.range)
        body()
        counters -= own
    }

    private fun look(owner: Routine?, place: SourceRange) {
        val used = (locals[owner?.range] ?: argumentsOf(owner)) + counters
        if (used > RobolangLimits.VARIABLES && full.add(owner?.range)) report(place)
    }

    /** Java's main method already has one variable, as has the action of a behaviour. */
    private fun argumentsOf(owner: Routine?): Int = if (owner == null) 1 else 0

    private fun report(place: SourceRange) = context.report(
        DiagnosticCode.TOO_MANY_VARIABLES,
        place,
        context.messages.tooManyVariables(RobolangLimits.VARIABLES),
    )
}
