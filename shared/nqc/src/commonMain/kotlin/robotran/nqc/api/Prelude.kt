package robotran.nqc.api

import robotran.language.Language
import robotran.language.source.Severity
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.diagnostic.API_RANGE
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.messages.NqcMessages
import robotran.nqc.parse.ApiNames
import robotran.nqc.parse.ProgramParser
import robotran.nqc.preprocess.Macro
import robotran.nqc.preprocess.Preprocessor
import robotran.nqc.syntax.Lexer
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.FunctionUnit

/**
 * The API as the compiler sees it: its header, read for one target.
 *
 * @property macros values and constants.
 * @property functions functions, whose places are [API_RANGE].
 */
internal class Prelude private constructor(target: FirmwareTarget, isOld: Boolean) {
    private val header = ApiHeader(isOld)
    private val sink = DiagnosticSink(NqcMessages.of(Language.ENGLISH))

    val macros: Map<String, Macro> =
        macros(marksOf(target, isOld).mapValues { Macro(it.key, null, tokensOf(it.value)) })

    val functions: Map<String, FunctionUnit> = functions(target)

    /** What programs can use, by name. */
    val entries: Map<String, NqcApiEntry> = header.docs.mapNotNull { (name, doc) -> entryOf(name, doc) }
        .associateBy { it.name }

    init {
        check(!sink.hasErrors) { "The API has mistakes: ${sink.inSourceOrder(Severity.ERROR, FILE)}" }
    }

    private fun macros(marks: Map<String, Macro>): Map<String, Macro> {
        val defined = read(header.text, marks).macros
        return header.docs.keys.mapNotNull { defined[it] }.associate { macro ->
            macro.name to Macro(macro.name, macro.parameters, macro.body.map(::ofApi))
        } + marks
    }

    /** Functions use macros that the header defines below them, so these are known before. */
    private fun functions(target: FirmwareTarget): Map<String, FunctionUnit> {
        val tokens = read(header.functions, macros).tokens.map(::ofApi)
        val names = ApiNames({ false }, { null })
        val limitOf = { function: String, parameter: String -> header.docs[function]?.limitOf(parameter) }
        return ProgramParser(tokens, sink, target, emptySet(), emptyMap(), names, limitOf)
            .program(isApi = true).functions
    }

    private fun read(text: String, macros: Map<String, Macro>) =
        Preprocessor(mapOf(FILE to text), macros, sink).read(FILE)

    /** Null if the target does not have it. */
    private fun entryOf(name: String, doc: ApiDoc): NqcApiEntry? {
        val function = functions[name]
        if (function != null) {
            return NqcApiEntry(name, NqcApiKind.FUNCTION, function.parameters.map { it.name }, function, doc)
        }
        val macro = macros[name] ?: return null
        val isNumber = macro.parameters == null && macro.body.singleOrNull()?.kind == TokenKind.NUMBER
        return NqcApiEntry(name, if (isNumber) NqcApiKind.CONSTANT else NqcApiKind.VALUE, macro.parameters, null, doc)
    }

    private fun tokensOf(text: String): List<Token> {
        val lexer = Lexer(FILE, text, sink)
        return generateSequence { lexer.next() }.takeWhile { it.kind != TokenKind.END }.map(::ofApi).toList()
    }

    private fun ofApi(token: Token) = token.copy(range = API_RANGE, macro = null)

    companion object {
        /** The function that runs before the main task unless a program says otherwise: full power, forwards. */
        const val INIT_NAME = "_init"

        private const val FILE = ""

        /** The sources that commands of firmware 1.0 take, as bits; see `AssemblyField`. */
        private const val BASIC = "0x5"
        private const val RANDOM = "0x15"
        private const val ALL = "0"

        /** Version 4.1 of NQC. */
        private const val VERSION = "401"

        private fun marksOf(target: FirmwareTarget, isOld: Boolean): Map<String, String> {
            val isFirst = target == FirmwareTarget.RCX
            val marks = mapOf(
                "__RCX" to if (isFirst) "1" else "2",
                "__NQC__" to VERSION,
                "__ASM_SMALL_VALUE" to "0x1000000",
                "__ASM_NO_TYPE" to "0x2000000",
                "__ASM_NO_LOCAL" to "0x4000000",
                "__ASM_SRC_BASIC" to if (isFirst) BASIC else ALL,
                "__ASM_SRC_EXT" to if (isFirst) RANDOM else ALL,
            )
            return if (isOld) marks + ("__NQC1" to "1") else marks
        }

        private val preludes = listOf(false, true).flatMap { isOld -> FirmwareTarget.entries.map { it to isOld } }
            .associateWith { (target, isOld) -> lazy { Prelude(target, isOld) } }

        /** @param isOld whether the API is that of NQC 1.3. */
        fun of(target: FirmwareTarget, isOld: Boolean): Prelude = preludes.getValue(target to isOld).value
    }
}
