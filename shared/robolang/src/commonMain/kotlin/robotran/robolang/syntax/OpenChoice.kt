package robotran.robolang.syntax

import robotran.language.source.SourceRange

/** An `if` that is being parsed, branch by branch. */
internal class OpenChoice(private var range: SourceRange, condition: Expression) {
    private var condition: Expression? = condition
    private val branches = mutableListOf<Branch>()

    /** Whether its `else` was read. */
    val isAtElse: Boolean get() = condition == null

    /**
     * Ends the current branch with the statements [body]; the next one begins at [nextRange], without a condition if it
     * is the `else`.
     */
    fun next(body: List<Statement>, nextRange: SourceRange, nextCondition: Expression?) {
        condition?.let { branches += Branch(range, it, body) }
        range = nextRange
        condition = nextCondition
    }

    fun complete(block: Block): Statement {
        val last = condition
        val otherwise = if (last == null) ElseBranch(range, block.body) else null
        if (last != null) branches += Branch(range, last, block.body)
        return Statement.If(block.range, block.endRange, branches, otherwise)
    }
}
