package robotran.robolang.check

import robotran.brick.kind.BrickKind
import robotran.hub.model.HubModel
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.microbit.model.MicrobitModel
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
import robotran.robolang.words.BrickDialect
import robotran.robolang.words.BrickFeature

/** Finds what the brick of the robot cannot do, and sensors that share a port. */
internal class BrickChecker(private val context: CheckContext, private val robot: BrickKind) {
    private val messages = context.messages
    private val settings = context.tree.robot?.settings.orEmpty()

    /** The one that the program is for. */
    private val brick =
        context.tree.robot?.brick?.kind?.takeIf { BrickDialect.of(it).keyword != BrickDialect.of(robot).keyword }
            ?: robot

    fun check() {
        val named = context.tree.robot?.brick
        if (named != null && BrickDialect.of(named.kind).keyword != BrickDialect.of(robot).keyword) {
            context.report(DiagnosticCode.WRONG_BRICK, named.range, messages.wrongBrick(named.kind, robot))
        }
        settings.forEach(::setting)
        allStatements(context.tree).forEach(::statement)
        allExpressions(context.tree).forEach(::expression)
        if (brick.sensorsOnPort == 1 && !BrickDialect.of(brick).asksRobot) checkPorts()
    }

    private fun setting(setting: RobotSetting) {
        when (setting) {
            is BrickSetting -> Unit
            is LightSensorSetting -> port(setting.port, setting.range)

            is SensorSetting -> need(setting.sensor.feature, setting.range)
        }
    }

    private fun statement(statement: Statement) {
        (statement as? Command)?.form?.needs?.let { need(it, statement.range) }
    }

    private fun expression(expression: Expression) {
        if (expression is Expression.ColourLiteral) need(BrickFeature.COLOUR_SENSOR, expression.range)
        if (expression !is Expression.Sense) return
        when (val sense = expression.sense) {
            Sense.Distance -> need(BrickFeature.SONAR, expression.range)
            Sense.Colour -> need(BrickFeature.COLOUR_SENSOR, expression.range)
            Sense.Loudness -> need(BrickFeature.SOUND_SENSOR, expression.range)
            is Sense.Turned -> need(BrickFeature.MOTOR_COUNTERS, expression.range)
            is Sense.Sensor -> port(sense.port, expression.range)
            is Sense.Button -> button(sense.button, expression.range)
            Sense.Battery -> need(BrickFeature.BATTERY, expression.range)
            Sense.LeftBumper, Sense.RightBumper, Sense.Light, Sense.Timer -> Unit
        }
    }

    private fun button(button: BrickButton, range: SourceRange) {
        val own = button.on(brick)
        if (own == button || (own != null && BrickDialect.of(brick).takesButtonsOfOthers)) return
        val fix = own?.let { SourceFix(range, "button ${it.keyword.text}") }
        context.report(DiagnosticCode.BRICK_LACKS, range, noButton(), fix)
    }

    private val isHub: Boolean get() = HubModel.of(brick) != null
    private val isBoard: Boolean get() = MicrobitModel.of(brick) != null

    private fun noButton(): String {
        val buttons = BrickButton.of(brick).map { "\"button ${it.keyword.text}\"" }
        return when {
            isHub -> messages.noSuchButton(buttons)
            isBoard -> messages.noSuchButtonOnBoard(buttons)
            else -> messages.noNxtButton()
        }
    }

    private fun port(port: Int, range: SourceRange) {
        val last = brick.inputPorts
        if (port <= last) return
        val column = range.column + context.textOf(range).indexOfFirst { it in '0'..'9' }
        val number = range.copy(column = column, endColumn = column + 1)
        context.report(DiagnosticCode.PORT_OUT_OF_RANGE, number, messages.portOutOfRange(last))
    }

    private fun need(feature: BrickFeature, range: SourceRange) {
        if (feature.isOn(brick)) return
        val message = when (feature) {
            BrickFeature.MOTOR_COUNTERS -> if (isBoard) messages.noWheelDegrees() else messages.noMotorDegrees()
            BrickFeature.SONAR -> messages.noSonar()
            BrickFeature.COLOUR_SENSOR -> if (isBoard) messages.noColourOnBuggy() else messages.noColourSensor()
            BrickFeature.SOUND_SENSOR -> noSound()
            BrickFeature.BATTERY -> messages.noBatteryOnBoard()
            BrickFeature.ENTER_BUTTON, BrickFeature.ESCAPE_BUTTON -> noButton()
        }
        context.report(DiagnosticCode.BRICK_LACKS, range, message)
    }

    private fun noSound(): String = when {
        isHub -> messages.noSoundSensorOnHub()
        isBoard -> messages.noMicrophone()
        else -> messages.noSoundSensor()
    }

    /** Two sensors cannot be on one port. */
    private fun checkPorts() {
        val ports = SensorPorts(context.tree, brick)
        val uses = allExpressions(context.tree).filterIsInstance<Expression.Sense>()
            .mapNotNull { useOf(it, ports) }
            .sortedWith(compareBy({ it.range.line }, { it.range.column }))
        val first = mutableMapOf<Int, PortUse>()
        val taken = uses.map { it.port }.toSet()
        for (use in uses) {
            val earlier = first.getOrPut(use.port) { use }
            if (earlier.sense != use.sense) {
                val free = (1..brick.inputPorts).firstOrNull { it !in taken } ?: use.port
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
