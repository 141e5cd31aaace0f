package robotran.cli.packaging

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.options.required
import com.github.ajalt.clikt.parameters.types.choice
import kotlinx.coroutines.runBlocking
import robotran.assignments.course.pupilCopy
import robotran.assignments.doing.pupilCopy
import robotran.assignments.packaging.PackageResult
import robotran.assignments.packaging.ScormVersion
import robotran.assignments.packaging.learningPackage
import robotran.cli.console.messages
import robotran.cli.files.mayWrite
import robotran.cli.files.writeFile
import robotran.cli.input.courseOf
import robotran.cli.input.isCourse
import robotran.cli.input.projectOf
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.messages.ConsoleMessages
import robotran.console.speaking
import robotran.projects.Project
import robotran.siteserver.WebCommand
import kotlin.io.path.Path

/** `robotran package ASSIGNMENT.. -o FILE`: makes a package that a learning platform imports. */
internal class PackageCommand(private val process: Console) : CoreCliktCommand("package") {
    private val assignments by argument(
        "ASSIGNMENT",
        help = "assignments (.robotran) or courses (.course.json, a folder with course.json) in the order in " +
            "which pupils do them, or links to them",
    ).multiple(required = true)
    private val output by option("-o", "--output", metavar = "FILE", help = "the zip file to write").required()
    private val scorm by option("--scorm", help = "the standard that the platform knows, 2004 if not given")
        .choice("1.2" to ScormVersion.SCORM_1_2, "2004" to ScormVersion.SCORM_2004)
        .default(ScormVersion.SCORM_2004, "2004")
    private val title by option(
        "--title",
        metavar = "TITLE",
        help = "that of the course or of the first assignment if not given",
    )
    private val site by option(
        "--site",
        metavar = "FOLDER",
        help = "the site to put into it, as ./gradlew :webApp:dist makes it; that of this source tree if not given",
    )
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)
    private val aboutSite get() = ConsoleMessages.of(spoken.language)

    override fun help(context: Context) =
        "Makes a SCORM package of assignments for a learning platform. It contains the web site, so that it needs no " +
            "other server."

    override fun run() {
        if (!mayWrite(assignments, listOf(output), console)) throw ProgramResult(ExitCode.BAD_INPUT.status)
        val parts = assignments.map(::partOf)
        val projects = parts.flatMap { it.second }
        if (WebCommand.isOnlyAsked()) return
        val folder = (site ?: System.getProperty(WebCommand.SITE))?.let { Path(it) }
            ?: refuse(aboutSite.siteNotHere())
        val files = readSiteFiles(folder) ?: refuse(aboutSite.siteNotBuilt(folder.toString()))
        val name = title ?: parts.first().first
        val made = runBlocking { learningPackage(name, projects, scorm, files, spoken.language) }
        when (made) {
            is PackageResult.TooLong -> refuse(made.message)
            is PackageResult.Made -> writeFile(output, made.bytes, console.messages)?.let { refuse(it) }
        }
    }

    /** Title and assignments of the course or assignment [name], as pupils get them. */
    private fun partOf(name: String): Pair<String, List<Project>> {
        if (isCourse(name)) {
            val course = courseOf(name, console) ?: throw ProgramResult(ExitCode.BAD_INPUT.status)
            return course.title to pupilCopy(course).assignments
        }
        val project = projectOf(name, console) ?: throw ProgramResult(ExitCode.BAD_INPUT.status)
        if (project.assignment == null) refuse(console.messages.notAnAssignment(name))
        return project.world.title to listOf(pupilCopy(project))
    }

    private fun refuse(words: String): Nothing {
        console.complain(words)
        throw ProgramResult(ExitCode.BAD_INPUT.status)
    }
}
