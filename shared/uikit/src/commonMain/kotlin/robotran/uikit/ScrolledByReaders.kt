package robotran.uikit

import androidx.compose.foundation.gestures.ScrollableState
import androidx.compose.foundation.gestures.scrollBy
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.semantics
import kotlinx.coroutines.launch

/**
 * Actions by which a screen reader scrolls a lazy list. It knows only elements that are visible, and a web page has no
 * gesture for it that scrolls.
 *
 * @param height the height of the list in pixels.
 */
@Composable
fun Modifier.scrolledByReaders(list: ScrollableState, height: () -> Int): Modifier {
    val coroutines = rememberCoroutineScope()
    val further = KitTexts.listFurther(spoken)
    val back = KitTexts.listBack(spoken)
    val canGoOn by remember(list) { derivedStateOf { list.canScrollForward } }
    val canGoBack by remember(list) { derivedStateOf { list.canScrollBackward } }
    val by = { words: String, part: Float ->
        CustomAccessibilityAction(words) {
            coroutines.launch { list.scrollBy(height() * part) }
            true
        }
    }
    return semantics {
        customActions = listOfNotNull(
            by(further, MOST).takeIf { canGoOn },
            by(back, -MOST).takeIf { canGoBack },
        )
    }
}

/** The part of the visible elements that goes out of sight. */
private const val MOST = 0.8f
