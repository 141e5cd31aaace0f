package robotran.workshop.learning

import kotlinx.serialization.SerialName
import kotlinx.serialization.Serializable
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import robotran.learning.Lessons
import robotran.workshop.platform.KeyValueStore

/**
 * The stored learning progress of a pupil.
 *
 * @property welcomed whether the first page was seen.
 * @property tutorialShown whether the tutorial is shown next to the program.
 * @property step the name of the last step shown.
 * @property programs the pupil's versions of the steps' programs, by step name; after `nxt/`, those for an NXT.
 * @property records the pupil's own best results, by the names of steps and, after `world/`, of worlds.
 * @property brick the name of the brick of the pupil's own robot when a step was loaded last: not each step has that one.
 * @property previousProject the ID of the stored project that was open before the tutorial; null if it was unchanged.
 * @property tutorialProject the ID of the stored project of the tutorial.
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
    val records: Map<String, TaskRecord> = emptyMap(),
    val brick: String? = null,
    @SerialName("ownWork")
    val previousProject: String? = null,
    @SerialName("tutorialWork")
    val tutorialProject: String? = null,
) {
    suspend fun writeTo(store: KeyValueStore) {
        store.write(NAME, JSON.encodeToString(serializer(), this))
    }

    /** The same with the names that the lessons have now: those of older versions began with a number. */
    private fun withPresentNames(): LearningProgress = copy(
        step = step?.let(::presentName),
        stepsDone = stepsDone.map(::presentName).toSet(),
        programs = programs.mapKeys { presentName(it.key) },
    )

    private fun presentName(name: String): String = Lessons.named(name)?.name ?: name

    companion object {
        private const val NAME = "learning"
        private val JSON = Json { ignoreUnknownKeys = true }

        /** The progress stored in [store]; empty progress if none can be read. */
        suspend fun readFrom(store: KeyValueStore): LearningProgress {
            val text = store.read(NAME) ?: return LearningProgress()
            return try {
                JSON.decodeFromString(serializer(), text).withPresentNames()
            } catch (_: SerializationException) {
                LearningProgress()
            } catch (_: IllegalArgumentException) {
                LearningProgress()
            }
        }
    }
}
