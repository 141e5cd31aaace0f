package robotran.ui.screen

import javax.swing.SwingUtilities

/**
 * Runs [work] on the event thread. A screen dispatches its work there and may block forever on another thread, and
 * Compose tells it there of each change of state: a test on a thread of its own would race with its own screen.
 */
internal fun <T> onEventThread(work: () -> T): T {
    if (SwingUtilities.isEventDispatchThread()) return work()
    var result: Result<T>? = null
    SwingUtilities.invokeAndWait { result = runCatching(work) }
    return checkNotNull(result).getOrThrow()
}
