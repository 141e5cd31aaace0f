@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.device

/** The devices of the browser that were seen on this page, which have no name of their own. */
internal class SeenDevices {
    private val all = mutableListOf<JsAny>()

    /** What [named] finds [device] by: its place in the list. */
    fun idOf(device: JsAny): String {
        val known = all.indexOfFirst { isSame(it, device) }
        if (known >= 0) return known.toString()
        all += device
        return all.lastIndex.toString()
    }

    fun named(id: String): JsAny? = id.toIntOrNull()?.let { all.getOrNull(it) }
}

private fun isSame(one: JsAny, other: JsAny): Boolean = js("one === other")
