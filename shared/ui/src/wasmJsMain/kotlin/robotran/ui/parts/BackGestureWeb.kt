package robotran.ui.parts

import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue

/** What the browser's Back would close, for the page, which has the browser's history. */
object BackHandlers {
    private val handlers = mutableStateListOf<BackHandler>()

    /** How many times in a row Back finds something to close; may be observed as a state. */
    val count: Int get() = handlers.sumOf { it.count }

    /** Closes what was opened last, if there is something. */
    fun goBack() {
        handlers.lastOrNull { it.count > 0 }?.onBack?.invoke()
    }

    internal fun add(handler: BackHandler) {
        handlers += handler
    }

    internal fun remove(handler: BackHandler) {
        handlers -= handler
    }
}

internal class BackHandler {
    var count by mutableIntStateOf(0)
    var onBack: () -> Unit = {}
}

@Composable
internal actual fun BackGesture(count: Int, onBack: () -> Unit) {
    val handler = remember { BackHandler() }
    SideEffect {
        handler.count = count
        handler.onBack = onBack
    }
    DisposableEffect(handler) {
        BackHandlers.add(handler)
        onDispose { BackHandlers.remove(handler) }
    }
}
