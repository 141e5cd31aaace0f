package robotran.nqc

import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.legofirmware.image.FirmwareLimits
import robotran.nqc.api.Prelude
import robotran.nqc.api.apiNames
import robotran.nqc.check.CallCheck
import robotran.nqc.check.ProgramCheck
import robotran.nqc.diagnostic.API_RANGE
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.generate.GeneratedProgram
import robotran.nqc.generate.ProgramGenerator
import robotran.nqc.generate.SensorUse
import robotran.nqc.parse.ProgramParser
import robotran.nqc.preprocess.Pragmas
import robotran.nqc.preprocess.Preprocessor
import robotran.nqc.syntax.SourceLines
import robotran.nqc.syntax.Token
import robotran.nqc.tree.ParsedProgram
import robotran.nqc.tree.Statement

/**
 * The phases of compiling the program whose main file is [name]. As many of them as possible look for errors, so that
 * the pupil sees all at once.
 */
internal class Compilation(
    private val name: String,
    private val files: Map<String, String>,
    private val options: NqcOptions,
    private val sink: DiagnosticSink,
) {
    private val target = options.target
    private val apiNames = apiNames(target, options.isOld)
    private val prelude = Prelude.of(target, options.isOld)

    /** The program; null if it has errors. */
    fun compile(): NqcProgram? {
        val preprocessed = Preprocessor(files, prelude.macros, sink).read(name)
        // A file that includes itself would declare everything twice.
        if (sink.has(NqcDiagnosticCode.TOO_MANY_INCLUDES)) return null
        // Where text is missing, what it declares seems to be missing, too.
        val isComplete = sink.hasOnly(NqcDiagnosticCode.UNKNOWN_CHARACTER)
        val parser = ProgramParser(
            preprocessed.tokens,
            sink,
            target,
            preprocessed.macros.keys,
            prelude.functions,
            apiNames,
            textAt = SourceLines(files)::textAt,
        )
        val program = parser.program()
        if (!isComplete) return null
        val isRead = !sink.hasErrors
        ProgramCheck(program, parser.declared, sink).check(endOf(preprocessed.tokens), preprocessed.pragmas.init)
        val start = start(program, preprocessed.pragmas)
        val calls = CallCheck(program, parser.declared, start, apiNames, preprocessed.macros.keys, sink)
        val subsOfTasks = calls.subsOfTasks()
        calls.checkSubs()
        // Calls of nothing are left out of the code, which nobody gets then.
        if (!isRead || !sink.hasOnly(NqcDiagnosticCode.UNDEFINED_FUNCTION)) return null
        val generated = generate(program, start, preprocessed.pragmas, subsOfTasks)
        if (!sink.hasErrors) {
            checkMemory(program, generated)
            generated.unsetSensors.forEach { warnOfSensor(program, it) }
        }
        return NqcProgram(name, generated.image, generated.lines, generated.variables)
    }

    private fun endOf(tokens: List<Token>) =
        tokens.last().range.takeIf { it.file == name } ?: SourceRange(1, 1, 1, name)

    /** The call of what runs before the main task; null if there is none. */
    private fun start(program: ParsedProgram, pragmas: Pragmas): Statement? {
        val init = pragmas.init
        val main = program.tasks.find { it.name == MAIN }?.range ?: API_RANGE
        return when {
            !pragmas.hasInit -> null
            init != null -> Statement.Call(init.name, emptyList(), init.range, init.range, false)
            options.isOld -> null
            else -> Statement.Call(Prelude.INIT_NAME, emptyList(), main, main, false)
        }
    }

    /** Generates code as the original compiler does; if variables do not fit so, with fewer of them. */
    private fun generate(
        program: ParsedProgram,
        start: Statement?,
        pragmas: Pragmas,
        subsOfTasks: Map<String, Set<String>>,
    ): GeneratedProgram {
        val trial = DiagnosticSink(sink.messages)
        val first = ProgramGenerator(program, start, pragmas.reserved, subsOfTasks, target, trial, false).generate()
        if (!first.isOutOfVariables) {
            sink.add(trial)
            return first
        }
        return ProgramGenerator(program, start, pragmas.reserved, subsOfTasks, target, sink, true).generate()
    }

    private fun warnOfSensor(program: ParsedProgram, comparison: SensorUse.Comparison) {
        val isKnown = apiNames.callOf(SET_SENSOR) != null
        if (!isKnown || comparison.range.line == 0 || comparison.port !in 0..2) return
        val port = comparison.port + 1
        val call = "$SET_SENSOR(SENSOR_$port, ${if (comparison.isTouch) "SENSOR_TOUCH" else "SENSOR_LIGHT"})"
        val brace = program.tasks.first { it.name == MAIN }.body.range
        val fix = SourceFix(brace.end, "\n    $call;").takeIf {
            comparison.isTouch &&
                brace.file == comparison.range.file
        }
        val message = sink.messages.sensorNotSet(port, call)
        sink.report(NqcDiagnosticCode.SENSOR_NOT_SET, comparison.range, message, fix)
    }

    private fun checkMemory(program: ParsedProgram, generated: GeneratedProgram) {
        val limit = FirmwareLimits.PROGRAM_MEMORY
        val size = generated.image.codeSize
        if (size <= limit) return
        val range = program.tasks.first { it.name == MAIN }.range
        sink.report(NqcDiagnosticCode.MEMORY_FULL, range, sink.messages.memoryFull(size, limit))
    }

    private companion object {
        const val MAIN = "main"
        const val SET_SENSOR = "SetSensor"
    }
}
