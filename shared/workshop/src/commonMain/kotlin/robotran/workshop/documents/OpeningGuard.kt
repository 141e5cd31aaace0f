package robotran.workshop.documents

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.documents.FileStamp
import robotran.workshop.platform.OpenedFile
import robotran.workshop.platform.OpeningMarks
import robotran.workshop.platform.WallClock

/**
 * Marks what is being opened, until it is compiled and drawn. So whatever stops the app on its way, be it a compiler or
 * a picture, is known by its mark at the next start, and is not opened again without asking.
 *
 * An app that is closed or hidden meanwhile was alive, and removes the marks ([settled]).
 */
internal class OpeningGuard(private val marks: OpeningMarks, private val clock: WallClock) {
    private val names = mutableSetOf<String>()

    /** Whether something is marked. */
    var isOpening: Boolean by mutableStateOf(false)
        private set

    /** Counts what was opened, so that each waits for its own end. */
    var count: Int by mutableIntStateOf(0)
        private set

    /** Whether the saved project [id] stopped the app when it was opened last. Its claim says that no window has it. */
    fun hasStopped(id: String): Boolean = id !in names && marks.timeOf(id) != null

    /**
     * The same for a link or files, which two windows may open at the same time: a fresh mark may be that of another
     * window.
     */
    fun hasContentStopped(name: String): Boolean {
        val time = marks.timeOf(name) ?: return false
        return name !in names && clock.now - time !in 0..<FRESH
    }

    /** Marks [name], which is opened now. The app has come to this point, so whatever was marked before is opened. */
    fun begin(name: String) {
        settled()
        add(name)
        count++
    }

    /** Marks the open project [id] as well, if something is being opened; that is what it came from. */
    fun saved(id: String) {
        if (isOpening) add(id)
    }

    /** Marks the open project [id] unless it is marked; null does nothing. */
    fun again(id: String?) {
        if (id != null && !isOpening) begin(id)
    }

    /** Called when everything marked is opened, compiled and drawn, or when the app is left, which only a live one is. */
    fun settled() {
        names.forEach(marks::remove)
        names.clear()
        isOpening = false
    }

    private fun add(name: String) {
        marks.put(name, clock.now)
        names += name
        isOpening = true
    }

    companion object {
        /** Milliseconds. */
        private const val FRESH = 3_000L

        /** The list of projects with its pictures. */
        const val LIST = "list"

        fun nameOfLink(link: String): String = "link-${FileStamp.of(link).text}"

        fun nameOfFiles(files: List<OpenedFile>): String =
            "file-${FileStamp.of(files.joinToString { FileStamp.of(it.bytes).text }).text}"
    }
}
