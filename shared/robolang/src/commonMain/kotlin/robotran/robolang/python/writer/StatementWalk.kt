package robotran.robolang.python.writer

import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.bodies

/** [statements] with all that are inside them, in order. */
internal fun withInner(statements: List<Statement>): List<Statement> =
    statements.flatMap { listOf(it) + it.bodies.flatMap(::withInner) }
