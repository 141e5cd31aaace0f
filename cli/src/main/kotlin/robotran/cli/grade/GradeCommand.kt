package robotran.cli.grade

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import robotran.cli.console.DesktopApp
import robotran.cli.files.ON_CONSOLE
import robotran.cli.files.mayWrite
import robotran.cli.input.MAX_SEEDS
import robotran.cli.input.readSeeds
import robotran.cli.run.RunOptions
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking
import com.github.ajalt.clikt.parameters.arguments.multiple as multipleArguments

/** `robotran grade ASSIGNMENT HAND-IN..`: runs what pupils handed in and reports whether it meets the goals. */
internal class GradeCommand(private val console: Console, private val desktop: DesktopApp?) :
    CoreCliktCommand("grade") {
    private val world by argument(
        "ASSIGNMENT",
        help = "an assignment (.robotran), a course (.course.json, its folder or a link), or a world with goals " +
            "(.world.json, or a project or link with it)",
    )
    private val programs by argument(
        "HAND-IN",
        help =
            "a program, graded by itself: a file in Robolang (.robo), leJOS Java (.java), NQC (.nqc), assembly " +
                "text (.lasm) or an image (.rcx), a jar, a folder with the files of one Java program, or a project " +
                "or hand-in (.robotran) or link, of which the programs of " +
                "the first robot count; or many: a folder or zip with submissions, also of a learning platform, or " +
                "a text with links",
    ).multipleArguments(required = true)
    private val seeds by option(
        "--seeds",
        metavar = "A..B",
        help = "runs once with each of these seeds; with the world's own if not given",
    )
        .convert { text ->
            readSeeds(text)
                ?: fail("$text is not two whole numbers such as 1..20, from 0 on and $MAX_SEEDS seeds at most")
        }
    private val jobs by option(
        "--jobs",
        metavar = "N",
        help = "how many runs at the same time; as many as there are processors if not given",
    )
        .convert { text ->
            text.toIntOrNull()?.takeIf { it in 1..MAX_JOBS }
                ?: fail("$text is not a whole number from 1 to $MAX_JOBS")
        }
        .default(Runtime.getRuntime().availableProcessors().coerceIn(1, MAX_JOBS))
    private val junit by option("--junit", metavar = "FILE|-", help = "writes the grades as JUnit's XML")
    private val report by option("--report", metavar = "FILE|-", help = "writes the grades as JSON")
    private val csv by option("--csv", metavar = "FILE|-", help = "writes a table for a spreadsheet, a row a hand-in")
    private val html by option(
        "--html",
        metavar = "FILE",
        help = "writes a page to read and print, with a picture of each sheet if the desktop app is there",
    )
    private val feedback by option(
        "--feedback",
        metavar = "FILE",
        help = "writes a zip with a file for each pupil, in the folders of the learning platform",
    )
    private val options by RunOptions()
    private val spoken by LanguageOption()

    override fun help(context: Context) = "Grades programs and hand-ins by the goals of an assignment or a world."

    override fun helpEpilog(context: Context) =
        "Exit status: 0 if every program met all goals with every seed; 1 if not; 2 if something given cannot be " +
            "used, or a program has " +
            "mistakes."

    override fun run() {
        val request =
            GradeRequest(world, programs, seeds, jobs, options, GradeOutputs(junit, report, csv, html, feedback))
        if (!mayWrite(request.inputs, request.outputs.names, console.speaking(spoken.language))) {
            throw ProgramResult(ExitCode.BAD_INPUT.status)
        }
        throw ProgramResult(ProgramGrader(console.speaking(spoken.language), desktop).run(request).status)
    }

    private companion object {
        const val MAX_JOBS = 256
    }
}

/**
 * What to grade.
 *
 * @property world that of the assignment, as the user entered it.
 * @property programs or hand-ins, as the user entered them.
 * @property seeds null for those of the assignment, or the world's own seed.
 */
internal class GradeRequest(
    val world: String,
    val programs: List<String>,
    val seeds: IntRange?,
    val jobs: Int,
    val options: RunOptions,
    val outputs: GradeOutputs,
) {
    /** What it reads, as the user entered it. */
    val inputs: List<String>
        get() = programs + world + (options.robots + options.robotFiles).map { it.file }
}

/** What to write: file names, - for the console, null for none. */
internal class GradeOutputs(
    val junit: String?,
    val report: String?,
    val csv: String?,
    val html: String?,
    val feedback: String? = null,
) {
    val names: List<String?> get() = listOf(junit, report, csv, html, feedback)

    /** Whether one of them replaces the table on the console. */
    val useConsole: Boolean get() = ON_CONSOLE in listOf(junit, report, csv)
}
