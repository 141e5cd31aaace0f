package robotran.ui.learning

import androidx.compose.foundation.lazy.grid.LazyGridState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.runtime.withFrameNanos
import androidx.compose.ui.focus.FocusRequester
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import robotran.learning.Lessons
import robotran.learning.Strand
import robotran.uikit.*

/** Goes to the head of a strand among the [cards], and with the keyboard's focus to its first lesson. */
internal class StrandJump(
    private val cards: LazyGridState,
    private val scope: CoroutineScope,
    private val isStill: Boolean,
) {
    private val firsts = Lessons.strands.associate { it.name to FocusRequester() }

    fun firstOf(strand: Strand): FocusRequester = firsts.getValue(strand.name)

    fun to(strand: Strand) {
        scope.launch {
            val head = headOf(strand.name)
            if (isStill) cards.scrollToItem(head) else cards.animateScrollToItem(head)
            // The card is composed only during layout.
            withFrameNanos { }
            if (cards.layoutInfo.visibleItemsInfo.any { it.key == strand.lessons.first().name }) {
                firstOf(strand).requestFocus()
            }
        }
    }
}

@Composable
internal fun rememberStrandJump(cards: LazyGridState): StrandJump {
    val scope = rememberCoroutineScope()
    val isStill = LocalLessMotion.current
    return remember(cards, isStill) { StrandJump(cards, scope, isStill) }
}
