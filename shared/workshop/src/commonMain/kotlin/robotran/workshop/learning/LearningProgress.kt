package robotran.workshop.learning

import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.workshop.platform.KeyValueStore

/**
 * How far somebody has come with learning, as it is kept.
 *
 * @property welcomed whether the first page was seen.
 * @property tutorialShown whether the tutorial stands beside the program.
 * @property step the name of the step that was shown last.
 * @property programs the pupil's own versions of the steps' programs, by the names of the steps.
 * @property ownWork the id of the kept work that was on the desk before the tutorial; null if nothing was changed in
 * that.
 * @property tutorialWork the id of the kept work that the tutorial is.
 */
@Serializable
internal data class LearningProgress(
    val welcomed: Boolean = false,
    val tutorialShown: Boolean = false,
    val folded: Boolean = false,
    val step: String? = null,
    val stepsDone: Set<String> = emptySet(),
    val worldsDone: Set<String> = emptySet(),
    val programs: Map<String, String> = emptyMap(),
    val ownWork: String? = null,
    val tutorialWork: String? = null,
) {
    suspend fun keepIn(store: KeyValueStore) {
        store.write(NAME, JSON.encodeToString(serializer(), this))
    }

    companion object {
        private const val NAME = "learning"
        private val JSON = Json { ignoreUnknownKeys = true }

        /** What was kept in [store]; nothing done yet where there is nothing that can be read. */
        suspend fun readFrom(store: KeyValueStore): LearningProgress {
            val text = store.read(NAME) ?: return LearningProgress()
            return try {
                JSON.decodeFromString(serializer(), text)
            } catch (_: SerializationException) {
                LearningProgress()
            } catch (_: IllegalArgumentException) {
                LearningProgress()
            }
        }
    }
}
