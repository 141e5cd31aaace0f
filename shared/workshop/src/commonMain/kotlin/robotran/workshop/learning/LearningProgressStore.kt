package robotran.workshop.learning

import kotlinx.coroutines.CoroutineScope
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.service.SerialWriteQueue

/** The learning progress of the pupil, stored on each change. */
internal class LearningProgressStore(private val store: KeyValueStore, scope: CoroutineScope) {
    private val writes = SerialWriteQueue(scope)

    var progress = LearningProgress()
        private set

    /** Restores the stored progress. */
    suspend fun load() {
        progress = LearningProgress.readFrom(store)
    }

    /** Stores the progress that [change] makes of the current one. */
    fun update(change: (LearningProgress) -> LearningProgress) {
        val changed = change(progress)
        if (changed == progress) return
        progress = changed
        writes.add { changed.writeTo(store) }
    }

    /** Waits until the progress is stored. */
    suspend fun saveNow() = writes.finish()
}
