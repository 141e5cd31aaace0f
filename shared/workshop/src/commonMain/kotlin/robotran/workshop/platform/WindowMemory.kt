package robotran.workshop.platform

/** What a window knows of itself after it was loaded anew, where windows are, such as the tabs of a browser. */
interface WindowMemory {
    /** The id of the work that this window showed last; empty if that was not kept, null if the window is new. */
    var workId: String?

    /**
     * Whether the window that showed the work [id] last was left or loaded anew, rather than having crashed; asked
     * once, when that comes back.
     */
    fun hasEnded(id: String): Boolean

    /**
     * Remembers at once [text], what may not have been kept of the work [id] when this window ends; null once it was
     * kept.
     */
    fun leave(id: String, text: String?)

    /** What was left of the work [id], null if nothing was. */
    fun left(id: String): String?

    /** The ids of all works of which something was left, by this window or another one. */
    fun leftIds(): List<String>
}

/** Where every window is new. */
object NoWindowMemory : WindowMemory {
    override var workId: String?
        get() = null
        set(_) = Unit

    override fun hasEnded(id: String): Boolean = false

    override fun leave(id: String, text: String?) = Unit

    override fun left(id: String): String? = null

    override fun leftIds(): List<String> = emptyList()
}
