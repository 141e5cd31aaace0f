package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.unit.toSize
import robotran.ui.program.tags.ProgramTags

/** Touches [tag] and lets the screen follow. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.touch(tag: String) {
    onNodeWithTag(tag).performClick()
    pass(200)
}

/** The same for something that may have to be scrolled to. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.scrollAndTouch(tag: String) {
    scrollTo(tag)
    touch(tag)
}

/** Scrolls what is around [tag] until it is in sight. `performScrollTo` waits for a clock that stands still here. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.scrollTo(tag: String) {
    repeat(MAX_SCROLLS) {
        val node = onAllNodesWithTag(tag).fetchSemanticsNodes().firstOrNull()
        // What a lazy list has not composed yet is further down.
        val lists = listOf(ProgramTags.PALETTE_BLOCKS, ProgramTags.BLOCKS).flatMap {
            onAllNodesWithTag(it).fetchSemanticsNodes()
        }
        val start = node?.parent ?: checkNotNull(lists.firstOrNull()) { "there is no $tag" }
        val pane =
            generateSequence(start) { it.parent }.firstOrNull { SemanticsActions.ScrollBy in it.config } ?: return
        val view = pane.boundsInRoot
        val (x, y) = if (node == null) {
            0f to view.height / 2
        } else {
            val place = Rect(node.positionInRoot, node.size.toSize())
            beyond(place.left, place.right, view.left, view.right) to
                beyond(place.top, place.bottom, view.top, view.bottom)
        }
        if (x == 0f && y == 0f) return
        runOnUiThread { pane.config[SemanticsActions.ScrollBy].action?.invoke(x, y) }
        pass(500)
    }
}

/** How far something from [start] to [end] is outside of the view from [from] to [to]; 0 if it is inside. */
private fun beyond(start: Float, end: Float, from: Float, to: Float): Float = when {
    start < from -> start - from
    end > to -> minOf(end - to, start - from)
    else -> 0f
}

private const val MAX_SCROLLS = 30
