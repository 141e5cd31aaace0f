package robotran.robolang.syntax

import robotran.brick.controls.MotorPort
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.BrickFeature
import robotran.robolang.words.DIRECTIONS
import robotran.robolang.words.Keyword
import robotran.robolang.words.MOTOR_COMMANDS
import robotran.robolang.words.PEN_POSITIONS
import robotran.robolang.words.SIDES
import robotran.robolang.words.lowercaseKeyword

/** Parses a command to the robot or the brick. */
internal class CommandParser(reader: LineReader, diagnostics: DiagnosticSink) : LineParser(reader, diagnostics) {
    /** Null if the line is not such a command or has an error. */
    fun command(): Command? = when (reader.next?.keyword) {
        Keyword.FORWARD, Keyword.BACKWARD -> move()
        Keyword.TURN -> turn()
        Keyword.START -> start()
        Keyword.STOP -> single(Command::StopDriving)
        Keyword.POWER -> power()
        Keyword.MOTOR -> motor()
        Keyword.PEN -> pen()
        Keyword.WAIT -> wait()
        Keyword.RESET -> reset()
        Keyword.BEEP -> single(Command::Beep)
        Keyword.BUZZ -> single(Command::Buzz)
        Keyword.PLAY -> play()
        Keyword.SHOW -> show()
        Keyword.CLEAR -> clear()
        else -> null
    }

    private fun single(command: (range: SourceRange) -> Command): Command {
        reader.advance()
        return command(reader.readRange)
    }

    private fun move(): Command? {
        val direction = moveDirection() ?: return null
        if (reader.next?.keyword == Keyword.FOR) {
            val duration = seconds() ?: return null
            return Command.Move(reader.readRange, direction, distance = null, duration)
        }
        val distance = number("20") ?: return null
        unit(Keyword.CM)
        return if (isAlsoTimed()) null else Command.Move(reader.readRange, direction, distance, duration = null)
    }

    private fun turn(): Command? {
        reader.advance()
        val direction = turnDirection() ?: return null
        if (reader.next?.keyword == Keyword.FOR) {
            val duration = seconds() ?: return null
            return Command.Turn(reader.readRange, direction, angle = null, duration)
        }
        val angle = number("90") ?: return null
        unit(Keyword.DEGREES)
        return if (isAlsoTimed()) null else Command.Turn(reader.readRange, direction, angle, duration = null)
    }

    private fun moveDirection(): MoveDirection? = when (reader.take(Keyword.FORWARD, Keyword.BACKWARD)) {
        Keyword.FORWARD -> MoveDirection.FORWARD
        Keyword.BACKWARD -> MoveDirection.BACKWARD
        else -> null
    }

    private fun turnDirection(): TurnDirection? = when (reader.take(Keyword.LEFT, Keyword.RIGHT)) {
        Keyword.LEFT -> TurnDirection.LEFT
        Keyword.RIGHT -> TurnDirection.RIGHT

        else -> if (isTurnedRound()) {
            null
        } else {
            missing(
                DiagnosticCode.MISSING_TURN_DIRECTION,
                SIDES,
                messages::missingTurnDirection,
            )
        }
    }

    /** Reports `turn 90 left`, with its fix. */
    private fun isTurnedRound(): Boolean {
        val angle = reader.next?.takeIf { it.kind == TokenKind.NUMBER } ?: return false
        val side = reader.peek(1)?.takeIf { it.keyword in SIDES } ?: return false
        val range = angle.range.copy(endColumn = side.range.endColumn)
        val fix = SourceFix(range, "${lowercaseKeyword(side.text)} ${angle.text}")
        diagnostics.report(
            reader,
            DiagnosticCode.MISSING_TURN_DIRECTION,
            angle.range,
            messages.missingTurnDirection(null),
            fix,
        )
        return true
    }

    private fun unit(unit: Keyword) {
        if (reader.take(unit) == null) diagnostics.reportWrongUnit(reader, listOf(unit))
    }

    private fun isAlsoTimed(): Boolean {
        if (reader.next?.keyword != Keyword.FOR) return false
        diagnostics.report(reader, DiagnosticCode.LENGTH_AND_TIME, reader.restRange, messages.lengthAndTime())
        return true
    }

    private fun start(): Command? {
        reader.advance()
        moveDirection()?.let { return Command.StartMoving(reader.readRange, it) }
        if (reader.take(Keyword.MOTOR) != null) return startMotor()
        if (reader.take(Keyword.TURNING) == null) {
            return missing(DiagnosticCode.MISSING_MOVE, STARTS, messages::missingMove)
        }
        return turnDirection()?.let { Command.StartTurning(reader.readRange, it) }
    }

    /** `start motor A turn 90`. */
    private fun startMotor(): Command? {
        val port = readMotor(reader, diagnostics) ?: return null
        return if (expect(Keyword.TURN)) motorTurn(port, waits = false) else null
    }

    private fun motorTurn(port: MotorPort, waits: Boolean): Command? {
        val angle = number("90") ?: return null
        unit(Keyword.DEGREES)
        return Command.MotorTurn(reader.readRange, port, angle, waits)
    }

    private fun power(): Command? {
        reader.advance()
        val isSided = reader.next?.keyword in SIDES && reader.peek(1)?.keyword != Keyword.BUMPER
        val side = when (if (isSided) reader.take(Keyword.LEFT, Keyword.RIGHT) else null) {
            Keyword.LEFT -> PowerSide.LEFT
            Keyword.RIGHT -> PowerSide.RIGHT
            else -> PowerSide.BOTH
        }
        return number("5")?.let { Command.Power(reader.readRange, side, it) }
    }

    private fun motor(): Command? {
        reader.advance()
        val port = readMotor(reader, diagnostics) ?: return null
        val command = when (reader.take(*OF_MOTOR.toTypedArray())) {
            Keyword.FORWARD -> MotorCommand.Forward
            Keyword.BACKWARD -> MotorCommand.Backward
            Keyword.STOP -> MotorCommand.Stop
            Keyword.FLOAT -> MotorCommand.Float
            Keyword.POWER -> number("5")?.let { MotorCommand.Power(it) } ?: return null

            else -> return if (reader.take(Keyword.TURN) != null) {
                motorTurn(port, waits = true)
            } else {
                missingMotorCommand(port)
            }
        }
        return Command.Motor(reader.readRange, port, command)
    }

    private fun missingMotorCommand(port: MotorPort): Nothing? {
        val canTurn = BrickFeature.MOTOR_COUNTERS.isOn(diagnostics.brick)
        val commands = if (canTurn) OF_MOTOR + Keyword.TURN else OF_MOTOR
        return missing(DiagnosticCode.MISSING_MOTOR_COMMAND, commands) {
            if (canTurn) messages.missingNxtMotorCommand(port.name, it) else messages.missingMotorCommand(port.name, it)
        }
    }

    private fun pen(): Command? {
        reader.advance()
        val position = when (reader.take(Keyword.DOWN, Keyword.UP)) {
            Keyword.DOWN -> PenPosition.DOWN
            Keyword.UP -> PenPosition.UP

            else -> return missing(
                DiagnosticCode.MISSING_PEN_POSITION,
                PEN_POSITIONS,
                messages::missingPenPosition,
            )
        }
        return Command.Pen(reader.readRange, position)
    }

    private fun wait(): Command? {
        reader.advance()
        if (reader.take(Keyword.UNTIL) != null) return condition()?.let { Command.WaitUntil(reader.readRange, it) }
        val duration = number("2 seconds") ?: return null
        val unit = when (reader.take(Keyword.SECONDS, Keyword.MILLISECONDS)) {
            Keyword.SECONDS -> TimeUnit.SECONDS
            Keyword.MILLISECONDS -> TimeUnit.MILLISECONDS
            else -> return noTimeUnit(duration)
        }
        return Command.Wait(reader.readRange, duration, unit)
    }

    private fun noTimeUnit(duration: Expression): Nothing? {
        diagnostics.reportNoTimeUnit(reader, duration)
        return null
    }

    private fun reset(): Command? {
        reader.advance()
        if (reader.take(Keyword.MOTOR) != null) {
            return readMotor(reader, diagnostics)?.let { Command.ResetMotor(reader.readRange, it) }
        }
        return if (expect(Keyword.TIMER)) Command.ResetTimer(reader.readRange) else null
    }

    private fun clear(): Command? {
        reader.advance()
        return if (expect(Keyword.SCREEN)) Command.ClearScreen(reader.readRange) else null
    }

    private fun play(): Command? {
        reader.advance()
        val frequency = number("440 for 1 second") ?: return null
        val duration = seconds() ?: return null
        return Command.Play(reader.readRange, frequency, duration)
    }

    private fun show(): Command? {
        reader.advance()
        val text = reader.take(TokenKind.TEXT)
        if (text != null) {
            return Command.ShowText(reader.readRange, text.text.removeSurrounding("\""), text.range)
        }
        return number("5")?.let { Command.Show(reader.readRange, it) }
    }

    private companion object {
        val STARTS = DIRECTIONS + Keyword.TURNING
        val OF_MOTOR = MOTOR_COMMANDS + Keyword.POWER
    }
}
