package robotran.cli.translate

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
import robotran.brick.kind.BrickKind
import robotran.cli.console.brickOption
import robotran.cli.console.buggyOption
import robotran.cli.console.oldNqcOption
import robotran.cli.console.targetOption
import robotran.cli.files.FIRMWARE_ENDINGS
import robotran.cli.files.JAVA
import robotran.cli.files.ProgramFiles
import robotran.cli.files.isNamed
import robotran.cli.files.mayWrite
import robotran.cli.files.readProgramFiles
import robotran.cli.files.writeFile
import robotran.cli.hub.PythonOfFile
import robotran.cli.hub.isBoard
import robotran.cli.hub.isHub
import robotran.cli.hub.pythonBrickOf
import robotran.cli.hub.pythonOf
import robotran.cli.input.RobolangFile
import robotran.cli.input.lineOf
import robotran.cli.input.readRobolangFile
import robotran.cli.legofirmware.FirmwareImageOfFile
import robotran.cli.legofirmware.NqcOfFile
import robotran.cli.legofirmware.firmwareImageOf
import robotran.cli.legofirmware.nqcOf
import robotran.cli.messages.CommandMessages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.speaking
import robotran.legofirmware.listing.assemblyListing
import robotran.programs.FirmwareSettings
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.likelyBrickOf
import robotran.projects.penbotTarget
import robotran.robolang.translate.KitFile
import robotran.robolang.translate.javaKitFiles
import robotran.robolang.translate.kitFiles
import robotran.robolang.translate.translateRobolang
import kotlin.io.path.Path
import kotlin.io.path.name
import robotran.programs.ProgramResult as Reading

/**
 * `robotran translate FILE..`: translates programs to Java, NQC, assembly text or Python, or one to a kit for a real
 * brick.
 */
internal class TranslateCommand(private val console: Console) : CoreCliktCommand("translate") {
    private val programs by argument(
        "FILE",
        help =
            "Robolang programs (.robo), or programs for LEGO's own firmware (.nqc, .lasm, .rcx), which become " +
                "assembly text; for --kit also the files of one program in Java (.java)",
    ).multiple(required = true)
    private val output by option(
        "-o",
        "--output",
        metavar = "FILE",
        help = "where the translation goes; to the console if not given",
    )
    private val kit by option("--kit", metavar = "FILE", help = "writes a kit for a real brick (.zip)")

    private val language by option(
        "--to",
        metavar = TargetLanguage.entries.joinToString("|") { it.word },
        help =
            "what the programs become: java for leJOS (of Robolang, if not given), nqc for LEGO's own firmware, " +
                "lasm, its assembly text (of other programs, if not given), or python for a hub with Pybricks or a " +
                "micro:bit (if --brick or the program names one)",
    ).convert { text ->
        TargetLanguage.of(text)
            ?: fail("$text is none of ${TargetLanguage.entries.joinToString { it.word }}")
    }
    private val target by targetOption()
    private val oldNqc by oldNqcOption()
    private val brick by brickOption()
    private val buggy by buggyOption()
    private val spoken by LanguageOption()
    private val sentences get() = CommandMessages.of(spoken.language)

    override fun help(context: Context) =
        "Writes programs in another language: Java for leJOS or leJOS NXJ, NQC, the assembly text of LEGO's " +
            "firmware, or Python for a hub with Pybricks or a micro:bit."

    override fun run() {
        if (!mayWrite(programs, listOf(output, kit), console.speaking(spoken.language))) {
            throw ProgramResult(ExitCode.BAD_INPUT.status)
        }
        val javaKit = kit.takeIf {
            output == null && brick?.isHub != true && brick?.isBoard != true &&
                programs.all { isNamed(it, JAVA) }
        }
        if (javaKit != null) throw ProgramResult(writeJavaKit(javaKit).status)
        if (programs.size > 1 && (output != null || kit != null)) {
            throw UsageError("-o and --kit take one program at a time")
        }
        if (kit != null && targetOf(programs.single()) != TargetLanguage.JAVA) {
            throw UsageError("--kit goes with Java only")
        }
        if (programs.any { (pythonBrickOf(it) != null) != (targetOf(it) == TargetLanguage.PYTHON) }) {
            throw UsageError("--to python and a hub, such as --brick spike-prime or microbit, go together")
        }
        if (buggy != null && programs.any { pythonBrickOf(it)?.isBoard != true }) {
            throw UsageError("--buggy goes with --brick microbit or microbit-v1")
        }
        throw ProgramResult(programs.maxOf { translate(it).status })
    }

    private fun writeJavaKit(kit: String): ExitCode {
        val files =
            when (val read = readProgramFiles(programs, sentences)) {
                is ProgramFiles.Success -> read.programs.single().also { read.notes.forEach(console::complain) }
                is ProgramFiles.Failure -> return refuse(read.reason)
            }
        val kind = brick ?: likelyBrickOf(files.source) ?: BrickKind.default
        val compiler = ProgramCompiler(kind.penbotTarget, language = spoken.language)
        return when (val result = runBlocking { compiler.compileOrThrow(files.source) }) {
            is Reading.Failure -> {
                result.diagnostics.forEach { console.complain(lineOf(files, it)) }
                ExitCode.PROGRAM_FAILED
            }

            is Reading.Success -> {
                val sources = (files.source as Program).files.map { KitFile(it.name, it.text) }
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

    private fun pythonBrickOf(program: String): BrickKind? = pythonBrickOf(listOf(program), brick, spoken.language)

    private fun targetOf(program: String): TargetLanguage = language ?: when {
        pythonBrickOf(program) != null -> TargetLanguage.PYTHON
        FIRMWARE_ENDINGS.any { isNamed(program, it) } -> TargetLanguage.LASM
        else -> TargetLanguage.JAVA
    }

    private fun translate(program: String): ExitCode = when (targetOf(program)) {
        TargetLanguage.JAVA -> translateToJava(program)
        TargetLanguage.NQC -> translateToNqc(program)
        TargetLanguage.LASM -> translateToLasm(program)
        TargetLanguage.PYTHON -> translateToPython(program, checkNotNull(pythonBrickOf(program)))
    }

    private fun translateToPython(program: String, hub: BrickKind): ExitCode =
        when (val python = pythonOf(program, hub, spoken.language, buggy)) {
            is PythonOfFile.Failure -> refuse(python.lines, python.code)

            is PythonOfFile.Success -> {
                (python.lost + python.changed).forEach(console::complain)
                val written = write(python.translation.python)
                if (python.lost.isEmpty()) written else maxOf(written, ExitCode.PROGRAM_FAILED)
            }
        }

    private fun translateToNqc(program: String): ExitCode = when (val nqc = nqcOf(program, spoken.language)) {
        is NqcOfFile.Failure -> refuse(nqc.lines, nqc.code)

        is NqcOfFile.Success -> {
            (nqc.lost + nqc.changed).forEach(console::complain)
            val written = write(nqc.text)
            if (nqc.lost.isEmpty()) written else maxOf(written, ExitCode.PROGRAM_FAILED)
        }
    }

    private fun translateToLasm(program: String): ExitCode =
        when (val built = firmwareImageOf(program, FirmwareSettings(target, oldNqc), spoken.language)) {
            is FirmwareImageOfFile.Failure -> refuse(built.lines, built.code)

            is FirmwareImageOfFile.Success -> {
                built.warnings.forEach(console::complain)
                write(built.image.assemblyListing().text)
            }
        }

    private fun refuse(lines: List<String>, code: ExitCode): ExitCode {
        lines.forEach(console::complain)
        return code
    }

    private fun write(text: String): ExitCode {
        val problem = output?.let { writeFile(it, text.encodeToByteArray(), sentences) }
        if (output == null) console.say(text.trimEnd('\n'))
        return if (problem == null) ExitCode.DONE else refuse(problem)
    }

    private fun translateToJava(program: String): ExitCode = when (
        val file = readRobolangFile(program, spoken.language, brick)
    ) {
        is RobolangFile.Ready -> {
            file.notes.forEach(console::complain)
            write(program, file)
        }

        is RobolangFile.HasErrors -> {
            file.notes.forEach(console::complain)
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
