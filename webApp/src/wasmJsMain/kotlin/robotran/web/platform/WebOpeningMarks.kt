@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import robotran.workshop.platform.OpeningMarks

/**
 * Marks in `localStorage`, which is written at once. A page that is closed, reloaded or hidden was alive, so it takes
 * its marks away then, whatever the app does.
 */
internal object WebOpeningMarks : OpeningMarks {
    private val page = pageMarks()

    override fun put(name: String, time: Long) = page.put(name, time.toDouble())

    override fun remove(name: String) = page.remove(name)

    override fun timeOf(name: String): Long? = page.timeOf(name).takeIf { it >= 0 }?.toLong()
}

private external interface PageMarks : JsAny {
    fun put(name: String, time: Double)

    fun remove(name: String)

    fun timeOf(name: String): Double
}

private fun pageMarks(): PageMarks = js(
    """(() => {
        const START = 'robotran-opening-';
        const own = new Set();
        const attempt = (work, otherwise) => { try { return work(); } catch { return otherwise; } };
        const remove = (name) => { own.delete(name); attempt(() => localStorage.removeItem(START + name)); };
        const removeAll = () => [...own].forEach(remove);
        addEventListener('pagehide', removeAll);
        document.addEventListener('visibilitychange', () => { if (document.visibilityState === 'hidden') removeAll(); });
        return {
            put: (name, time) => { own.add(name); attempt(() => localStorage.setItem(START + name, String(time))); },
            remove,
            timeOf: (name) => attempt(() => Number(localStorage.getItem(START + name) ?? -1), -1),
        };
    })()""",
)
