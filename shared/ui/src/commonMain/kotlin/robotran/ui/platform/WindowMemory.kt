package robotran.ui.platform

/** What a window knows of itself after it was loaded anew, where windows are, such as the tabs of a browser. */
interface WindowMemory {
    /** The id of the work that this window showed last; empty if that was not kept, null if the window is new. */
    var workId: String?

    /** Whether the window that showed the work [id] last was left or loaded anew, rather than having crashed; asked once, when that comes back. */
    fun hasEnded(id: String): Boolean
}

/** Where every window is new. */
object NoWindowMemory : WindowMemory {
    override var workId: String?
        get() = null
        set(_) = Unit

    override fun hasEnded(id: String): Boolean = false
}
