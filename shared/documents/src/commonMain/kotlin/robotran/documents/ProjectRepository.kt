package robotran.documents

import robotran.documents.messages.DocumentMessages
import robotran.language.Language
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject

/**
 * The pupil's projects in a [KeyValueStore], two copies of each. Saving overwrites the older copy, so that a failure
 * leaves the newer one intact.
 *
 * Two windows must not save the same project, see [claim]. Not thread-safe.
 */
class ProjectRepository(private val store: KeyValueStore) {
    private val newest = mutableMapOf<String, Place>()

    /** The copies that were read since the walk through the projects began; null if none goes on. */
    private var known: MutableMap<String, List<Pair<String, SavedProjectCopy?>>>? = null

    /**
     * Reads each project at most once during [walk]. What other windows save meanwhile is seen only of projects that this
     * one claims then.
     */
    suspend fun <T> readingOnce(walk: suspend () -> T): T {
        if (known != null) return walk()
        known = mutableMapOf()
        return try {
            walk()
        } finally {
            known = null
        }
    }

    /** All readable projects, newest first. */
    suspend fun projects(): List<ProjectSummary> = ids().mapNotNull {
        copies(it).newestWhole()?.second?.entry
    }.sortedByDescending { it.keptAt }

    suspend fun read(id: String): SavedProjectResult {
        val copies = copies(id)
        val whole = copies.filter { it.second is SavedProjectCopy.Whole }
        if (copies.any {
                it.second is SavedProjectCopy.Newer
            }
        ) {
            return SavedProjectResult.Unusable { DocumentMessages.of(it).savedByNewer() }
        }
        val (place, copy) = whole.newestWhole()
            ?: return if (copies.isEmpty()) {
                SavedProjectResult.Missing
            } else {
                SavedProjectResult.Unusable {
                    DocumentMessages.of(it).copiesBroken()
                }
            }
        newest[id] = Place(place, copy.order)
        val reading = copy.read()
        return if (reading is SavedProjectResult.Found) reading.copy(isPartial = copies.size > whole.size) else reading
    }

    /** The project [id] as the text of a project file, unread; null if there is no whole copy. */
    suspend fun fileText(id: String): String? = copies(id).newestWhole()?.second?.project

    /** Saves [work], which must be locked. Rejects a project that could not be read again. */
    suspend fun save(work: SavedProject): SaveResult {
        require(work.id.length <= SavedProject.MAXIMUM_ID) { "${work.id} is too long" }
        val project = writeProject(work.project)
        if (readProject(project, Language.ENGLISH) is ProjectFileResult.Failure) return SaveResult.TooLong
        if (work.id !in
            newest
        ) {
            copies(work.id).newestWhole()?.let { (place, copy) -> newest[work.id] = Place(place, copy.order) }
        }
        val last = newest[work.id]
        val place = if (last?.copy == COPIES.first()) COPIES.last() else COPIES.first()
        val order = (last?.order ?: 0) + 1
        val result = store.write(nameOf(work.id, place), SavedProjectText.write(work, order, project))
        known?.remove(work.id)
        return when (result) {
            StoreResult.Done -> SaveResult.Saved.also { newest[work.id] = Place(place, order) }
            StoreResult.Full -> SaveResult.Full
            StoreResult.NoAnswer -> SaveResult.NoAnswer
            is StoreResult.Failed -> SaveResult.Failed(result.reason)
        }
    }

    /**
     * Deletes the project [id] permanently. If interrupted, the project is still there, possibly in its previous state.
     */
    suspend fun delete(id: String): StoreResult {
        val last = copies(id).newestWhole()?.first ?: COPIES.first()
        val results = (COPIES - last + last).map { store.remove(nameOf(id, it)) }
        newest.remove(id)
        known?.remove(id)
        return results.firstOrNull { it != StoreResult.Done } ?: StoreResult.Done
    }

    /** Locks the project [id] for this window; null if another window holds the lock. */
    suspend fun claim(id: String): ProjectLock? = store.claim("$PREFIX$id").also { known?.remove(id) }

    /** The ids of all projects, readable or not. */
    suspend fun ids(): List<String> =
        store.names().filter { it.startsWith(PREFIX) && it.substringAfterLast('.', "") in COPIES }
            .map { it.removePrefix(PREFIX).substringBeforeLast('.') }.distinct()

    /** The copies of the project [id], with null for a damaged one. */
    private suspend fun copies(id: String): List<Pair<String, SavedProjectCopy?>> =
        known?.get(id) ?: COPIES.mapNotNull { copy ->
            store.read(nameOf(id, copy))?.let { copy to SavedProjectText.open(id, it) }
        }.also { known?.set(id, it) }

    private fun List<Pair<String, SavedProjectCopy?>>.newestWhole(): Pair<String, SavedProjectCopy.Whole>? =
        mapNotNull { (place, copy) ->
            (copy as? SavedProjectCopy.Whole)?.let { place to it }
        }.maxByOrNull { it.second.order }

    private fun nameOf(id: String, copy: String) = "$PREFIX$id.$copy"

    private class Place(val copy: String, val order: Long)

    private companion object {
        const val PREFIX = "work-"
        val COPIES = listOf("a", "b")
    }
}
