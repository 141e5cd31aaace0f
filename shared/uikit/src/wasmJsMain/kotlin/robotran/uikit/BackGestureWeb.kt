package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.SideEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue

/** The handlers of the browser's Back, for the page, which manages the browser's history. */
object BackHandlers {
    private val handlers = mutableStateListOf<BackHandler>()

    /** How many times in a row Back can close something; observable as state. */
    val count: Int get() = handlers.sumOf { it.count }

    /** Calls the handler added last, if any. */
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
actual fun BackGesture(count: Int, onBack: () -> Unit) {
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
