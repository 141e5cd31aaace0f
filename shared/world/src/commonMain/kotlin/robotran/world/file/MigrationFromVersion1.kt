package robotran.world.file

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.JsonCursor
import robotran.json.JsonPath
import robotran.json.JsonStep
import robotran.world.messages.reason

/**
 * Converts a world from version 1 to version 2: `name` became `title`, `start` the start of the first of `robots`, and
 * the ends of a wall, once `{"x": 1, "y": 2}`, became `[1, 2]`. Everything else stays unchanged.
 */
internal class MigrationFromVersion1(private val file: JsonCursor) {
    val migrated: JsonObject = JsonObject(
        buildMap {
            for (name in file.names) {
                val place = file.member(name)
                when (name) {
                    "version" -> put(name, JsonPrimitive(WORLD_VERSION))
                    "name" -> put("title", place.element)
                    "start" -> put("robots", JsonArray(listOf(JsonObject(mapOf("start" to place.element)))))
                    "walls" -> put(name, JsonArray(place.items(0..Int.MAX_VALUE).map(::wall)))
                    "title", "robots" -> place.refuse(reason { ofVersion(WORLD_VERSION) })
                    else -> put(name, place.element)
                }
            }
        },
    )

    init {
        NEEDED.forEach { file.member(it) }
    }

    /** The path in the file of version 1 of the value that is now at [path]. */
    fun pathBefore(path: JsonPath): JsonPath {
        val around = file.path.steps
        val steps = path.steps.drop(around.size)
        return JsonPath.of(around + stepsBefore(steps))
    }

    private fun stepsBefore(steps: List<JsonStep>): List<JsonStep> =
        when ((steps.firstOrNull() as? JsonStep.Member)?.name) {
            "title" -> listOf(JsonStep.Member("name")) + steps.drop(1)
            "robots" -> steps.drop(ROBOTS_STEPS).ifEmpty { listOf(JsonStep.Member("start")) }

            "walls" -> steps.mapIndexed { number, step ->
                if (number == COORDINATE_STEP && step is JsonStep.Item) {
                    JsonStep.Member(COORDINATES[step.number])
                } else {
                    step
                }
            }

            else -> steps
        }

    private fun wall(cursor: JsonCursor): JsonElement = JsonObject(
        buildMap {
            cursor.names.forEach { put(it, cursor.member(it).element) }
            ENDS.forEach { end -> cursor.member(end).let { point -> putAll(point(end, point)) } }
        },
    )

    /** Keeps other members of a point next to it, because a pair of numbers cannot hold them. */
    private fun point(name: String, cursor: JsonCursor): Map<String, JsonElement> {
        val point = JsonArray(COORDINATES.map { cursor.member(it).element })
        return mapOf(name to point) + cursor.rest().mapKeys { "$name.${it.key}" }
    }

    private companion object {
        val NEEDED = listOf("name", "paper", "walls", "start", "seed")
        val ENDS = listOf("from", "to")
        val COORDINATES = listOf("x", "y")

        /** `robots[0]`. */
        const val ROBOTS_STEPS = 2

        /** The last of `walls[2].from[0]`. */
        const val COORDINATE_STEP = 3
    }
}
