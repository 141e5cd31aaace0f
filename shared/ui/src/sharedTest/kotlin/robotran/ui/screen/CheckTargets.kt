package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import kotlin.test.assertTrue

/** Fails unless each of [tags] has the min touch size and is fully visible. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.checkTargets(vararg tags: String) {
    val screen = onRoot().fetchSemanticsNode().boundsInRoot
    for (tag in tags) {
        val place = onNodeWithTag(tag).fetchSemanticsNode().touchBoundsInRoot
        assertTrue(place.width >= 48f && place.height >= 48f, "$tag is only ${place.size}")
        val isInside = place.left >= 0f && place.right <= screen.right + 0.5f && place.bottom <= screen.bottom + 0.5f
        assertTrue(isInside, "$tag is at $place of $screen")
    }
}
