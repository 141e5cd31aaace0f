package robotran.documents

/**
 * Which works are open in windows, so that they come back after the app has ended, in whatever way: a small text for
 * each, which outlives its window.
 */
class OpenProjects(private val store: KeyValueStore, private val shelf: ProjectRepository) {
    /** The work [id] is shown in a window. */
    suspend fun opened(id: String, now: Long): StoreResult = store.write(nameOf(id), "$RUNNING $now")

    /**
     * The window with the work [id] is closed or the app ends as it should; it comes back at the next start if
     * [comesBack].
     */
    suspend fun closed(id: String, now: Long, comesBack: Boolean): StoreResult =
        if (comesBack) store.write(nameOf(id), "$CLOSED $now") else store.remove(nameOf(id))

    /**
     * Claims the work that is to come back and reads it; null if none does. It is the one that was opened last of those
     * that no window has; the others do not come back by themselves, but are among all works. Works that cannot be read
     * are passed over and stay where they are.
     *
     * @param hasEnded whether the window with the work of this id has ended as it should, although it could not say so
     * here any more.
     */
    suspend fun takeBack(hasEnded: (id: String) -> Boolean = { false }): RestoredProject? {
        var back: RestoredProject? = null
        var cutShort = 0
        for (open in orphans()) {
            val claim = shelf.claim(open.id) ?: continue
            val wasCutShort = open.wasRunning && !hasEnded(open.id)
            val reading = if (back == null) shelf.read(open.id) else null
            if (reading is SavedProjectResult.Found) {
                back = RestoredProject(reading.work, claim, wasCutShort = wasCutShort || reading.isPartial)
            } else {
                claim.release()
                if (back != null && wasCutShort) cutShort++
                if (reading !is SavedProjectResult.Unusable) store.remove(nameOf(open.id))
            }
        }
        return back?.copy(others = cutShort)
    }

    /**
     * The work [id], which [claim] is on, as the one that comes back to the window it was in; null if it cannot be
     * read, or is gone.
     *
     * @param hasEnded whether that window has ended as it should, although it could not say so here any more.
     * @param left what that window has left of it elsewhere as it ended, see [leftText]; counts if it is newer than
     * what was kept.
     */
    suspend fun takeBack(id: String, claim: ProjectLock, hasEnded: Boolean, left: String? = null): RestoredProject? {
        val reading = shelf.read(id)
        if (reading is SavedProjectResult.Unusable) return null
        val kept = reading as? SavedProjectResult.Found
        val newer = left?.let {
            SavedProjectText.open(id, it) as? SavedProjectCopy.Whole
        }?.takeIf { it.isNewerThan(kept) }
        val found = newer?.read() as? SavedProjectResult.Found ?: kept ?: return null
        val wasRunning = store.read(nameOf(id))?.startsWith(RUNNING) ?: false
        val wasCutShort = kept?.isPartial == true || (wasRunning && !hasEnded)
        return RestoredProject(found.work, claim, wasCutShort, isKept = found === kept)
    }

    /**
     * Keeps [left], what a window that is gone has left elsewhere of the work [id], see [leftText], unless what is kept
     * is newer; the work, which must be claimed, comes back like any other then.
     *
     * @return whether all that can be used of it is kept now; otherwise it must stay where it is.
     */
    suspend fun keepLeft(id: String, left: String): Boolean {
        val reading = shelf.read(id)
        if (reading is SavedProjectResult.Unusable) return false
        val copy = SavedProjectText.open(id, left) ?: return true
        if (copy !is SavedProjectCopy.Whole) return false
        if (!copy.isNewerThan(reading as? SavedProjectResult.Found)) return true
        val work = (copy.read() as? SavedProjectResult.Found)?.work ?: return false
        if (reading is SavedProjectResult.Found) return shelf.keep(work) == SaveResult.Kept
        val name = if (work.file == null) freeWorkName(work.name, shelf.works().map { it.name }) else work.name
        return shelf.keep(work.copy(name = name)) == SaveResult.Kept &&
            closed(id, work.keptAt, comesBack = true) == StoreResult.Done
    }

    /** Of two at the same time, what was left is that of a page that could not keep it any more. */
    private fun SavedProjectCopy.Whole.isNewerThan(kept: SavedProjectResult.Found?): Boolean =
        kept == null || entry.keptAt >= kept.work.keptAt

    private suspend fun orphans(): List<Open> = store.names().filter { it.startsWith(PREFIX) }.mapNotNull { name ->
        val words = store.read(name)?.split(' ').orEmpty()
        Open(name.removePrefix(PREFIX), words.firstOrNull() != CLOSED, words.getOrNull(1)?.toLongOrNull() ?: 0)
    }.sortedByDescending { it.since }

    private fun nameOf(id: String) = "$PREFIX$id"

    private class Open(val id: String, val wasRunning: Boolean, val since: Long)

    private companion object {
        const val PREFIX = "open-"
        const val RUNNING = "running"
        const val CLOSED = "closed"
    }
}

/**
 * A work that was open when the app ended.
 *
 * @property claim this window's on it.
 * @property wasCutShort whether the app did not end as it should, so that the last second of work may be lost.
 * @property others how many other works were cut short with it.
 * @property isKept whether it is kept as it is here.
 */
data class RestoredProject(
    val work: SavedProject,
    val claim: ProjectLock,
    val wasCutShort: Boolean,
    val others: Int = 0,
    val isKept: Boolean = true,
)

/** [work] as a window that ends can leave it somewhere else than in its store, see [OpenProjects.takeBack]. */
fun leftText(work: SavedProject): String = SavedProjectText.write(work, order = 0)
