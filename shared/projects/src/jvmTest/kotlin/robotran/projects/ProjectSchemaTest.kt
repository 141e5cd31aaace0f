package robotran.projects

import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import robotran.json.schema.SchemaFile
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.test.fail

/** The schemas and the readers agree on projects, assignments and courses, as far as a schema can express the rules. */
class ProjectSchemaTest {
    private val projects = documentedProjects + documentedAssignments
    private val full =
        listOf(FULL_PROJECT, FIRMWARE_PROJECT, PROJECT_WITH_FILES, EVERY_ASSIGNMENT, EVERY_HAND_IN).map(::elementOf)
    private val course = elementOf(Course("C", "about\nit", listOf(EVERY_ASSIGNMENT), "c-1"))

    @Test
    fun `the documented examples follow the schemas and have no field that they do not know`() {
        assertTrue(documentedAssignments.isNotEmpty() && documentedCourses.isNotEmpty())
        for ((name, text) in projects) assertFollows(PROJECT_SCHEMA, Json.parseToJsonElement(text), name)
        for ((name, text) in documentedCourses) assertFollows(COURSE_SCHEMA, Json.parseToJsonElement(text), name)
    }

    @Test
    fun `every field that is written is in the schema`() {
        full.forEach { assertFollows(PROJECT_SCHEMA, it, writeCompactJson(it)) }
        assertFollows(COURSE_SCHEMA, course, writeCompactJson(course))
    }

    @Test
    fun `a program in each language, and an assignment for all of them, follow the schema`() {
        for (language in ProgramLanguage.entries) {
            val program = ProjectProgram(Program.of(listOf(SourceFile("a" + language.extension, ""))))
            val project = FULL_PROJECT.copy(robots = FULL_PROJECT.robots.map { it.copy(programs = listOf(program)) })
            assertFollows(PROJECT_SCHEMA, elementOf(project), language.name)
        }
        val assignment = EVERY_ASSIGNMENT.assignment?.copy(languages = ProgramLanguage.entries)
        assertFollows(PROJECT_SCHEMA, elementOf(EVERY_ASSIGNMENT.copy(assignment = assignment)), "all languages")
    }

    @Test
    fun `every field of the schema is written`() {
        assertEquals(emptySet(), PROJECT_FIELDS - full.flatMap(::fieldsOf).toSet())
        assertEquals(emptySet(), COURSE_FIELDS - fieldsOf(course))
    }

    @Test
    fun `what the schema refuses is refused`() {
        var refused = 0
        for (project in full.map(::withBareWorlds)) {
            val unchanged = readProject(writeCompactJson(project), Language.ENGLISH)
            assertIs<ProjectFileResult.Success>(unchanged, unchanged.toString())
            for (changed in changes(project)) {
                if (PROJECT_SCHEMA.accepts(changed)) continue
                refused++
                if (readProject(writeCompactJson(changed), Language.ENGLISH) is ProjectFileResult.Failure) continue
                fail("${PROJECT_SCHEMA.errorsIn(changed)}\n${writeCompactJson(changed)}")
            }
        }
        assertTrue(refused > 500, "$refused were refused")
    }

    @Test
    fun `what the schema of courses refuses is refused`() {
        var refused = 0
        for (changed in changes(withBareWorlds(course))) {
            if (COURSE_SCHEMA.accepts(changed)) continue
            refused++
            val text = writeCompactJson(changed)
            assertIs<CourseFileResult.Failure>(
                readCourse(text, Language.ENGLISH),
                "${COURSE_SCHEMA.errorsIn(changed)}\n$text",
            )
        }
        assertTrue(refused > 100, "$refused were refused")
    }

    private fun assertFollows(schema: SchemaFile, file: JsonElement, name: String) {
        assertEquals(emptyList(), schema.errorsIn(file), name)
        assertEquals(emptyList(), schema.unknownIn(file), name)
    }

    /** [element] with worlds that hold only what a project refers to: a world is validated with each change around it. */
    private fun withBareWorlds(element: JsonElement): JsonElement = when (element) {
        is JsonObject -> JsonObject(
            element.mapValues { (name, value) ->
                if (name == "world" && value is JsonObject) bare(value) else withBareWorlds(value)
            },
        )

        is JsonArray -> JsonArray(element.map(::withBareWorlds))
        else -> element
    }

    private fun bare(world: JsonObject): JsonObject {
        val needed = setOf("format", "version", "title", "paper", "robots", "blocks", "lamps")
        return JsonObject(world.filterKeys { it in needed })
    }

    /** Copies of [element] with each of its values outside worlds replaced by wrong ones, or left out. */
    private fun changes(element: JsonElement): List<JsonElement> = when (element) {
        is JsonObject -> element.filterKeys { it != "world" }.flatMap { (name, value) ->
            others(value).map { other ->
                JsonObject(
                    if (other == null) {
                        element - name
                    } else {
                        element + (name to other)
                    },
                )
            } +
                changes(value).map { JsonObject(element + (name to it)) }
        }

        is JsonArray -> element.indices.flatMap { number ->
            fun with(other: JsonElement?) =
                JsonArray(element.take(number) + listOfNotNull(other) + element.drop(number + 1))
            others(element[number]).map(::with) + changes(element[number]).map(::with)
        }

        else -> emptyList()
    }

    /** Wrong values; null removes the value. */
    private fun others(value: JsonElement): List<JsonElement?> = listOf(
        null,
        JsonNull,
        JsonPrimitive(true),
        JsonPrimitive(" "),
        JsonPrimitive("x\ny"),
        JsonPrimitive("../x"),
        JsonPrimitive(-1),
        JsonPrimitive(0),
        JsonPrimitive(2_000_000_000),
        JsonPrimitive("e".repeat(1001)),
        JsonArray(emptyList()),
        JsonObject(emptyMap()),
        JsonObject(mapOf("strange" to JsonNull)),
        JsonArray(listOf(value)),
        (value as? JsonArray)?.firstOrNull()?.let { first -> JsonArray(List(61) { first }) } ?: JsonNull,
    )

    private fun fieldsOf(element: JsonElement): Set<String> = when (element) {
        is JsonObject -> element.keys + element.filterKeys { it != "world" }.values.flatMap(::fieldsOf)
        is JsonArray -> element.flatMap(::fieldsOf).toSet()
        else -> emptySet()
    }

    private companion object {
        const val WORLD = "world.schema.json"
        const val ASSIGNMENT = "assignment.schema.json"
        val plain = schemaTexts.mapValues { Json.parseToJsonElement(it.value) as JsonObject }
        val PROJECT_FIELDS = SchemaFile(plainWithoutFiles(ASSIGNMENT)).fields
        val COURSE_FIELDS = SchemaFile(plainWithoutFiles("course.schema.json")).fields
        val PROJECT_SCHEMA = SchemaFile(whole(ASSIGNMENT))
        val COURSE_SCHEMA = SchemaFile(whole("course.schema.json"))

        /** The schema [name] with the other files that it refers to as definitions. */
        private fun whole(name: String): JsonObject {
            val files = mapOf(WORLD to "urn:robotran:world:2", ASSIGNMENT to "urn:robotran:project:1")
            val embedded = files.filterKeys { it != name }.map { (file, id) ->
                id to
                    JsonObject(mapOf("\$id" to JsonPrimitive(id)) + withIds(plain.getValue(file), files) as JsonObject)
            }
            val own = withIds(plain.getValue(name), files) as JsonObject
            return JsonObject(own + ("\$defs" to JsonObject((own["\$defs"] as? JsonObject).orEmpty() + embedded)))
        }

        private fun plainWithoutFiles(name: String) = withIds(plain.getValue(name), emptyMap()) as JsonObject

        /** References to files become references to IDs; those to files without one go. */
        private fun withIds(element: JsonElement, files: Map<String, String>): JsonElement = when (element) {
            is JsonObject -> JsonObject(
                element.mapNotNull { (name, value) ->
                    val file = (value as? JsonPrimitive)?.content?.takeIf { name == "\$ref" && it.endsWith(".json") }
                    if (file == null) name to withIds(value, files) else files[file]?.let { name to JsonPrimitive(it) }
                }.toMap(),
            )

            is JsonArray -> JsonArray(element.map { withIds(it, files) })
            else -> element
        }
    }
}
