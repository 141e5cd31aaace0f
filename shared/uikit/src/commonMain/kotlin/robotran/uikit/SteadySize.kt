package robotran.uikit

import androidx.compose.foundation.layout.Box
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.semantics.clearAndSetSemantics

/**
 * Shows one of several contents with the size of the largest, so that nothing moves when they change.
 *
 * @param all the other possible contents besides [shown]; they must not be clickable.
 */
@Composable
fun <T> SteadySize(
    shown: T,
    all: Collection<T>,
    modifier: Modifier = Modifier,
    alignment: Alignment = Alignment.Center,
    content: @Composable (T) -> Unit,
) {
    Box(modifier, alignment, propagateMinConstraints = false) {
        for (one in all.toSet() - shown) {
            key(one) { Box(Modifier.drawWithContent { }.clearAndSetSemantics { }) { content(one) } }
        }
        content(shown)
    }
}
