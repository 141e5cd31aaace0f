@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.embedding

/** What the page shows in a frame of another page. */
internal enum class Embedding {
    /** The page is not embedded. */
    NONE,

    /** `?embed`: only world and brick. */
    SHEET,

    /** `?embed=assignment`: the whole workshop, which reports to the page around it. */
    ASSIGNMENT,
    ;

    companion object {
        /** What the page's URL asks for. */
        fun asked(): Embedding = when (embedParameter()) {
            null -> NONE
            "assignment" -> ASSIGNMENT
            else -> SHEET
        }
    }
}

private fun embedParameter(): String? = js("new URLSearchParams(location.search).get('embed')")
