package robotran.desktop.window

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.key
import androidx.compose.runtime.remember
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.window.LocalWindowExceptionHandlerFactory
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.WindowState
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.ui.RobotranWindow
import robotran.ui.common.BrickIcon
import robotran.ui.desktop.WorkshopMenuBar
import robotran.ui.desktop.windowTitle
import java.awt.Dimension

/**
 * The window [open] with the platform's menu. Calls [close] when it may close, [openAnother] for a new window, and [quit]
 * to close all.
 */
@OptIn(ExperimentalComposeUiApi::class)
@Composable
internal fun AppWindow(
    open: OpenWindow,
    state: WindowState,
    openAnother: () -> Unit,
    close: () -> Unit,
    quit: () -> Unit,
) {
    val icon = remember { BrickIcon() }
    val rescue = remember { CrashHandler(open, close) }
    val requestClose: () -> Unit = { open.scope.launch { if (open.workshop?.closeDocument() != false) close() } }
    open.requestClose = requestClose
    DisposableEffect(Unit) { onDispose { open.close() } }
    SaveWindowBounds(open, state)
    CompositionLocalProvider(LocalWindowExceptionHandlerFactory provides rescue) {
        key(open.attempt) {
            Window(requestClose, state, title = windowTitle(open.workshop), icon = icon) {
                DisposableEffect(window) {
                    window.minimumSize = Dimension(MIN_WIDTH, MIN_HEIGHT)
                    open.frame = window
                    onDispose { open.frame = null }
                }
                open.workshop?.let { WorkshopMenuBar(it.state, it::handle, openAnother, requestClose, quit) }
                Box(Modifier.fillMaxSize().opensDroppedFiles(open::bring)) { RobotranWindow(open.workshop) }
            }
        }
    }
}

/** Saves the window's bounds for the next start once they stop changing. */
@Composable
private fun SaveWindowBounds(open: OpenWindow, state: WindowState) {
    LaunchedEffect(state) {
        snapshotFlow { WindowBounds.of(state) }.collectLatest { place ->
            delay(REST_MILLISECONDS)
            if (place != null && !state.isMinimized) {
                withContext(Dispatchers.IO) { open.platform.store.write(PLACE, place.toText()) }
            }
        }
    }
}

/** The key of the saved window bounds. */
internal const val PLACE = "window"
private const val REST_MILLISECONDS = 500L
