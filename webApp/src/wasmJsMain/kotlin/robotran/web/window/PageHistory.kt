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

    /** The entry that this has asked the browser for, which may come late; null once the browser has gone. */
    private var asked: Int? = null
    private var waits = 0
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
            // A link was opened in this page: its entry is above all others. What this has asked for still comes.
            here = before + 1
            numberEntry(here)
        } else {
            here = number
            if (asked == null && here < before && closable > 0) closeTop()
            asked = null
        }
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
        if (asked != null && waits++ < MAX_WAITS) {
            settleSoon()
            return
        }
        if (closable > here) asked = null
        repeat(closable - here) { pushEntry(++here) }
        // An entry that is asked for again while the first wish is still on its way may lead out of the page.
        if (closable < here && asked == null) {
            asked = closable
            waits = 0
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
