package robotran.workshop.platform

/** The state that a window restores after a reload, on platforms with windows such as browser tabs. */
interface WindowMemory {
    /** The ID of the last project in this window; empty if it was not stored, null if the window is new. */
    var projectId: String?

    /**
     * Whether the last window of the project [id] was closed or reloaded and did not crash. Called once when the
     * project is restored.
     */
    fun hasEnded(id: String): Boolean

    /**
     * Stores [text] synchronously, the changes of project [id] that may be lost when this window ends; null once they
     * are autosaved.
     */
    fun leave(id: String, text: String?)

    /** The unsaved changes of the project [id]; null if there are none. */
    fun left(id: String): String?

    /** The IDs of all projects with unsaved changes, from any window. */
    fun leftIds(): List<String>
}

/** A platform where every window is new. */
object NoWindowMemory : WindowMemory {
    override var projectId: String?
        get() = null
        set(_) = Unit

    override fun hasEnded(id: String): Boolean = false

    override fun leave(id: String, text: String?) = Unit

    override fun left(id: String): String? = null

    override fun leftIds(): List<String> = emptyList()
}
