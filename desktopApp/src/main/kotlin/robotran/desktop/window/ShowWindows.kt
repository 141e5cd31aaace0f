package robotran.desktop.window

import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateListOf
import androidx.compose.runtime.remember
import androidx.compose.ui.window.application
import kotlinx.coroutines.runBlocking
import robotran.console.ProcessConsole
import robotran.console.tellUnexpected
import robotran.desktop.platform.dataFolder
import robotran.desktop.platform.openedFile
import robotran.ui.platform.FolderKeyValueStore
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.appLanguage
import java.awt.Desktop
import kotlin.coroutines.EmptyCoroutineContext

/** Shows a window with [arrival], or with the last project if null, and returns when all windows are closed. */
internal fun showWindows(arrival: OpenRequest?) {
    val store = FolderKeyValueStore(dataFolder(), EmptyCoroutineContext)
    val place = runBlocking { store.read(PLACE) }?.let { WindowBounds.of(it) }
    val windows = mutableStateListOf(OpenWindow(store, arrival, restoresLastProject = true))
    Thread.setDefaultUncaughtExceptionHandler { _, problem ->
        ProcessConsole.tellUnexpected(problem, appLanguage(null))
        windows.toList().forEach(OpenWindow::saveAfterError)
    }
    onFilesOpened { windows.firstOrNull()?.bring(it) }
    application(exitProcessOnExit = false) {
        for (open in windows) {
            key(open) {
                val state = remember { windowStateFor(place.takeIf { open === windows.first() }) }
                AppWindow(
                    open,
                    state,
                    openAnother = { windows += OpenWindow(store, arrival = null, restoresLastProject = false) },
                    close = {
                        windows -= open
                        if (windows.isEmpty()) exitApplication()
                    },
                    quit = { windows.toList().forEach { it.requestClose() } },
                )
            }
        }
    }
}

/** macOS passes files to the running app; other systems start a new process. */
private fun onFilesOpened(bring: (OpenRequest) -> Unit) {
    if (!Desktop.isDesktopSupported() || !Desktop.getDesktop().isSupported(Desktop.Action.APP_OPEN_FILE)) return
    Desktop.getDesktop().setOpenFileHandler { event ->
        val files = event.files.mapNotNull { file -> openedFile(file.toPath()) { bring(OpenRequest.Unreadable(it)) } }
        if (files.isNotEmpty()) bring(OpenRequest.OfFiles(files))
    }
}
