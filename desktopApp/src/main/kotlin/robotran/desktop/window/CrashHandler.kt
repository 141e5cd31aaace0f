package robotran.desktop.window

import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.window.WindowExceptionHandler
import androidx.compose.ui.window.WindowExceptionHandlerFactory
import robotran.console.ProcessConsole
import robotran.console.tellUnexpected
import robotran.workshop.platform.appLanguage
import javax.swing.JOptionPane

/**
 * Handles exceptions in drawing and events: saves the project, shows a message, and redraws the window. After repeated
 * failures it closes the window.
 */
@OptIn(ExperimentalComposeUiApi::class)
internal class CrashHandler(private val open: OpenWindow, private val giveUp: () -> Unit) :
    WindowExceptionHandlerFactory {
    private val times = ArrayDeque<Long>()

    override fun exceptionHandler(window: java.awt.Window) = WindowExceptionHandler { problem -> handle(problem) }

    private fun handle(problem: Throwable) {
        ProcessConsole.tellUnexpected(problem, appLanguage(null))
        val now = System.nanoTime()
        times.addLast(now)
        while (times.size > MAX_TIMES) times.removeFirst()
        open.saveAfterError()
        if (open.workshop == null || (times.size == MAX_TIMES && now - times.first() < SOON_NANOSECONDS)) {
            val words = "Robotran cannot go on: $problem\nYour work is kept."
            JOptionPane.showMessageDialog(null, words, "Robotran", JOptionPane.ERROR_MESSAGE)
            return giveUp()
        }
        open.attempt++
    }

    private companion object {
        const val MAX_TIMES = 3
        const val SOON_NANOSECONDS = 10_000_000_000L
    }
}
