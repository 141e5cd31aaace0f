package robotran.workshop.learning

import kotlinx.coroutines.CoroutineScope
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.learning.Lessons
import robotran.learning.drawing.RunDrawing
import robotran.learning.drawing.readRunDrawing
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.service.SerialWriteQueue

/**
 * What the pupil's robot has drawn in each lesson when it was solved last; stored on each change. They lie apart from the
 * [LearningProgress], which is stored far more often, and which no fault in them can harm.
 */
internal class PupilDrawings(private val store: KeyValueStore, scope: CoroutineScope) {
    private val writes = SerialWriteQueue(scope)

    /** By the names of the lessons. */
    var drawings: Map<String, RunDrawing> = emptyMap()
        private set

    /** Restores the stored drawings. */
    suspend fun load() {
        drawings = store.read(NAME)?.let(::drawingsIn).orEmpty()
    }

    /** Keeps [drawing] as that of [lesson]. */
    fun keep(lesson: String, drawing: RunDrawing) {
        if (drawings[lesson] == drawing) return
        drawings = drawings + (lesson to drawing)
        val text = JsonObject(drawings.mapValues { JsonPrimitive(it.value.text) }).toString()
        writes.add { store.write(NAME, text) }
    }

    /** Waits until the drawings are stored. */
    suspend fun saveNow() = writes.finish()

    private companion object {
        const val NAME = "learning-drawings"

        /** More than the drawings of all lessons need. */
        const val MAX_CHARACTERS = 200_000

        /** The drawings of lessons in [text]; what is damaged is left out. */
        fun drawingsIn(text: String): Map<String, RunDrawing> {
            if (text.length > MAX_CHARACTERS) return emptyMap()
            val entries = try {
                Json.parseToJsonElement(text) as? JsonObject
            } catch (_: SerializationException) {
                null
            }
            return entries.orEmpty().mapNotNull { (name, entry) ->
                val lesson = Lessons.named(name)?.name ?: return@mapNotNull null
                val drawing = (entry as? JsonPrimitive)?.let { readRunDrawing(it.content) } ?: return@mapNotNull null
                lesson to drawing
            }.toMap()
        }
    }
}
