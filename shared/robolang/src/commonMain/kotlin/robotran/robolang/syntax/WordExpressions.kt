package robotran.robolang.syntax

import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink

private val BUTTONS = mapOf(
    Keyword.RUN to BrickButton.RUN,
    Keyword.VIEW to BrickButton.VIEW,
    Keyword.PRGM to BrickButton.PRGM,
)

/** Parses expressions that begin with a keyword: truth values and sensors. Returns null once an error was reported. */
internal fun readWordExpression(reader: LineReader, diagnostics: DiagnosticSink): Expression? {
    val first = checkNotNull(reader.next)
    reader.advance()
    val sense = when (first.keyword) {
        Keyword.TRUE -> return Expression.BooleanLiteral(first.range, true)
        Keyword.FALSE -> return Expression.BooleanLiteral(first.range, false)
        Keyword.LEFT -> bumper(reader, diagnostics, first, Sense.LeftBumper)
        Keyword.RIGHT -> bumper(reader, diagnostics, first, Sense.RightBumper)
        Keyword.LIGHT -> Sense.Light
        Keyword.SENSOR -> readPort(reader, diagnostics)?.let { Sense.Sensor(it) }
        Keyword.BUTTON -> button(reader, diagnostics)
        Keyword.TIMER -> Sense.Timer
        Keyword.BATTERY -> Sense.Battery
        else -> error("No expression begins with ${first.text}.")
    }
    return sense?.let { Expression.Sense(reader.rangeFrom(first.range), it) }
}

private fun bumper(reader: LineReader, diagnostics: DiagnosticSink, side: Token, sense: Sense): Sense? {
    if (reader.take(Keyword.BUMPER) != null) return sense
    diagnostics.reportMissingWord(reader, DiagnosticCode.MISSING_WORD, listOf(Keyword.BUMPER.text)) {
        diagnostics.messages.missingWord(side.text, Keyword.BUMPER.text, it)
    }
    return null
}

private fun button(reader: LineReader, diagnostics: DiagnosticSink): Sense? {
    val button = BUTTONS[reader.next?.keyword]
    if (button != null) {
        reader.advance()
        return Sense.Button(button)
    }
    diagnostics.reportMissingWord(
        reader,
        DiagnosticCode.MISSING_BUTTON,
        BUTTONS.keys.map {
            it.text
        },
        diagnostics.messages::missingButton,
    )
    return null
}

/** Reads the number of an input, 1..3. */
internal fun readPort(reader: LineReader, diagnostics: DiagnosticSink): Int? {
    val token = reader.take(TokenKind.NUMBER)
    val port = token?.text?.toIntOrNull()?.takeIf { it in RobolangLimits.SENSOR_PORTS }
    if (port == null) {
        val range = (token ?: reader.next)?.range ?: reader.gap
        diagnostics.report(reader, DiagnosticCode.PORT_OUT_OF_RANGE, range, diagnostics.messages.portOutOfRange())
    }
    return port
}
