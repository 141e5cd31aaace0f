package robotran.world.file

import io.kotest.property.RandomSource
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.take
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import robotran.json.schema.SchemaFile
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.world.robot.robotErrors
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.test.fail

/** The schema of robot files and the reader agree on a file, as far as a schema can express the rules. */
class RobotSchemaTest {
    private val definition = Json.parseToJsonElement(schemaTexts.getValue("robot.schema.json"))
    private val schema = SchemaFile(definition)
    private val full = Json.parseToJsonElement(FULL_ROBOT)

    @Test
    fun `every robot that comes with Robotran follows the schema and has no field that it does not know`() {
        for ((name, text) in robotTexts + documentedRobots) {
            val robot = Json.parseToJsonElement(text)
            assertEquals(emptyList(), schema.errorsIn(robot), name)
            assertEquals(emptyList(), schema.unknownIn(robot), name)
        }
    }

    @Test
    fun `every field that is written is in the schema`() {
        val possible = arbitraryRobots().filter { robotErrors(it).isEmpty() }
        for (robot in possible.take(200, RandomSource.seeded(2005))) {
            val written = Json.parseToJsonElement(writeRobot(robot))
            assertEquals(emptyList(), schema.errorsIn(written))
            assertEquals(emptyList(), schema.unknownIn(written))
        }
    }

    @Test
    fun `every field of the schema is read`() {
        assertEquals(schema.fields, fieldsOf(full))
        for (changed in changes(full) { listOf(JsonObject(mapOf("strange" to JsonNull))) }) {
            assertIs<RobotFileResult.Failure>(
                readRobot(writeCompactJson(changed), Language.ENGLISH),
                writeCompactJson(changed),
            )
        }
    }

    @Test
    fun `what the schema refuses is refused`() {
        assertEquals(emptyList(), schema.errorsIn(full))
        var refused = 0
        for (changed in changes(full, ::wrongValues)) {
            if (schema.accepts(changed)) continue
            refused++
            val text = writeCompactJson(changed)
            if (readRobot(
                    text,
                    Language.ENGLISH,
                ) !is RobotFileResult.Failure
            ) {
                fail("${schema.errorsIn(changed)}\n$text")
            }
        }
        assertTrue(refused > 800, "$refused were refused")
    }

    @Test
    fun `a robot in a world follows the same rules as one in a file`() {
        val world = Json.parseToJsonElement(
            schemaTexts.getValue("world.schema.json"),
        ).jsonObject.getValue("\$defs").jsonObject
        val robot = definition.jsonObject
        for ((name, rule) in robot.getValue("\$defs").jsonObject) assertEquals(rule, world[name], name)
        val properties = robot.getValue("properties").jsonObject - "format" - "version"
        assertEquals(
            properties,
            world.getValue("robotDescription").jsonObject.getValue("properties").jsonObject.toMap(),
        )
    }
}
