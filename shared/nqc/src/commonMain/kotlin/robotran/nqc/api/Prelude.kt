package robotran.nqc.api

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.diagnostic.Severity
import robotran.nqc.diagnostic.SourceRange
import robotran.nqc.messages.NqcMessages
import robotran.nqc.parse.ProgramParser
import robotran.nqc.preprocess.Macro
import robotran.nqc.preprocess.Preprocessor
import robotran.nqc.syntax.Lexer
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.FunctionUnit

/**
 * The API as the compiler sees it.
 *
 * @property macros values and constants.
 * @property functions functions, whose places are [SourceRange.API].
 */
internal class Prelude private constructor(target: FirmwareTarget, isOld: Boolean) {
    private val entries = NqcApi.of(target, isOld)

    /** What the parameters of functions are expected to be. */
    private val limits = entries.mapValues { (it.value.definition as? ApiDefinition.Function)?.limits.orEmpty() }

    val macros: Map<String, Macro> = entries.values.mapNotNull { entry ->
        (entry.definition as? ApiDefinition.Text)?.let { Macro(entry.name, entry.parameters, tokensOf(it.text)) }
    }.associateBy { it.name } + marks(target, isOld).mapValues { Macro(it.key, null, tokensOf(it.value)) }

    val functions: Map<String, FunctionUnit>

    init {
        val sink = DiagnosticSink(NqcMessages.of(Language.ENGLISH))
        val names = apiNames(target, isOld)
        val text = entries.values.mapNotNull { functionOf(it, target) }.joinToString("\n") + if (isOld) "" else INIT
        val tokens = Preprocessor(mapOf(FILE to text), macros, sink).read(FILE).tokens.map(::ofApi)
        functions = ProgramParser(tokens, sink, target, emptySet(), emptyMap(), names, { limits[it].orEmpty() })
            .program(isApi = true).functions
        check(!sink.hasErrors) { "The API has mistakes: ${sink.inSourceOrder(ERROR, FILE)}" }
    }

    private fun functionOf(entry: NqcApiEntry, target: FirmwareTarget): String? {
        val function = entry.definition as? ApiDefinition.Function ?: return null
        val isFirst = target == FirmwareTarget.RCX
        val body = function.body.replace(
            "{basic}",
            if (isFirst) BASIC else ALL,
        ).replace("{random}", if (isFirst) RANDOM else ALL)
        return "void ${entry.name}(${function.declaration}) { $body }"
    }

    private fun tokensOf(text: String): List<Token> {
        val lexer = Lexer(FILE, text, DiagnosticSink(NqcMessages.of(Language.ENGLISH)))
        return generateSequence { lexer.next() }.takeWhile { it.kind != TokenKind.END }.map(::ofApi).toList()
    }

    private fun ofApi(token: Token) = token.copy(range = SourceRange.API, macro = null)

    companion object {
        /** The function that runs before the main task unless a program says otherwise: full power, forwards. */
        const val INIT_NAME = "_init"

        private const val FILE = ""
        private const val INIT = "\nvoid $INIT_NAME() { SetPower(OUT_ABC, OUT_FULL); Fwd(OUT_ABC); }"
        private val ERROR = Severity.ERROR

        /** The sources that commands of firmware 1.0 take, as bits; see `AssemblyField`. */
        private const val BASIC = "0x5"
        private const val RANDOM = "0x15"
        private const val ALL = "0"

        /** Version 4.1 of NQC. */
        private const val VERSION = "401"

        private fun marks(target: FirmwareTarget, isOld: Boolean): Map<String, String> {
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
