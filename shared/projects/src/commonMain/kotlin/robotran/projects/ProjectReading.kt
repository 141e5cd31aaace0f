package robotran.projects

import robotran.json.JsonCursor
import robotran.json.JsonFormat
import robotran.json.JsonValidationException
import robotran.json.messages.JsonMessages
import robotran.languagesupport.SourceFile
import robotran.programs.JavaSettings
import robotran.programs.support
import robotran.projects.messages.told
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
        places[it].refuse(told { robotTwice(robots[it].name) })
    }
    return robots
}

private fun robotIn(place: JsonCursor, world: World): ProjectRobot {
    val name = place.member("name").text(ProjectLimits.MAXIMUM_NAME_CHARACTERS)
    if (world.robots.none { it.name == name }) place.member("name").refuse(told { mustNameRobotOfWorld() })
    val programs = programsIn(place.optional("programs"))
    val facing = place.optional("lightSensor")?.choice(FACINGS)
    val files = place.optional("flash")?.let(::nxtFilesIn).orEmpty()
    return ProjectRobot(name, programs, firstProgramIn(place, programs.size), facing, unknownOf(place), files)
}

/** The index of the first program of [count] in the field of [place]. */
internal fun firstProgramIn(place: JsonCursor, count: Int): Int =
    (place.optional("firstProgram")?.wholeNumber(1..maxOf(1, count)) ?: 1) - 1

internal fun programIn(place: JsonCursor): ProjectProgram {
    val language = place.member("language").choice(LANGUAGES)
    val name = place.member("name").text(ProjectLimits.MAXIMUM_NAME_CHARACTERS)
    val files = if (language.mayHaveFiles) {
        place.member("files").items(1..ProjectLimits.MAXIMUM_FILES).map(::fileIn)
    } else {
        listOf(SourceFile(name, textIn(place.member(TEXT))))
    }
    val view = place.optional("view")?.textOrNull()?.let(VIEWS::get).takeIf { language.support.hasBlocks }
    return ProjectProgram(name, language, files, view, unknownOf(place))
}

private fun fileIn(place: JsonCursor): SourceFile {
    // Unknown fields of a program file cannot be preserved.
    (place.names - FILE_FIELDS).firstOrNull()?.let { field -> place.refuse(told { mustNotHave(field) }) }
    return SourceFile(place.member("name").text(ProjectLimits.MAXIMUM_NAME_CHARACTERS), textIn(place.member(TEXT)))
}

/** Its lines, unchanged and with any line ends. */
internal fun textIn(place: JsonCursor): String =
    place.items(1..ProjectLimits.MAXIMUM_LINES).joinToString("\n") { line ->
        val text = line.textOrNull() ?: line.refuse { JsonMessages.of(it).mustBeText() }
        if ('\n' in text) line.refuse(told { mustBeOneLine() })
        text
    }

private fun settingsIn(place: JsonCursor) = ProjectSettings(
    seed = place.optional("seed")?.wholeNumber(0..Int.MAX_VALUE),
    realism = place.optional("realism")?.number(0.0..1.0),
    java = place.optional("java")?.let(::javaSettingsIn) ?: JavaSettings(),
    unknown = unknownOf(place),
)

private fun javaSettingsIn(place: JsonCursor): JavaSettings {
    val default = JavaSettings()
    return JavaSettings(
        place.optional("mode")?.choice(MODES) ?: default.mode,
        place.optional("speed")?.choice(SPEEDS) ?: default.speed,
    )
}

private val FORMAT = JsonFormat(
    PROJECT_FORMAT,
    PROJECT_VERSION,
    told { notAProject(PROJECT_FORMAT) },
    { version -> told { newerProject(version, PROJECT_VERSION) } },
)
private val FILE_FIELDS = setOf("name", TEXT)
