package robotran.robolang.python.pybricks

import robotran.robolang.python.writer.PythonExpressions
import robotran.robolang.python.writer.PythonNotes
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.allStatements
import robotran.robolang.syntax.withParts

/** Tells where a loop of many short moves would crawl: a hub speeds up and slows down in each. */
internal class NotesOnLoops(private val notes: PythonNotes, private val expressions: PythonExpressions) {
    fun tell(tree: SyntaxTree) {
        for (statement in allStatements(tree)) {
            val condition = when (statement) {
                is Statement.RepeatUntil -> statement.condition
                is Statement.RepeatWhile -> statement.condition
                else -> continue
            }
            val short = statement.body.firstOrNull { isShort(it) } ?: continue
            val senses = withParts(condition).any { it is Expression.Sense }
            if (senses) notes.tell(short.range, notes.messages.shortMoves())
        }
    }

    private fun isShort(statement: Statement): Boolean = when (statement) {
        is Command.Move -> isBelow(statement.distance, SHORT_DISTANCE)
        is Command.Turn -> isBelow(statement.angle, SHORT_ANGLE)
        else -> false
    }

    private fun isBelow(value: Expression?, limit: Float): Boolean {
        val known = value?.let { expressions.known(it) }?.decimal ?: return false
        return known <= limit && known >= -limit
    }

    private companion object {
        /** In centimetres. */
        const val SHORT_DISTANCE = 2f

        /** In degrees. */
        const val SHORT_ANGLE = 5f
    }
}
