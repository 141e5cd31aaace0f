package robotran.projects

import robotran.json.JsonCursor
import robotran.json.JsonFormat
import robotran.json.JsonValidationException
import robotran.json.messages.JsonMessages
import robotran.languagesupport.SourceFile
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.programs.support
import robotran.projects.messages.reason
import robotran.world.World
import robotran.world.file.FACINGS
import robotran.world.file.unknownOf
import robotran.world.file.worldIn

/**
 * The project in a file, or in a part of one such as that of a course.
 *
 * @param given the world of a file that has none; null if it must have one.
 * @throws JsonValidationException if it is invalid.
 */
fun projectIn(file: JsonCursor, given: World? = null): Project {
    FORMAT.versionOf(file)
    val world = given?.takeIf { file.optional("world") == null } ?: worldIn(file.member("world"))
    return Project(
        world = world,
        robots = robotsIn(file, world),
        settings = file.optional("settings")?.let(::settingsIn) ?: ProjectSettings(),
        inputs = file.optional("inputs")?.let { InputReader(world).read(it) }.orEmpty(),
        assignment = file.optional("assignment")?.let(::assignmentIn),
        tries = file.optional("tries")?.let { triesIn(it, world) },
        handIn = file.optional("handIn")?.let(::handInIn),
        feedback = file.optional("feedback")?.let(::feedbackIn),
        unknown = unknownOf(file),
    )
}

private fun robotsIn(file: JsonCursor, world: World): List<ProjectRobot> {
    val places = file.optional("robots")?.items(0..world.robots.size).orEmpty()
    val robots = places.map { robotIn(it, world) }
    robots.indices.firstOrNull { number -> robots.take(number).any { it.name == robots[number].name } }?.let {
        places[it].refuse(reason { robotTwice(robots[it].name) })
    }
    return robots
}

private fun robotIn(cursor: JsonCursor, world: World): ProjectRobot {
    val name = cursor.member("name").text(ProjectLimits.MAXIMUM_NAME_CHARACTERS)
    if (world.robots.none { it.name == name }) cursor.member("name").refuse(reason { mustNameRobotOfWorld() })
    val programs = programsIn(cursor.optional("programs"))
    val facing = cursor.optional("lightSensor")?.choice(FACINGS)
    val files = cursor.optional("flash")?.let(::nxtFilesIn).orEmpty()
    return ProjectRobot(name, programs, firstProgramIn(cursor, programs.size), facing, unknownOf(cursor), files)
}

/** The index of the first program of [count] in the field of [cursor]. */
internal fun firstProgramIn(cursor: JsonCursor, count: Int): Int =
    (cursor.optional("firstProgram")?.wholeNumber(1..maxOf(1, count)) ?: 1) - 1

internal fun programIn(cursor: JsonCursor): ProjectProgram {
    val language = cursor.member("language").choice(LANGUAGES)
    val name = cursor.member("name").text(ProjectLimits.MAXIMUM_NAME_CHARACTERS)
    val files = if (language.mayHaveFiles) {
        cursor.member("files").items(1..ProjectLimits.MAXIMUM_FILES).map(::fileIn)
    } else {
        listOf(SourceFile(name, textIn(cursor.member(TEXT))))
    }
    val view = cursor.optional("view")?.textOrNull()?.let(VIEWS::get).takeIf { language.support.hasBlocks }
    // Reading the program tells; the field is for those who read the file.
    cursor.optional(WORDS)
    return ProjectProgram(Program(name, language, files), view, unknownOf(cursor))
}

private fun fileIn(cursor: JsonCursor): SourceFile {
    // Unknown fields of a program file cannot be preserved.
    (cursor.names - FILE_FIELDS).firstOrNull()?.let { field -> cursor.refuse(reason { mustNotHave(field) }) }
    return SourceFile(cursor.member("name").text(ProjectLimits.MAXIMUM_NAME_CHARACTERS), textIn(cursor.member(TEXT)))
}

/** Its lines, unchanged and with any line ends. */
internal fun textIn(cursor: JsonCursor): String =
    cursor.items(1..ProjectLimits.MAXIMUM_LINES).joinToString("\n") { line ->
        val text = line.textOrNull() ?: line.refuse { JsonMessages.of(it).mustBeText() }
        if ('\n' in text) line.refuse(reason { mustBeOneLine() })
        text
    }

private fun settingsIn(cursor: JsonCursor) = ProjectSettings(
    seed = cursor.optional("seed")?.wholeNumber(0..Int.MAX_VALUE),
    realism = cursor.optional("realism")?.number(0.0..1.0),
    java = cursor.optional("java")?.let(::javaSettingsIn) ?: JavaSettings(),
    unknown = unknownOf(cursor),
)

private fun javaSettingsIn(cursor: JsonCursor): JavaSettings {
    val default = JavaSettings()
    return JavaSettings(
        cursor.optional("mode")?.choice(MODES) ?: default.mode,
        cursor.optional("speed")?.choice(SPEEDS) ?: default.speed,
    )
}

private val FORMAT = JsonFormat(
    PROJECT_FORMAT,
    PROJECT_VERSION,
    reason { notAProject(PROJECT_FORMAT) },
    { version -> reason { newerProject(version, PROJECT_VERSION) } },
)
private val FILE_FIELDS = setOf("name", TEXT)
