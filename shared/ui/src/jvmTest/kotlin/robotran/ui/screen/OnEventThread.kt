package robotran.ui.screen

import javax.swing.SwingUtilities

/** Runs [work] on the event thread: a screen dispatches its work there and may block forever on another thread. */
internal fun <T> onEventThread(work: () -> T): T {
    var result: Result<T>? = null
    SwingUtilities.invokeAndWait { result = runCatching(work) }
    return checkNotNull(result).getOrThrow()
}
