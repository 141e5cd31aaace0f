package robotran.robolang.syntax

import robotran.language.source.SourceRange

/**
 * A statement: a [Command], or one of those below, which hold data or decide what runs next. A block's [range] is its
 * first line.
 */
internal sealed interface Statement {
    val range: SourceRange

    /** A statement with a body; [endRange] is its `end`, zero-width if missing. */
    sealed interface Block : Statement {
        val endRange: SourceRange
    }

    /** A loop. */
    sealed interface Loop : Block {
        val body: List<Statement>
    }

    /** `repeat N times` .. `end`. */
    data class Repeat(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val count: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `repeat forever` .. `end`. */
    data class RepeatForever(
        override val range: SourceRange,
        override val endRange: SourceRange,
        override val body: List<Statement>,
    ) : Loop

    /** `repeat while C` .. `end`; checks before each round. */
    data class RepeatWhile(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val condition: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `repeat until C` .. `end`; checks before each round, like `repeat while not C`. */
    data class RepeatUntil(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val condition: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `for i from A to B step S` .. `end`; includes B. A null [step] means 1. */
    data class ForRange(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val variable: Name,
        val from: Expression,
        val to: Expression,
        val step: Expression?,
        override val body: List<Statement>,
    ) : Loop

    /** `for each x in list` .. `end`. */
    data class ForEach(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val variable: Name,
        val list: Expression,
        override val body: List<Statement>,
    ) : Loop

    /** `break`. */
    data class Break(override val range: SourceRange) : Statement

    /** `continue`. */
    data class Continue(override val range: SourceRange) : Statement

    /**
     * `if C` .. `else if C` .. `else` .. `end`; [branches] has at least one element; the first is that of the first
     * line.
     */
    data class If(
        override val range: SourceRange,
        override val endRange: SourceRange,
        val branches: List<Branch>,
        val otherwise: ElseBranch?,
    ) : Block

    /** `var x = E` and `const k = E`. */
    data class Declare(
        override val range: SourceRange,
        val name: Name,
        val value: Expression,
        val isConstant: Boolean,
    ) : Statement

    /** `x = E` and `list[i] = E`. */
    data class Assign(override val range: SourceRange, val target: AssignTarget, val value: Expression) : Statement

    /** `p(1, 2)`. */
    data class Call(override val range: SourceRange, val name: Name, val arguments: List<Expression>) : Statement

    /** `return E` in a function, `return` in a procedure. */
    data class Return(override val range: SourceRange, val value: Expression?) : Statement

    /** `halt`. */
    data class Halt(override val range: SourceRange) : Statement
}

/** An `if C` or `else if C` with its body. */
internal data class Branch(val range: SourceRange, val condition: Expression, val body: List<Statement>)

/** An `else` with its body. */
internal data class ElseBranch(val range: SourceRange, val body: List<Statement>)
