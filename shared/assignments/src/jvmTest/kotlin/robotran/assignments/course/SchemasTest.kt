package robotran.assignments.course

import io.github.optimumcode.json.schema.JsonSchema
import io.github.optimumcode.json.schema.JsonSchemaLoader
import io.github.optimumcode.json.schema.OutputCollector
import io.github.optimumcode.json.schema.ValidationError
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import robotran.assignments.ASSIGNMENT
import robotran.assignments.java
import robotran.assignments.robolang
import robotran.assignments.schemaTexts
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.learning.Lessons
import robotran.programs.JavaSettings
import robotran.projects.AssignmentHint
import robotran.projects.AssignmentPicture
import robotran.projects.AssignmentTries
import robotran.projects.BestTry
import robotran.projects.Feedback
import robotran.projects.FeedbackResult
import robotran.projects.HandIn
import robotran.projects.ProgramView
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectRobot
import robotran.projects.ProjectSettings
import robotran.projects.TryResult
import robotran.projects.elementOf
import robotran.projects.readProject
import robotran.rcxrom.controls.BrickButton
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.LightFacing
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.test.fail

/** The schemas and the readers agree on files, as far as a schema can express the rules. */
class SchemasTest {
    private val result = TryResult(1, 2, 500, "abc")
    private val full: JsonObject = elementOf(
        ASSIGNMENT.copy(
            robots = listOf(
                ProjectRobot(
                    ASSIGNMENT.world.robots.first().name,
                    listOf(robolang("beep").copy(view = ProgramView.BLOCKS), java("class A {}")),
                    firstProgram = 1,
                    lightFacing = LightFacing.DOWN,
                ),
            ),
            settings = ProjectSettings(3, 0.5, JavaSettings(TinyVmMode.FORGIVING, TinyVmSpeed.UNLIMITED)),
            inputs = listOf(
                RecordedInput(1, SessionInput.Press(BrickButton.RUN)),
                RecordedInput(2, SessionInput.PlaceRobot(0, Pose(1.0, 2.0, 3.0))),
                RecordedInput(3, SessionInput.ChangeAmbientLight(0.2)),
                RecordedInput(4, SessionInput.ChangeTemperature(20.0)),
                RecordedInput(5, SessionInput.TouchSensor(0, 1, true)),
            ),
            assignment = ASSIGNMENT.assignment?.copy(
                text = "Do\nit.",
                pictures = listOf(AssignmentPicture("a", "QUJD")),
                mayChangeWorld = true,
                languages = listOf(ProgramLanguage.JAVA),
                words = listOf("beep"),
                hints = listOf(AssignmentHint("Look.", "never moved", 3)),
                due = "Friday",
                nameWanted = "First name",
                start = listOf(robolang("buzz")),
                solution = listOf(robolang("beep")),
            ),
            tries = AssignmentTries(4, BestTry(listOf(robolang("beep"), robolang("buzz")), 1, emptyList(), result)),
            handIn = HandIn("Anna", 2, result, "abc"),
            feedback = Feedback("Well\ndone", listOf(FeedbackResult("other", 1, 2))),
        ),
    )
    private val fullCourse: JsonObject = Json.parseToJsonElement(
        writeCourse(Course("Drawing", "One.\nTwo.", listOf(ASSIGNMENT))),
    ).jsonObject

    @Test
    fun `every field that is written is in the schemas`() {
        assertEquals(emptyList(), mistakesIn(ASSIGNMENTS, full))
        assertEquals(emptyList(), mistakesIn(CLOSED_ASSIGNMENTS, JsonObject(full - "world" + ("world" to WORLD))))
        assertEquals(emptyList(), mistakesIn(COURSES, fullCourse))
        for (strand in Lessons.strands) {
            val course = Json.parseToJsonElement(writeCourse(courseOf(strand, Language.GERMAN)))
            assertEquals(emptyList(), mistakesIn(COURSES, course), strand.name)
        }
        val listing = courseFolder(courseOfWorlds(Language.ENGLISH)).first().bytes.decodeToString()
        assertEquals(emptyList(), mistakesIn(COURSES, Json.parseToJsonElement(listing)))
    }

    @Test
    fun `what the schemas refuse is refused`() {
        val refused = changes(full).count { changed ->
            val isRefused = !ASSIGNMENTS.validate(changed, OutputCollector.flag()).valid
            if (isRefused && readProject(writeCompactJson(changed)) is ProjectFileResult.Loaded) {
                fail("${mistakesIn(ASSIGNMENTS, changed)}\n${writeCompactJson(changed)}")
            }
            isRefused
        }
        assertTrue(refused > 500, "$refused were refused")
        val refusedCourses = changes(fullCourse).count { changed ->
            val isRefused = !COURSES.validate(changed, OutputCollector.flag()).valid
            if (isRefused) assertIs<CourseFileResult.Rejected>(readCourse(writeCompactJson(changed)), "$changed")
            isRefused
        }
        assertTrue(refusedCourses > 100, "$refusedCourses were refused")
    }

    @Test
    fun `what the readers take the schemas take, too`() {
        for (changed in changes(full)) {
            if (readProject(writeCompactJson(changed)) is ProjectFileResult.Loaded) {
                assertEquals(emptyList(), mistakesIn(ASSIGNMENTS, changed))
            }
        }
    }

    private fun mistakesIn(schema: JsonSchema, element: JsonElement): List<String> {
        val found = mutableListOf<ValidationError>()
        schema.validate(element, found::add)
        return found.map { "${it.objectPath}: ${it.message}" }
    }

    private fun others(value: JsonElement): List<JsonElement?> = listOf(
        null,
        JsonNull,
        JsonPrimitive(true),
        JsonPrimitive(" "),
        JsonPrimitive("x*"),
        JsonPrimitive(-1),
        JsonPrimitive(1),
        JsonPrimitive(1.5),
        JsonPrimitive(1e12.toLong()),
        JsonPrimitive("e".repeat(501)),
        JsonArray(emptyList()),
        JsonObject(emptyMap()),
        JsonArray(List(31) { value }),
    )

    /** Copies with each value outside worlds replaced by each of [others]. */
    private fun changes(element: JsonElement): List<JsonElement> = when (element) {
        is JsonObject -> element.flatMap { (name, value) ->
            val replaced = others(value).map { other ->
                JsonObject(if (other == null) element - name else element + (name to other))
            }
            val inside = if (name == "world") emptyList() else changes(value)
            replaced + inside.map { JsonObject(element + (name to it)) }
        }

        is JsonArray -> element.indices.flatMap { number ->
            fun with(other: JsonElement?) =
                JsonArray(element.take(number) + listOfNotNull(other) + element.drop(number + 1))
            others(element[number]).map(::with) + changes(element[number]).map(::with)
        }

        else -> emptyList()
    }

    private companion object {
        /** A schema names the other by its file; a validator without files needs another name. */
        fun definition(name: String): JsonElement = Json.parseToJsonElement(
            schemaTexts.getValue("$name.schema.json")
                .replace("\"world.schema.json\"", "\"urn:robotran:world:2\"")
                .replace("\"assignment.schema.json\"", "\"urn:robotran:assignment:1\""),
        )

        fun named(element: JsonElement, name: String) = JsonObject(element.jsonObject + ("\$id" to JsonPrimitive(name)))

        fun loader() = JsonSchemaLoader.create().register(definition("world"))

        val ASSIGNMENTS = loader().fromJsonElement(named(definition("assignment"), "urn:robotran:assignment:1"))
        val CLOSED_ASSIGNMENTS = loader().fromJsonElement(
            closed(named(definition("assignment"), "urn:robotran:closed")),
        )
        val COURSES = loader().register(named(definition("assignment"), "urn:robotran:assignment:1"))
            .fromJsonElement(definition("course"))
        val WORLD = elementOf(ASSIGNMENT).getValue("world")

        /** A schema that takes no unknown fields. */
        fun closed(element: JsonElement): JsonElement = when (element) {
            is JsonObject -> {
                val inner = element.mapValues { closed(it.value) }
                val isClosed = element["type"] == JsonPrimitive("object")
                JsonObject(if (isClosed) inner + ("additionalProperties" to JsonPrimitive(false)) else inner)
            }

            is JsonArray -> {
                JsonArray(element.map(::closed))
            }

            else -> {
                element
            }
        }
    }
}
