@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.window

import kotlinx.browser.window

/**
 * The browser's Back button. It closes the topmost dialog or menu, and leaves the page only if nothing is open.
 *
 * The browser's history has one numbered entry for each thing that Back can close, above the page's first entry. If
 * something closes in another way, its entry is removed, also after Forward, which reopens nothing. Entries are added
 * on a user action, since browsers skip those added without one.
 *
 * @param closeTop closes the topmost dialog or menu.
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

    /** Sets how many times in a row Back can close something. */
    fun show(count: Int) {
        closable = count
        settleSoon()
    }

    private fun arrive() {
        val number = numberOfEntry()
        val before = here
        if (number < 0) {
            // A link was opened in this page: its entry is above all others.
            here = before + 1
            numberEntry(here)
        } else {
            here = number
            if (goes == 0 && here < before && closable > 0) closeTop()
        }
        goes = 0
        settleSoon()
    }

    /** Delayed, so that a menu can close and the dialog it opens can appear. */
    private fun settleSoon() {
        window.clearTimeout(timer)
        timer = window.setTimeout({
            settle()
            null
        }, PAUSE)
    }

    private fun settle() {
        // Do not wait forever for a navigation that never happens.
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
