package robotran.robolang.check

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.BrickSetting
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.LightSensorSetting
import robotran.robolang.syntax.NxtSensor
import robotran.robolang.syntax.RobotSetting
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.SensorSetting
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.allExpressions
import robotran.robolang.syntax.allStatements

/** Finds what the brick of the robot cannot do, and sensors that share a port. */
internal class BrickChecker(private val context: CheckContext, private val robot: BrickKind) {
    private val messages = context.messages
    private val settings = context.tree.robot?.settings.orEmpty()

    fun check() {
        val named = context.tree.robot?.brick
        if (named != null && named.kind != robot) {
            context.report(DiagnosticCode.WRONG_BRICK, named.range, messages.wrongBrick(named.kind, robot))
        }
        when (named?.kind ?: robot) {
            BrickKind.RCX -> checkForRcx()
            BrickKind.NXT -> checkPorts()
        }
    }

    private fun checkForRcx() {
        settings.forEach(::setting)
        allStatements(context.tree).forEach(::statement)
        allExpressions(context.tree).forEach(::expression)
    }

    private fun setting(setting: RobotSetting) {
        when (setting) {
            is BrickSetting -> Unit
            is LightSensorSetting -> port(setting.port, setting.range)

            is SensorSetting -> lacks(
                setting.range,
                when (setting.sensor) {
                    NxtSensor.SONAR -> messages.noSonar()
                    NxtSensor.COLOUR -> messages.noColourSensor()
                    NxtSensor.SOUND -> messages.noSoundSensor()
                },
            )
        }
    }

    private fun statement(statement: Statement) {
        // All that only an NXT does is about the degrees of its motors.
        if ((statement as? Command)?.form?.brick == BrickKind.NXT) lacks(statement.range, messages.noMotorDegrees())
    }

    private fun expression(expression: Expression) {
        if (expression is Expression.ColourLiteral) lacks(expression.range, messages.noColourSensor())
        if (expression !is Expression.Sense) return
        when (val sense = expression.sense) {
            Sense.Distance -> lacks(expression.range, messages.noSonar())
            Sense.Colour -> lacks(expression.range, messages.noColourSensor())
            Sense.Loudness -> lacks(expression.range, messages.noSoundSensor())
            is Sense.Turned -> lacks(expression.range, messages.noMotorDegrees())
            is Sense.Sensor -> port(sense.port, expression.range)
            is Sense.Button -> if (sense.button.kind != BrickKind.RCX) button(sense.button, expression.range)
            Sense.LeftBumper, Sense.RightBumper, Sense.Light, Sense.Timer, Sense.Battery -> Unit
        }
    }

    private fun button(button: BrickButton, range: SourceRange) {
        val fix = button.on(BrickKind.RCX)?.let { SourceFix(range, "button ${it.keyword.text}") }
        context.report(DiagnosticCode.BRICK_LACKS, range, messages.noNxtButton(), fix)
    }

    private fun port(port: Int, range: SourceRange) {
        val last = BrickKind.RCX.inputPorts
        if (port <= last) return
        val column = range.column + context.textOf(range).indexOfFirst { it in '0'..'9' }
        val number = range.copy(column = column, endColumn = column + 1)
        context.report(DiagnosticCode.PORT_OUT_OF_RANGE, number, messages.portOutOfRange(last))
    }

    private fun lacks(range: SourceRange, message: String) = context.report(DiagnosticCode.BRICK_LACKS, range, message)

    /** An NXT has one sensor on a port. */
    private fun checkPorts() {
        val ports = SensorPorts(context.tree, BrickKind.NXT)
        val uses = allExpressions(context.tree).filterIsInstance<Expression.Sense>()
            .mapNotNull { useOf(it, ports) }
            .sortedWith(compareBy({ it.range.line }, { it.range.column }))
        val first = mutableMapOf<Int, PortUse>()
        val taken = uses.map { it.port }.toSet()
        for (use in uses) {
            val earlier = first.getOrPut(use.port) { use }
            if (earlier.sense != use.sense) {
                val free = (1..BrickKind.NXT.inputPorts).firstOrNull { it !in taken } ?: use.port
                val example = settingOf(use.sense, free) ?: settingOf(earlier.sense, free).orEmpty()
                val one = context.textOf(earlier.range)
                val message = messages.portShared(one, context.textOf(use.range), use.port, example)
                return context.report(DiagnosticCode.PORT_SHARED, use.range, message)
            }
        }
    }

    /** What the program expects on a port where it says so, or where it reads what the header has there. */
    private class PortUse(val range: SourceRange, val port: Int, val sense: Sense)

    private fun useOf(expression: Expression.Sense, ports: SensorPorts): PortUse? {
        val port = ports.portOf(expression.sense) ?: return null
        val sense = if (expression.sense is Sense.Sensor) ports.settingAt(port) else expression.sense
        return sense?.let { PortUse(expression.range, port, it) }
    }

    /** The line of the header that puts the sensor of [sense] on [port]; null for a bumper, which has its place. */
    private fun settingOf(sense: Sense, port: Int): String? = when (sense) {
        Sense.Light -> "light sensor on $port facing down"
        Sense.Distance -> NxtSensor.SONAR.settingOn(port)
        Sense.Colour -> NxtSensor.COLOUR.settingOn(port)
        Sense.Loudness -> NxtSensor.SOUND.settingOn(port)
        else -> null
    }
}
