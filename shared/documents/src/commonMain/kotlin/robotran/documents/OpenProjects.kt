package robotran.documents

/**
 * Records which projects are open in windows, to restore them after the app has ended for any reason. A small text for
 * each outlives its window.
 */
class OpenProjects(private val store: KeyValueStore, private val repository: ProjectRepository) {
    /** Records that a window shows the project [id]. */
    suspend fun opened(id: String, now: Long): StoreResult = store.write(nameOf(id), "$RUNNING $now")

    /**
     * Records that the window with the project [id] was closed, or the app ended, normally; the next start restores the
     * project if [comesBack].
     */
    suspend fun closed(id: String, now: Long, comesBack: Boolean): StoreResult =
        if (comesBack) store.write(nameOf(id), "$CLOSED $now") else store.remove(nameOf(id))

    /**
     * Locks and reads the project to restore; null if there is none. It is the last opened one without a window; the
     * others stay available in the list of projects. Skips projects that cannot be read, and leaves them unchanged.
     *
     * @param hasEnded whether the window with the project of this id ended normally, even if it could not record that
     * here.
     * @param mayOpen is asked before a project is read. If it says no, nothing is restored, neither now nor at the next
     * start.
     */
    suspend fun takeBack(
        hasEnded: (id: String) -> Boolean = { false },
        mayOpen: (id: String) -> Boolean = { true },
    ): RestoredProject? {
        var back: RestoredProject? = null
        var abnormalCount = 0
        for (open in orphans()) {
            val claim = repository.claim(open.id) ?: continue
            val endedAbnormally = open.wasRunning && !hasEnded(open.id)
            if (back == null && !mayOpen(open.id)) {
                claim.release()
                store.remove(nameOf(open.id))
                return null
            }
            val reading = if (back == null) repository.read(open.id) else null
            if (reading is SavedProjectResult.Found) {
                back = RestoredProject(reading.work, claim, endedAbnormally = endedAbnormally || reading.isPartial)
            } else {
                claim.release()
                if (back != null && endedAbnormally) abnormalCount++
                if (reading !is SavedProjectResult.Unusable) store.remove(nameOf(open.id))
            }
        }
        return back?.copy(others = abnormalCount)
    }

    /**
     * Restores the project [id], locked by [claim], in its window; null if it cannot be read or is missing.
     *
     * @param hasEnded whether that window ended normally, even if it could not record that here.
     * @param left the text that the window stored elsewhere when it ended, see [handoverText]; used if it is newer than
     * the saved project.
     */
    suspend fun takeBack(id: String, claim: ProjectLock, hasEnded: Boolean, left: String? = null): RestoredProject? {
        val reading = repository.read(id)
        if (reading is SavedProjectResult.Unusable) return null
        val kept = reading as? SavedProjectResult.Found
        val newer = left?.let {
            SavedProjectText.open(id, it) as? SavedProjectCopy.Whole
        }?.takeIf { it.isNewerThan(kept) }
        val found = newer?.read() as? SavedProjectResult.Found ?: kept ?: return null
        val wasRunning = store.read(nameOf(id))?.startsWith(RUNNING) ?: false
        val endedAbnormally = kept?.isPartial == true || (wasRunning && !hasEnded)
        return RestoredProject(found.work, claim, endedAbnormally, isAutosaved = found === kept)
    }

    /**
     * Saves [left], the text that a closed window stored elsewhere for the project [id], see [handoverText], unless the
     * saved project is newer. The project, which must be locked, can then be restored like any other.
     *
     * @return whether the usable content of [left] is saved; otherwise the caller must keep it.
     */
    suspend fun saveHandover(id: String, left: String): Boolean {
        val reading = repository.read(id)
        if (reading is SavedProjectResult.Unusable) return false
        val copy = SavedProjectText.open(id, left) ?: return true
        if (copy !is SavedProjectCopy.Whole) return false
        if (!copy.isNewerThan(reading as? SavedProjectResult.Found)) return true
        val work = (copy.read() as? SavedProjectResult.Found)?.work ?: return false
        if (reading is SavedProjectResult.Found) return repository.save(work) == SaveResult.Saved
        val name = if (work.file == null) {
            uniqueProjectName(work.name, repository.projects().map { it.name })
        } else {
            work.name
        }
        return repository.save(work.copy(name = name)) == SaveResult.Saved &&
            closed(id, work.keptAt, comesBack = true) == StoreResult.Done
    }

    /** Equal times count as newer, because a page only leaves a text that it could not save. */
    private fun SavedProjectCopy.Whole.isNewerThan(kept: SavedProjectResult.Found?): Boolean =
        kept == null || entry.keptAt >= kept.work.keptAt

    /** The projects that other windows have open, the last opened one first. */
    suspend fun elsewhere(): List<String> = orphans().map { it.id }.filter { id ->
        val claim = repository.claim(id)
        claim?.release()
        claim == null
    }

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
 * A project that was open when the app ended.
 *
 * @property claim this window's lock on it.
 * @property endedAbnormally whether the app ended abnormally, so that the last second of work may be lost.
 * @property others number of other projects that ended abnormally with it.
 * @property isAutosaved whether the store contains exactly this state.
 */
data class RestoredProject(
    val work: SavedProject,
    val claim: ProjectLock,
    val endedAbnormally: Boolean,
    val others: Int = 0,
    val isAutosaved: Boolean = true,
)

/** [work] as text that a closing window can store outside its store, see [OpenProjects.takeBack]. */
fun handoverText(work: SavedProject): String = SavedProjectText.write(work, order = 0)
