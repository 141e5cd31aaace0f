@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import kotlinx.browser.window

/**
 * The browser's Back, which closes what lies over the rest and leaves the page only where nothing does.
 *
 * As much as Back can close, so many entries lie in the browser's history above the one that the page was opened with,
 * each with its number. What is closed in another way takes its entries out of the way again, so none is ever there for
 * nothing; Forward, which brings nothing back, too. Entries are made when something opens, which is while a person
 * presses something: browsers skip those that come by themselves.
 *
 * @param closeTop closes what is on top.
 */
internal class PageHistory(private val closeTop: () -> Unit) {
    private var closable = 0
    private var here = numberOfEntry().coerceAtLeast(0)
    private var goes = 0
    private var timer = 0

    init {
        if (numberOfEntry() < 0) numberEntry(here)
        onEntryChanged(::arrive)
    }

    /** Says how many times in a row Back finds something to close. */
    fun show(count: Int) {
        closable = count
        settleSoon()
    }

    private fun arrive() {
        val number = numberOfEntry()
        val before = here
        if (number < 0) {
            // A link was opened in this page: its entry lies above all that is there.
            here = before + 1
            numberEntry(here)
        } else {
            here = number
            if (goes == 0 && here < before && closable > 0) closeTop()
        }
        goes = 0
        settleSoon()
    }

    /** Not before a menu that has been chosen from is gone and the dialog that it opens is there. */
    private fun settleSoon() {
        window.clearTimeout(timer)
        timer = window.setTimeout({
            settle()
            null
        }, PAUSE)
    }

    private fun settle() {
        // A way that was never gone is not waited for without end.
        if (goes in 1..MAX_WAITS) {
            goes++
            settleSoon()
            return
        }
        goes = 0
        repeat(closable - here) { pushEntry(++here) }
        if (closable < here) {
            goes = 1
            go(closable - here)
            settleSoon()
        }
    }

    private companion object {
        /** Milliseconds. */
        const val PAUSE = 120
        const val MAX_WAITS = 10
    }
}

private fun numberOfEntry(): Int = js("history.state?.robotran ?? -1")

private fun numberEntry(number: Int): Unit = js("history.replaceState({ robotran: number }, '')")

private fun pushEntry(number: Int): Unit = js("history.pushState({ robotran: number }, '')")

private fun go(steps: Int): Unit = js("history.go(steps)")

private fun onEntryChanged(tell: () -> Unit): Unit = js("addEventListener('popstate', () => tell())")
