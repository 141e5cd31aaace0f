package robotran.cli.translate

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.UsageError
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.option
import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.cli.console.Console
import robotran.cli.console.ExitCode
import robotran.cli.console.LanguageOption
import robotran.cli.console.brickOption
import robotran.cli.files.JAVA
import robotran.cli.files.ProgramFiles
import robotran.cli.files.readProgramFiles
import robotran.cli.files.writeFile
import robotran.cli.input.RobolangFile
import robotran.cli.input.lineOf
import robotran.cli.input.readRobolangFile
import robotran.cli.messages.CommandMessages
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramSource
import robotran.programs.likelyBrickOf
import robotran.projects.penbotTarget
import robotran.robolang.translate.KitFile
import robotran.robolang.translate.javaKitFiles
import robotran.robolang.translate.kitFiles
import robotran.robolang.translate.translateRobolang
import kotlin.io.path.Path
import kotlin.io.path.name
import robotran.programs.ProgramResult as Reading

/** `robotran translate FILE..`: translates programs to Java for leJOS, or one to a kit for a real brick. */
internal class TranslateCommand(private val console: Console) : CoreCliktCommand("translate") {
    private val programs by argument(
        "FILE",
        help = "Robolang programs (.robo); for --kit also the files of one program in Java (.java)",
    ).multiple(required = true)
    private val output by option(
        "-o",
        "--output",
        metavar = "FILE",
        help = "where the Java goes; to the console if not given",
    )
    private val kit by option("--kit", metavar = "FILE", help = "writes a kit for a real brick (.zip)")

    private val brick by brickOption()
    private val spoken by LanguageOption()
    private val sentences get() = CommandMessages.of(spoken.language)

    override fun help(context: Context) = "Writes programs as Java for leJOS, or for an NXT with leJOS NXJ."

    override fun run() {
        val javaKit = kit.takeIf { output == null && programs.all { it.endsWith(JAVA) } }
        if (javaKit != null) throw ProgramResult(writeJavaKit(javaKit).status)
        if (programs.size > 1 && (output != null || kit != null)) {
            throw UsageError("-o and --kit take one program at a time")
        }
        throw ProgramResult(programs.maxOf { translate(it).status })
    }

    private fun writeJavaKit(kit: String): ExitCode {
        val files =
            when (val read = readProgramFiles(programs, sentences)) {
                is ProgramFiles.Read -> read.programs.single()
                is ProgramFiles.Rejected -> return refuse(read.reason)
            }
        val kind = brick ?: likelyBrickOf(files.source) ?: BrickKind.RCX
        val reader = ProgramCompiler(kind.penbotTarget, language = spoken.language)
        return when (val result = runBlocking { reader.read(files.source) }) {
            is Reading.HasErrors -> {
                result.diagnostics.forEach { console.complain(lineOf(files, it)) }
                ExitCode.PROGRAM_FAILED
            }

            is Reading.Ready -> {
                val sources = (files.source as ProgramSource.Java).files.map { KitFile(it.name, it.text) }
                writeFile(
                    kit,
                    zip(javaKitFiles(checkNotNull(result.mainClass), sources, kind)),
                    sentences,
                )?.let(::refuse)
                    ?: ExitCode.DONE
            }
        }
    }

    private fun refuse(reason: String): ExitCode {
        console.complain(reason)
        return ExitCode.BAD_INPUT
    }

    private fun translate(program: String): ExitCode = when (
        val file = readRobolangFile(program, spoken.language, brick)
    ) {
        is RobolangFile.Ready -> {
            write(program, file)
        }

        is RobolangFile.HasErrors -> {
            file.diagnostics.forEach { console.complain(lineOf(program, it)) }
            ExitCode.PROGRAM_FAILED
        }

        is RobolangFile.Unreadable -> {
            refuse(file.reason)
        }
    }

    private fun write(program: String, file: RobolangFile.Ready): ExitCode {
        val translation = translateRobolang(file.program)
        val problems =
            listOfNotNull(
                output?.let { writeFile(it, translation.java.encodeToByteArray(), sentences) },
                kit?.let { writeFile(it, zip(kitFiles(translation, Path(program).name, file.source)), sentences) },
            )
        problems.forEach(console::complain)
        if (output == null && kit == null) console.say(translation.java.trimEnd('\n'))
        return if (problems.isEmpty()) ExitCode.DONE else ExitCode.BAD_INPUT
    }
}
