package robotran.ui.screen

import javax.swing.SwingUtilities

/**
 * Does [work] on the event thread: what a screen waits for comes on that thread, so a screen that is drawn on another
 * one may wait for it for ever.
 */
internal fun <T> onEventThread(work: () -> T): T {
    var result: Result<T>? = null
    SwingUtilities.invokeAndWait { result = runCatching(work) }
    return checkNotNull(result).getOrThrow()
}
