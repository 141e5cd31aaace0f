package robotran.ui.screen

import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import robotran.uikit.*
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The positions of all elements with a unique tag. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.placesByTag(): Map<String, Rect> =
    onAllNodes(SemanticsMatcher.keyIsDefined(SemanticsProperties.TestTag)).fetchSemanticsNodes()
        .groupBy { it.config[SemanticsProperties.TestTag] }
        .filterValues { it.size == 1 }
        .mapValues { (_, nodes) -> nodes.single().boundsInRoot }

/** Fails if any of [tags] has moved since [before]. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.assertUnmoved(before: Map<String, Rect>, tags: Collection<String>, described: String) {
    val now = placesByTag()
    assertEquals(
        tags.associateWith {
            checkNotNull(before[it]) { "$described: there was no $it" }
        },
        tags.associateWith { now[it] },
        described,
    )
}

@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.isThere(tag: String): Boolean = onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

/** Fails unless [tag] is fully visible; returns its position. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.assertWhole(tag: String, described: String): Rect {
    val node = onNodeWithTag(tag).fetchSemanticsNode()
    assertEquals(
        node.size.width.toFloat(),
        node.boundsInRoot.width,
        0.5f,
        "$described: $tag is cut at ${node.boundsInRoot}",
    )
    assertEquals(
        node.size.height.toFloat(),
        node.boundsInRoot.height,
        0.5f,
        "$described: $tag is cut at ${node.boundsInRoot}",
    )
    return node.boundsInRoot
}

/**
 * Whether an arrow is drawn in the middle of the lower or, if [isRight], the right edge of [tag], which indicates more
 * content.
 */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.saysThereIsMore(tag: String, isRight: Boolean = false): Boolean {
    val image = pixelsOf(tag)
    val across = (if (isRight) image.height else image.width) / 2
    val end = if (isRight) image.width else image.height

    fun at(fromEdge: Int, side: Int): Color =
        if (isRight) image[end - 1 - fromEdge, across + side] else image[across + side, end - 1 - fromEdge]
    val ground = at(1, 0)
    assertTrue(end > 2 * EDGE, "$tag is only $end long")
    return (0..<EDGE).any { depth -> (-EDGE..EDGE).any { at(depth, it) != ground } }
}

/** Scrolls the content of [tag] to its end or its start; a stopped clock does not delay tests. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.scroll(tag: String, toEnd: Boolean) {
    val far = if (toEnd) FAR else -FAR
    onNodeWithTag(tag).fetchSemanticsNode().config[SemanticsActions.ScrollBy].action?.invoke(far, far)
    pass(800)
}

private const val FAR = 10_000f

/** The size of an arrow at the edge, less than the free space there. */
private const val EDGE = 8
