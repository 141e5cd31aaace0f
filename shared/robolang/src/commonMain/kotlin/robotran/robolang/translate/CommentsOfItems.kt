package robotran.robolang.translate

import robotran.language.source.SourceRange
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.SyntaxTree
import robotran.robolang.syntax.Token

/**
 * Assigns each comment to a part of the program: the comments above, beside and inside it, since Java has another
 * order.
 */
internal class CommentsOfItems(tree: SyntaxTree) {
    private val firstLines: List<Int>
    private val comments: Map<Int, List<Token>>

    /** The comments at the top, about the whole program; they end at a blank line. */
    val heading: List<Token>

    /** The comments after everything else. */
    val closing: List<Token> get() = comments[BEHIND].orEmpty()

    init {
        val items = items(tree).sortedBy { it.first }
        firstLines = items.map { it.first }
        heading = headingOf(tree.comments, firstLines.firstOrNull())
        comments = tree.comments.drop(heading.size).groupBy { comment ->
            items.firstOrNull { comment.range.line <= it.last }?.first ?: BEHIND
        }
    }

    /** The comments of the part that begins at [range]. */
    fun of(range: SourceRange): List<Token> = comments[range.line].orEmpty()

    private fun items(tree: SyntaxTree): List<IntRange> = tree.routines.map { lines(it.range, it.endRange) } +
        tree.behaviours.map { lines(it.range, it.endRange) } +
        tree.statements.map { lines(it.range, (it as? Statement.Block)?.endRange ?: it.range) } +
        listOfNotNull(tree.robot).map { lines(it.range, it.endRange) }

    private fun lines(start: SourceRange, end: SourceRange): IntRange = start.line..end.line

    private fun headingOf(all: List<Token>, firstItem: Int?): List<Token> {
        val first = all.firstOrNull() ?: return emptyList()
        val together = all.withIndex().takeWhile { (index, comment) ->
            comment.range.line == first.range.line + index
        }.map { it.value }
        val isAlone = firstItem == null || together.last().range.line < firstItem - 1
        return if (isAlone) together else emptyList()
    }

    private companion object {
        const val BEHIND = -1
    }
}
