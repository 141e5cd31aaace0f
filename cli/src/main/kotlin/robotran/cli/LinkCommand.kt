package robotran.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.option
import kotlinx.coroutines.runBlocking
import robotran.cli.console.messages
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.isNamed
import robotran.cli.files.nameOf
import robotran.cli.files.readProgramFiles
import robotran.cli.input.LoadedWorld
import robotran.cli.input.courseOf
import robotran.cli.input.isCourse
import robotran.cli.input.isProject
import robotran.cli.input.loadWorld
import robotran.cli.input.plainSheetFor
import robotran.cli.input.projectOf
import robotran.cli.input.readWorldFile
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.messages.ConsoleMessages
import robotran.console.speaking
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.linkOf
import robotran.projects.localSite
import robotran.projects.siteAddress

/** `robotran link FILE..`: prints the URL fragment that opens the page with a world or a project. */
internal class LinkCommand(private val process: Console) : CoreCliktCommand("link") {
    private val files by argument(
        "FILE",
        help = "a world (.world.json), a project (.robotran), a course (.course.json or its folder), or programs " +
            "(.robo, .java, .nqc, .lasm, .rcx) for one robot",
    )
        .multiple(required = true)
    private val world by option(
        "--world",
        metavar = "FILE",
        help = "the world of the programs (.world.json, or a project or link with it); a plain sheet if not given",
    )

    private val site by option(
        "--site",
        metavar = "ADDRESS",
        help = "the address of a Robotran site, to be put before the link",
    )
        .convert { text ->
            siteAddress(text)
                ?: fail("$text is not the address of a site, such as https://school.example/robotran/")
        }

    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) =
        "Prints a world, a project or programs as a link: whole with --site, otherwise to be pasted behind the " +
            "address of a site."

    override fun run() {
        val single = files.singleOrNull()
        val isWhole = single != null && (isNamed(single, WORLD) || isProject(single) || isCourse(single))
        if (isWhole && world != null) throw UsageError("--world goes with programs only")
        val made =
            when {
                !isWhole -> compilePrograms()?.let { runBlocking { linkOf(it, spoken.language) } }

                isCourse(single.orEmpty()) -> courseOf(single.orEmpty(), console)?.let {
                    runBlocking { linkOf(it, spoken.language) }
                }

                isNamed(single.orEmpty(), WORLD) -> readWorldFile(single.orEmpty(), console)?.let {
                    runBlocking { linkOf(it, spoken.language) }
                }

                else -> projectOf(single.orEmpty(), console)?.let { runBlocking { linkOf(it, spoken.language) } }
            }
        throw ProgramResult(tell(made).status)
    }

    private fun tell(made: LinkCreation?): ExitCode = when (made) {
        null -> ExitCode.BAD_INPUT

        is LinkCreation.Made -> {
            console.say(site.orEmpty() + made.fragment)
            localSite(site.orEmpty())?.let { console.complain(ConsoleMessages.of(console.language).linksStayHere(it)) }
            ExitCode.DONE
        }

        is LinkCreation.TooLong -> {
            console.complain(made.message)
            ExitCode.BAD_INPUT
        }
    }

    /** Returns the programs as a project. Programs with errors are allowed: a pupil may share one to ask for help. */
    private fun compilePrograms(): Project? {
        val programs =
            when (val read = readProgramFiles(files, console.messages)) {
                is ProgramFiles.Success -> {
                    read.notes.forEach(console::complain)
                    read.programs.map { it to programOf(it) }
                }

                is ProgramFiles.Failure -> {
                    console.complain(read.reason)
                    return null
                }
            }
        programs.firstOrNull { it.second == null }?.let { (program, _) ->
            console.complain(console.messages.compiled(program.path))
            return null
        }
        val place = world?.let { loadWorld(it, console) ?: return null }
            ?: LoadedWorld(plainSheetFor(programs.map { it.first }))
        val own = ProjectRobot(place.world.robots.first().name, programs.mapNotNull { it.second })
        return Project(place.world, listOf(own) + place.others)
    }

    /** Strips the local folders from the path. */
    private fun programOf(program: NamedProgram): ProjectProgram? = ProjectProgram.of(program.source)?.let { found ->
        found.copy(program = found.program.run { copy(files = files.map { it.copy(name = nameOf(it.name)) }) })
    }

    private companion object {
        const val WORLD = ".world.json"
    }
}
