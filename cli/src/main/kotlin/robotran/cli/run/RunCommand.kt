package robotran.cli.run

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import robotran.brick.log.CallGroup
import robotran.cli.console.DesktopApp
import robotran.cli.console.messages
import robotran.cli.files.mayWrite
import robotran.cli.input.WorldChanges
import robotran.cli.input.readSeed
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking
import robotran.world.World
import com.github.ajalt.clikt.parameters.arguments.multiple as multipleArguments

/**
 * `robotran run FILE..`: runs programs on the brick without a window and writes the results.
 *
 * @param desktop renders the picture; null if the desktop app is not included.
 */
internal class RunCommand(private val process: Console, private val desktop: DesktopApp?) : CoreCliktCommand("run") {
    private val programs by argument(
        "FILE",
        help =
            "a program: in Robolang (.robo), in Java for leJOS or leJOS NXJ (one or more .java), in NQC (.nqc), in " +
                "the assembly text of LEGO's firmware (.lasm), or compiled (.class, .jar, a folder, .rcx); " +
                "five at most. " +
                "Or a project (.robotran), or a link that holds one; with --world only the programs of its first robot",
    ).multipleArguments(required = true)
    private val world by option(
        "--world",
        metavar = "FILE",
        help =
            "the world to run in (.world.json, or a project or link with it); if not given, a plain sheet with the " +
                "penbot that the programs are for",
    )
    private val seed by option(
        "--seed",
        metavar = "N",
        help = "what is left to chance is drawn from this, instead of the world's seed",
    )
        .convert { text -> readSeed(text) ?: fail("$text is not a whole number from 0 to ${Int.MAX_VALUE}") }
    private val picture by option("--picture", metavar = "FILE", help = "writes a picture of the sheet (.png or .svg)")
    private val presses by option(
        "--press",
        metavar = "BUTTON@SECONDS",
        help =
            "presses view, prgm, run or on-off, on an NXT enter, left, right or escape, at that second and lets go a " +
                "moment later; run@5+0.5 holds it for half a second. " +
                "May be given several times. With it nothing is pressed by itself, not even Run or ENTER.",
    ).convert { text ->
        when (val result = readButtonPress(text, LONGEST_RUN_SECONDS)) {
            is ButtonPressResult.Success -> result.press
            is ButtonPressResult.Failure -> fail(result.reason)
        }
    }.multiple()
    private val callLog by option(
        "--rom-log",
        metavar = "FILE|-",
        help = "writes every ROM call, on an NXT every call of its firmware, one a line; a table if FILE ends in .csv",
    )
    private val romLogOnly by option(
        "--rom-log-only",
        metavar = "GROUPS",
        help = "writes only calls of these groups, with commas between: ${GROUPS.keys.joinToString()}",
    ).convert { text ->
        text.split(',').map { name ->
            GROUPS[name.trim().lowercase()]
                ?: fail("There are no ROM calls of a group $name.")
        }.toSet()
    }
    private val report by option("--report", metavar = "FILE|-", help = "writes the report as JSON")
    private val brickReport by option(
        "--brick-report",
        metavar = "FILE|-",
        help = "writes display, sounds and state of the brick as JSON",
    )
    private val explain by option("--explain", help = "says what has made the robots stray").flag()
    private val memory by option(
        "--memory",
        metavar = "FILE|-",
        help = "writes what is in the memory of an RCX at the end",
    )
    private val options by RunOptions()
    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)

    override fun help(context: Context) =
        "Runs programs on the brick: powered on, the first of them, Run or ENTER pressed."

    override fun run() {
        if (picture != null && desktop == null) {
            console.complain(console.messages.needsDesktopApp())
            throw ProgramResult(ExitCode.BAD_INPUT.status)
        }
        picture?.takeIf { hasOtherEnding(it) }?.let { name ->
            console.complain(console.messages.notAPicture(name, PICTURE_ENDINGS))
            throw ProgramResult(ExitCode.BAD_INPUT.status)
        }
        conflictIn(presses, options.milliseconds ?: DEFAULT_RUN_MILLISECONDS)?.let { throw UsageError(it) }
        val outputs = RunOutputs(picture, callLog, romLogOnly, report, brickReport, memory, explain)
        val request = RunRequest(
            programs,
            options.robots,
            options.robotFiles,
            options.java,
            options.firmware,
            world,
            WorldChanges(seed, options.realism),
            options.milliseconds,
            presses,
        )
        if (!mayWrite(request.inputs, outputs.names, console)) throw ProgramResult(ExitCode.BAD_INPUT.status)
        throw ProgramResult(ProgramRunner(console, desktop).run(request, outputs).status)
    }

    private companion object {
        const val DEFAULT_RUN_MILLISECONDS = World.DEFAULT_TIME_LIMIT * 1000

        val PICTURE_ENDINGS = listOf(".png", ".svg")

        /** Without an ending, a picture is a PNG. */
        fun hasOtherEnding(name: String): Boolean {
            val file = name.substringAfterLast('/').substringAfterLast('\\')
            return '.' in file.drop(1) && PICTURE_ENDINGS.none { file.endsWith(it, ignoreCase = true) }
        }

        val GROUPS = CallGroup.entries.associateBy(::groupName)
    }
}

/**
 * The outputs of a run: file names, - for the console, null for none.
 *
 * @property romLogGroups the groups of the ROM log to write; null for all.
 * @property explains whether to print why the robots deviated from their ideal path.
 */
internal class RunOutputs(
    val picture: String?,
    val callLog: String?,
    val romLogGroups: Set<CallGroup>?,
    val report: String?,
    val brickReport: String?,
    val memory: String?,
    val explains: Boolean,
) {
    val names: List<String?> get() = listOf(picture, callLog, report, brickReport, memory)
}
