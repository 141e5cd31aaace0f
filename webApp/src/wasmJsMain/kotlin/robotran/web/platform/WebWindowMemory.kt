@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import robotran.workshop.platform.WindowMemory

/**
 * Restores a tab's state after a reload. The project's ID is in `sessionStorage`. A duplicated tab gets a copy of it,
 * so claims decide which tab owns the project. `localStorage` holds whether the page was left or crashed, and unsaved
 * changes: nothing else can be written while a page unloads.
 */
internal object WebWindowMemory : WindowMemory {
    init {
        noteEnds()
    }

    override var projectId: String?
        get() = tabsWork()
        set(value) = keepTabsWork(value.orEmpty())

    override fun hasEnded(id: String): Boolean = takeEnd(id)

    override fun leave(id: String, text: String?) = saveHandover(id, text)

    override fun left(id: String): String? = leftOf(id)

    override fun leftIds(): List<String> = idsOfLeft().split('\n').filter { it.isNotEmpty() }
}

/** The browser may discard a hidden page without notice, and nothing is lost then. Storage may be blocked. */
private fun noteEnds(): Unit = js(
    """{
        const note = (isGoing) => {
            try {
                const id = sessionStorage.getItem('robotran-work');
                if (!id) return;
                if (isGoing) localStorage.setItem('robotran-ended-' + id, '1'); else localStorage.removeItem('robotran-ended-' + id);
            } catch { }
        };
        document.addEventListener('visibilitychange', () => note(document.visibilityState === 'hidden'));
        addEventListener('pagehide', () => note(true));
        addEventListener('pageshow', (event) => { if (event.persisted) note(false); });
    }""",
)

private fun tabsWork(): String? =
    js("(() => { try { return sessionStorage.getItem('robotran-work'); } catch { return null; } })()")

private fun keepTabsWork(id: String): Unit = js(
    """{
        try {
            sessionStorage.setItem('robotran-work', id);
            if (id) localStorage.removeItem('robotran-ended-' + id);
        } catch { }
    }""",
)

private fun saveHandover(id: String, text: String?): Unit = js(
    """{
        try {
            if (text == null) localStorage.removeItem('robotran-left-' + id); else localStorage.setItem('robotran-left-' + id, text);
        } catch { }
    }""",
)

private fun leftOf(id: String): String? =
    js("(() => { try { return localStorage.getItem('robotran-left-' + id); } catch { return null; } })()")

private fun idsOfLeft(): String = js(
    """(() => {
        const start = 'robotran-left-';
        try {
            return Object.keys(localStorage).filter((key) => key.startsWith(start)).map((key) => key.slice(start.length)).join('\n');
        } catch { return ''; }
    })()""",
)

private fun takeEnd(id: String): Boolean = js(
    """(() => {
        try {
            const hasEnded = localStorage.getItem('robotran-ended-' + id) !== null;
            localStorage.removeItem('robotran-ended-' + id);
            return hasEnded;
        } catch { return false; }
    })()""",
)
