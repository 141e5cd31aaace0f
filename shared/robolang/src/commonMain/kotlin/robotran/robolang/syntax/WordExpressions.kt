package robotran.robolang.syntax

import robotran.brick.controls.MotorPort
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.BrickFeature
import robotran.robolang.words.Keyword

private val BUTTONS = BrickButton.entries.associateBy { it.keyword }

private val COLOURS = PaintColour.entries.associateBy { it.keyword }

/** Parses expressions that begin with a keyword: truth values and sensors. Returns null once an error was reported. */
internal fun readWordExpression(reader: LineReader, diagnostics: DiagnosticSink): Expression? {
    val first = checkNotNull(reader.next)
    reader.advance()
    COLOURS[first.keyword]?.let { return Expression.ColourLiteral(first.range, it) }
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
        Keyword.DISTANCE -> Sense.Distance
        Keyword.LOUDNESS -> Sense.Loudness
        Keyword.COLOUR -> Sense.Colour
        Keyword.TURNED -> readMotor(reader, diagnostics)?.let { Sense.Turned(it) }
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
    val hasEnter = BrickFeature.ENTER_BUTTON.isOn(diagnostics.brick)
    diagnostics.reportMissingWord(
        reader,
        DiagnosticCode.MISSING_BUTTON,
        BrickButton.of(diagnostics.brick).map { it.keyword.text },
        if (hasEnter) diagnostics.messages::missingNxtButton else diagnostics.messages::missingButton,
    )
    return null
}

/** Reads the letter of a motor. */
internal fun readMotor(reader: LineReader, diagnostics: DiagnosticSink): MotorPort? {
    val letter = reader.next?.text?.uppercase()
    val port = diagnostics.brick.motorPorts.firstOrNull { it.name == letter }
    if (port == null) {
        val range = reader.next?.range ?: reader.gap
        val letters = diagnostics.brick.motorPorts.map { it.name }
        val message = diagnostics.messages.missingMotor(letters.dropLast(1).joinToString(), letters.last())
        diagnostics.report(reader, DiagnosticCode.MISSING_MOTOR, range, message)
    } else {
        reader.advance()
    }
    return port
}

/** Reads the number of an input, 1..4 or as many as the brick has. The checker refuses those that the brick does not have. */
internal fun readPort(reader: LineReader, diagnostics: DiagnosticSink): Int? {
    val token = reader.take(TokenKind.NUMBER)
    val port = token?.text?.toIntOrNull()?.takeIf { it in 1..maxOf(MOST_PRINTED, diagnostics.brick.inputPorts) }
    if (port == null) {
        val range = (token ?: reader.next)?.range ?: reader.gap
        diagnostics.report(
            reader,
            DiagnosticCode.PORT_OUT_OF_RANGE,
            range,
            diagnostics.messages.portOutOfRange(diagnostics.brick.inputPorts),
        )
    }
    return port
}

/** The highest number beside an input of an RCX, an NXT or an EV3. */
private const val MOST_PRINTED = 4
